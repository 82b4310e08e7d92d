"""Links and pictures in the text of a lesson: where they lead, and whether that joins the site."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import unquote

from sim.pages.blocks.scene_block import Lesson
from sim.pages.site.effect_pages import EFFECTS, PLACE
from sim.pages.text.elsewhere import leads_elsewhere
from sim.pages.text.films import FILMS, OTHER_FILMS
from sim.pages.text.front_matter import Found
from sim.pages.text.lesson_places import JOINING, LESSONS, is_built
from sim.pages.text.raw_html import pictures_in_html

# As Markdown reads it: in <…>, or with brackets in pairs; a title in quotes may follow, up to the
# last of them. A bare one begins with no blank, so that each blank belongs to one part only: of a
# link that is never closed the search ends in its line.
_TARGET = (
    r"\([ \t]*\n?[ \t]*(?:<(?P<wrapped>[^<>\n]*)>"
    r"|(?P<bare>(?:[^()\s]|\([^()\n]*\))(?:[^()\n]|\([^()\n]*\))*?)|)"
    r"(?:[ \t]+(?:\"[^\n]*\"|'[^\n]*'))?[ \t]*\n?[ \t]*\)"
)
PICTURE = re.compile(rf"!\[([^\]\n]*)\]{_TARGET}")
_LINK = re.compile(rf"(?<!!)\[[^\]\n]+\]{_TARGET}")
_ON_THIS_COMPUTER = re.compile(r"[a-z]:[\\/]|file:|\\\\", re.IGNORECASE)  # C:\, C:/, \\server


def links(prose: str, lesson: Lesson) -> Iterator[Found]:
    """Links, pictures and films that lead to nothing, or to what does not join the site."""
    folder = lesson.scene_folders[0]
    found = (*_LINK.finditer(prose), *PICTURE.finditer(prose))
    written = ((link.start(), link["wrapped"] or link["bare"] or "") for link in found)
    for at, address in (*written, *pictures_in_html(prose)):
        target = unquote(address.split("#")[0].split("?")[0])
        if _ON_THIS_COMPUTER.match(target):
            hint = "put the file beside the lesson, and write its name alone: carts.png"
            yield at, "broken-link", f"“{target[:60]}” is on this computer alone", hint
            continue
        if not target or leads_elsewhere(target):
            continue
        place = next((one for one in _places(folder, target, lesson) if _is_there(one)), None)
        if place is None:
            hint = "look at the name, and from which folder it is counted"
            if "\\" in target:
                hint = f"write / between folders: {target[:60].replace(chr(92), '/')}"
            yield at, "broken-link", f"there is no file “{target[:60]}”", hint
        elif place.is_file() and not _joins(place, folder, lesson):
            message = f"“{target[:60]}” does not join the site: it stays in the folder of lessons"
            hint = f"what joins it there: .md {' '.join(JOINING)}"
            if place.suffix.lower() in OTHER_FILMS:
                hint = f"save the film as {' or '.join(FILMS)}, which every browser plays"
            yield at, "not-in-site", message, hint


def _is_there(place: Path) -> bool:
    try:
        return place.exists()
    except OSError:  # longer than any name
        return False


def _joins(place: Path, folder: Path, lesson: Lesson) -> bool:
    """Whether a file is one of the site; of the folder of lessons only some are."""
    lessons = Path(os.path.normpath(_root(folder, lesson) / LESSONS))
    lies = Path(os.path.normpath(place))
    if not lies.is_relative_to(lessons):
        return True
    return is_built(lies, lessons) if lies.suffix == ".md" else lies.suffix.lower() in JOINING


def _root(folder: Path, lesson: Lesson) -> Path:
    """The folder that the lesson's name is counted from; `folder`: its own, or the original's of a
    translation, which is named as a page one folder further down."""
    names = Path(lesson.file).parts[:-1]
    depths = range(min(len(names), len(folder.parents)), 0, -1)
    above = (folder.parents[i - 1] for i in depths if folder.parts[-i:] == names[:i])
    return next(above, folder)


def _places(folder: Path, target: str, lesson: Lesson) -> Iterator[Path]:
    """Where a link may lead: beside the lesson, or where the site puts lessons and pages."""
    source = re.sub(r"\.html$", ".md", target)
    yield folder / source
    yield folder / target
    root = _root(folder, lesson)
    inside = folder.relative_to(root).as_posix().removeprefix("docs").strip("/")
    address = os.path.normpath(f"{inside}/{source}").lstrip("/")
    yield root / address
    yield root / "docs" / address
    if lesson.file.startswith(EFFECTS):  # the pages of effects join the docs at their place
        yield from (root / "docs" / PLACE / source, folder.parent / Path(source).stem / "page.md")
    elif Path(address).parent.as_posix() == PLACE.strip("/"):
        yield root / EFFECTS / Path(source).stem / "page.md"
