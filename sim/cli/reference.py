"""The page of all commands, written from their help: docs/reference/commands.md.

python -m sim.cli.reference > docs/reference/commands.md
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import click

from sim.cli import COMMANDS, main

HEAD = """\
---
title: Every command
description: The command carts, from a new site to a zip, and for scenes in the terminal.
---

# Every command

<!-- Written by `python -m sim.cli.reference`: change the help texts in sim/cli instead. -->

`carts NAME --help` says the same. Exit codes: 0 fine, 1 something was found, 2 the call was wrong.
In a checkout of the project the command is `.venv/bin/carts`; `python -m sim` works everywhere.

| command | |
|---|---|
"""


def reference() -> str:
    """The page."""
    rows = [f"| [`carts {name}`](#{name}) | {COMMANDS[name][1]} |" for name in sorted(COMMANDS)]
    return HEAD + "\n".join(
        [*rows, "", *(line for name in sorted(COMMANDS) for line in _one(name))]
    )


def _one(name: str) -> Iterator[str]:
    context = click.Context(main)
    command = main.get_command(context, name)
    assert command is not None
    text = (command.help or "").replace("\b\n", "")
    paragraphs = [
        paragraph for paragraph in re.split(r"\n\s*\n", text.strip()) if paragraph.strip()
    ]
    examples = [p for p in paragraphs if p.strip().startswith(("carts ", "echo "))]
    yield from (f"## {name} {{ #{name} }}", "")
    for paragraph in paragraphs:
        if paragraph not in examples:
            yield from (_plain(" ".join(paragraph.split())), "")
    if examples:
        lines = [line.strip() for paragraph in examples for line in paragraph.splitlines()]
        yield from ("```text", *lines, "```", "")
    options = [p for p in command.params if isinstance(p, click.Option) and p.help]
    if options:
        yield from ("| option | |", "|---|---|")
        inside = click.Context(command, parent=context)
        for option in options:
            record = option.get_help_record(inside)
            if record:
                yield f"| `{record[0].replace('|', ' or ')}` | {_plain(record[1])} |"
        yield ""


def _plain(text: str) -> str:
    return re.sub(r"([<>*_|\[\]])", r"\\\1", " ".join(text.split()))


if __name__ == "__main__":
    print(reference(), end="")
