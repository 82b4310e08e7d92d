"""Reading the scene that a command was given: a file, one of a lesson, or - for standard input."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import click

from sim.cli.named_file import bytes_of
from sim.cli.scene_of_lesson import scene_in
from sim.pages.blocks.law_files import with_law_files
from sim.pages.blocks.scene_block import SceneBlock, read_scene_text
from sim.pages.findings import AuthorError, Finding
from sim.pages.text.author_text import decoded
from sim.pages.text.plain_lines import lines_of
from sim.pages.text.yaml.source import MAX_CHARACTERS
from sim.scene import Scene, SceneError, read_fence
from sim.scene.fence.presentation import Fence
from sim.scene.problem import Problem

if TYPE_CHECKING:
    from sim.dynamics.result.outcome import UnsolvedError

OF_LESSON = re.compile(r"(?P<lesson>.+\.md)(?:#(?P<id>.*))?")
"""A lesson, and after # which of its scenes."""

MOST_BYTES = 4 * MAX_CHARACTERS
"""Never read more: a path may lead to a film, or to a device without an end."""


def read(name: str, laws: Mapping[str, str] | None = None) -> Scene:
    """The scene in the file `name`. Problems go to standard error, and the command ends with 1.

    Keys that say how a lesson shows the scene (id, show, controls …) may stand there as well, and
    are looked at as `carts check` does. `laws`: texts of laws that need no file beside it.
    """
    return read_shown(name, laws).scene


def read_shown(name: str, laws: Mapping[str, str] | None = None) -> Fence:
    """The scene with those keys; problems as above."""
    shown, of_lesson = shown_name(name), OF_LESSON.fullmatch(name)
    folder = Path.cwd() if name == "-" else Path(name).parent
    try:
        if of_lesson:
            bytes_of(of_lesson["lesson"], 0, "a scene file")  # is there, or says so
            return _in_lesson(of_lesson, laws).fence
        plain, places = read_scene_text(without_fence(text_of(name)), shown)
        return read_fence(with_law_files(plain, [folder], laws), named=False)
    except AuthorError as error:
        fail(error.findings)
    except SceneError as error:
        fail(map(places.finding, error.problems))


def _in_lesson(named: re.Match[str], laws: Mapping[str, str] | None = None) -> SceneBlock:
    lesson = named["lesson"]
    return scene_in(Path(lesson), named["id"], Path.cwd(), f"{lesson}#", laws)


def unsolved(name: str, error: UnsolvedError) -> NoReturn:
    """Say that the scene that was read cannot be solved: at its block, where a lesson has it."""
    place = Finding(shown_name(name), 1, 1, "unsolved", error.message, error.hint)
    if of_lesson := OF_LESSON.fullmatch(name):
        problem = Problem((), place.code, place.message, place.hint)
        place = _in_lesson(of_lesson).places.finding(problem)
    fail([place])


def shown_name(name: str) -> str:
    """What messages call the file."""
    return "stdin" if name == "-" else name


def fail(findings: Iterable[Finding]) -> NoReturn:
    """Print to standard error in the order of the file's lines, and end with exit code 1."""
    for finding in sorted(findings):
        click.echo(str(finding), err=True)
    sys.exit(1)


def without_fence(text: str) -> str:
    """A block as a page copies it, between ```scene and ```: the same lines, those two empty."""
    lines = lines_of(text.rstrip())
    if len(lines) > 1 and lines[0].strip() == "```scene" and lines[-1].strip() == "```":
        return "\n".join(["", *lines[1:-1], ""])
    return text


def text_of(name: str, thing: str = "scene") -> str:
    """The text of a file, or of standard input; `thing`: what stands in it."""
    shown = shown_name(name)
    data = bytes_of(name, MOST_BYTES, f"a {thing} file")
    if len(data) == MOST_BYTES:
        what = f"this is more than a {thing} can be"
        hint = f"a {thing} is short: is this the right file?"
        fail([Finding(shown, 1, 1, "too-long", what, hint)])
    try:
        return decoded(data, shown)
    except AuthorError as error:
        fail(error.findings)
