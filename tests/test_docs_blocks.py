"""Every block of code in the documentation is what it says: it parses, and what it calls exists."""

from __future__ import annotations

import ast
import json
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import click
import pytest
import yaml

from sim.cli import COMMANDS, main
from sim.cli.reference import reference
from sim.pages.checks.lessons import check_paths
from sim.pages.runtime.node import node_program
from tests.shell_lines import called, options_exist

ROOT = Path(__file__).parents[1]
TEXTS = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md"), *ROOT.glob("worksheets/*.md")])
OURS = {
    "scene",
    "question",
    "quiz",
    "map",
    "cost",
    "hard-cases",
    "evidence",
    "measured",
    "challenge",
    "law",
    "picture",
}
SHOWN_AS_IT_IS = {"text", "markdown", "csv", "html"}  # output, lessons (their blocks are found too)


def blocks() -> Iterator[tuple[str, str, str]]:
    """Place, language and text of every fenced block."""
    for path in TEXTS:
        text = path.read_text(encoding="utf-8")
        for found in re.finditer(r"^( *)(```+) *([a-z-]*)[^\n]*\n(.*?)^\1\2 *$", text, re.M | re.S):
            place = (
                f"{path.relative_to(ROOT).as_posix()}:{text.count(chr(10), 0, found.start()) + 1}"
            )
            indent = len(found[1])
            yield (
                place,
                found[3],
                "".join(line[indent:] for line in found[4].splitlines(keepends=True)),
            )


ALL = list(blocks())


def of(*languages: str) -> list[tuple[str, str]]:
    return [(place, text) for place, language, text in ALL if language in languages]


def test_every_block_says_what_it_is() -> None:
    known = OURS | SHOWN_AS_IT_IS | {"sh", "yaml", "json", "python", "js", "jinja"}
    assert [(place, language) for place, language, _ in ALL if language not in known] == []


@pytest.mark.parametrize(("place", "text"), of("sh"), ids=lambda one: one[:40])
def test_every_line_for_a_shell_calls_what_exists(place: str, text: str) -> None:
    for line in text.splitlines():
        if line.strip() and not line.startswith("#"):
            called(line)


WHOLE = [(place, text) for place, text in of("markdown") if text.startswith("---\ntitle")]


@pytest.mark.parametrize(("place", "text"), WHOLE, ids=lambda one: one[:40])
def test_a_whole_lesson_in_the_texts_has_no_mistakes(place: str, text: str, tmp_path: Path) -> None:
    path = tmp_path / "lesson.md"
    path.write_text(text, encoding="utf-8")
    assert check_paths([path], tmp_path) == [], place


def test_the_first_lesson_is_told_whole_with_a_question_that_is_marked() -> None:
    (text,) = [text for place, text in WHOLE if place.startswith("docs/teachers/first-lesson.md")]
    for part in ("predict:", "type: single", "correct: true", "type: long"):
        assert part in text


def test_the_pages_for_teachers_write_every_command_in_one_way() -> None:
    """Who installed a wheel has no .venv; how a copy of the project calls it is told once."""
    elsewhere = [
        path.name
        for path in (ROOT / "docs" / "teachers").glob("*.md")
        for _ in re.findall(r"\.venv/bin/carts", path.read_text(encoding="utf-8"))
    ]
    assert elsewhere == ["install.md"]


def test_every_call_of_ours_in_the_texts_exists() -> None:
    for path in TEXTS:
        text = path.read_text(encoding="utf-8")
        for call in re.findall(r"`(?:\.venv/bin/)?carts ([a-z][^`\n]*)`", text):
            words = call.replace("…", "").split()
            assert words[0] in COMMANDS, (path.name, call)
            options_exist([word for word in words if not re.search(r"[\"'\[]", word)])


@pytest.mark.parametrize("name", sorted(COMMANDS))
def test_the_help_of_every_command_has_examples_that_work(name: str) -> None:
    command = main.get_command(click.Context(main), name)
    assert command is not None
    text = command.get_help(click.Context(command, info_name=f"carts {name}"))
    usage, _, rest = text.partition("\n")
    assert usage.startswith("Usage: ")
    examples = re.findall(rf"^ +(carts {name}\b.*?)(?:   .*)?$", rest, re.M)
    assert examples, name
    for example in examples:
        called(example.partition(" > ")[0])


def test_the_reference_of_the_commands_is_what_they_say_of_themselves() -> None:
    page = (ROOT / "docs" / "reference" / "commands.md").read_text(encoding="utf-8")
    assert page == reference(), "python -m sim.cli.reference writes the page"


class _AnyTag(yaml.SafeLoader):
    pass


_AnyTag.add_multi_constructor("", lambda *_: None)


def test_every_block_of_data_or_python_can_be_read() -> None:
    assert of("yaml")
    for place, text in of("yaml"):
        values = list(yaml.load_all(text, _AnyTag))
        assert all(isinstance(value, (dict, list, type(None))) for value in values), place
    for _, text in of("json"):
        json.loads(text)
    for _, text in of("python"):
        ast.parse(text)


def test_every_javascript_block_is_javascript(tmp_path: Path) -> None:
    for number, (place, text) in enumerate(of("js")):
        file = tmp_path / f"{number}.mjs"
        file.write_text(text, encoding="utf-8")
        done = subprocess.run(
            [str(node_program()), "--check", str(file)], capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, (place, done.stderr)
