"""Where a lesson looks for the scenes, laws and banks that it names."""

from __future__ import annotations

import posixpath
from pathlib import Path

from sim.pages.blocks.scene_block import Lesson
from sim.pages.findings import SiteError
from sim.pages.language import LANGUAGES
from sim.pages.site.effect_pages import SCENES
from sim.pages.text.films import FILMS

SCENE_FOLDERS = ("worksheets/scenes", "tests/scenes")
BANK_FOLDER = "banks"
LESSONS = "worksheets"
"""The folder of lessons. Commands read them from there, so a site can name no other."""

JOINING = (".png", ".jpg", ".jpeg", ".gif", ".webp", ".svg", ".pdf", *FILMS)
"""What joins the site from a folder of lessons beside them. Other files may be for teachers alone:
banks hold keys, tables hold names."""


def check_folder(name: str) -> None:
    """Raises `SiteError` where mkdocs.yml names another folder of lessons than there is."""
    if posixpath.normpath(name.replace("\\", "/")) != LESSONS:
        raise SiteError(
            f"mkdocs.yml: error: carts: lessons: {name}: lessons are read from {LESSONS}/ alone\n"
            f"  hint: call the folder {LESSONS} and remove the line"
        )


def described(lesson: Path, root: Path) -> Lesson:
    """The lesson in a file, as its blocks are read; messages name it from `root`."""
    return Lesson(shown(lesson, root), scene_folders(lesson, root), bank_folders(lesson, root))


def is_built(lesson: Path, folder: Path) -> bool:
    """Whether a page is made of a lesson: it lies in the folder of lessons, or in a language's."""
    return lesson.parent in (folder, *(folder / language for language in LANGUAGES))


def page_of(name: str) -> str:
    """The address of the page that the generator makes of the Markdown file at `name`: README.md is
    the first page of its folder."""
    folder, file = posixpath.split(name)
    stem = file.rpartition(".")[0]
    return posixpath.join(folder, f"{'index' if stem == 'README' else stem}.html")


def is_hidden(inside: Path) -> bool:
    """Whether a file of a folder, by its path in it, is there for a program alone: what begins with
    a dot (`._lesson.md` lies beside lesson.md on a stick that was in a Mac), and packages."""
    return any(part.startswith(".") or part == "node_modules" for part in inside.parts)


def shown(path: Path, root: Path) -> str:
    """A path as messages show it."""
    return (path.relative_to(root) if path.is_relative_to(root) else path).as_posix()


def scene_folders(lesson: Path, root: Path) -> tuple[Path, ...]:
    """Where a lesson's `file: NAME.yml` is looked for, in this order."""
    return (
        lesson.parent,
        *(root / folder for folder in SCENE_FOLDERS),
        *sorted(root.glob(SCENES)),
    )


def bank_folders(lesson: Path, root: Path) -> tuple[Path, ...]:
    """Where the banks of a lesson's forms are looked for, in this order."""
    return (lesson.parent / BANK_FOLDER, root / "worksheets" / BANK_FOLDER)
