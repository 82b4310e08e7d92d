"""Lines of a shell, as documentation and workflows have them: what they call exists."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import click

from sim.cli import COMMANDS, main

ROOT = Path(__file__).parents[1]
MAKEFILE = (ROOT / "Makefile").read_text(encoding="utf-8")
PROGRAMS = re.compile(r"^(?:\.venv/bin/)?(carts|make|pip|cd|python|mkdocs) ?(.*)$")


def called(line: str) -> None:
    """What a line of a shell calls must exist."""
    match = PROGRAMS.match(line)
    assert match, f"an unknown program: {line}"
    program, words = match[1], shlex.split(match[2], comments=True)
    if program == "make":
        for word in words:
            assert "=" in word or re.search(rf"^{word}:", MAKEFILE, re.M), line
    elif program == "carts":
        options_exist(words)


def options_exist(words: list[str]) -> None:
    if words[0].startswith("-"):
        return
    assert words[0] in COMMANDS, words
    command = main.get_command(click.Context(main), words[0])
    assert command is not None
    known = {name for parameter in command.params for name in parameter.opts} | {"--help"}
    known |= {name for parameter in command.params for name in parameter.secondary_opts}
    given = {word.partition("=")[0] for word in words[1:] if word.startswith("--")}
    assert given <= known, words
