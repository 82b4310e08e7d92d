"""The text of a lesson in each language that it can be had in."""

from __future__ import annotations

from pathlib import Path

from sim.pages.blocks.scene_block import Lesson
from sim.pages.text.author_text import author_text
from sim.pages.text.lesson_places import described, shown
from sim.pages.translate.catalogues import lessons_folder
from sim.pages.translate.translation import translations_of


def in_languages(path: Path, root: Path) -> dict[str, tuple[str, Lesson]]:
    """By language its text and how its blocks are read; "" is as its author wrote it.

    Raises `AuthorError` where a catalogue cannot be read.
    """
    found = {"": (author_text(path, shown(path, root)), described(path, root))}
    for one in translations_of(path, lessons_folder(path), root):
        found[one.source.language] = (one.lesson.made.text, one.described(root))
    return found
