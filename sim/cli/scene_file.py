"""Reading the scene that a command was given: a file, or `-` for standard input."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import NoReturn

import click

from sim.pages.yaml_source import Source, YamlError, load
from sim.scene import Problem, Scene, SceneError, read_scene
from sim.scene.presentation import FENCE_KEYS


def read(name: str) -> Scene:
    """The scene in the file `name`. Problems go to standard error, and the command ends with 1.

    Keys that say how a lesson shows the scene (id, show, controls …) are allowed and left aside.
    """
    text = _text(name)
    shown = "stdin" if name == "-" else name
    try:
        source = load(text)
    except YamlError as error:
        fail(_line(shown, error.line, error.col, error.message, error.hint))
    plain = {key: value for key, value in source.plain.items() if key not in FENCE_KEYS}
    try:
        return read_scene(plain)
    except SceneError as error:
        fail("\n".join(_placed(shown, source, problem) for problem in error.problems))


def fail(message: str) -> NoReturn:
    """Print to standard error and end with exit code 1: standard output stays empty."""
    click.echo(message, err=True)
    sys.exit(1)


def _text(name: str) -> str:
    if name == "-":
        return sys.stdin.read()
    path = Path(name)
    if not path.is_file():
        raise click.UsageError(f"There is no file “{name}”.")
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        fail(_line(name, 1, 1, "this file is not text in UTF-8", "save it as UTF-8"))


def _placed(name: str, source: Source, problem: Problem) -> str:
    at_key = problem.code.startswith("unknown-") or problem.code == "bad-name"
    line, col = (source.key_place if at_key else source.place)(problem.path)
    return _line(name, line, col, f"{problem.where}: {problem.message}", problem.hint)


def _line(name: str, line: int, col: int, message: str, hint: str) -> str:
    text = f"{name}:{line}:{col}: error: {message}"
    return f"{text}\n  hint: {hint}" if hint else text
