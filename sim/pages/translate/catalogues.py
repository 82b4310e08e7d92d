"""Which catalogues a folder of lessons has, and which pages they make.

worksheets/words/LANGUAGE/LESSON.po         of a lesson
worksheets/words/LANGUAGE/banks/BANK.po     of a bank of questions
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from sim.pages.language import ENGLISH, LANGUAGES
from sim.pages.text.lesson_places import BANK_FOLDER, is_hidden

FOLDER = "words"
OTHERS = tuple(language for language in LANGUAGES if language != ENGLISH)


@dataclass(frozen=True, slots=True)
class Source:
    """A lesson or a bank, its catalogue in a language, and the page of its own that it would be."""

    path: Path
    catalogue: Path
    language: str
    page: Path

    @property
    def by_hand(self) -> bool:
        """Whether somebody wrote the translation as a file: then no other is made."""
        return self.page.is_file()


def is_bank(path: Path) -> bool:
    """Whether the file is a bank of questions, and no lesson."""
    return path.parent.name == BANK_FOLDER


def lessons_folder(path: Path) -> Path:
    """The folder of lessons that a lesson or a bank lies in."""
    return path.parent.parent if is_bank(path) else path.parent


def source_of(path: Path, folder: Path, language: str) -> Source:
    """Of the lesson or bank at `path` in the folder of lessons."""
    inside = path.relative_to(folder)
    catalogue = folder / FOLDER / language / inside.with_suffix(".po")
    return Source(path, catalogue, language, folder / language / inside)


def catalogues_in(folder: Path) -> Iterator[Source]:
    """Every catalogue of a lesson or a bank that is there, language by language."""
    for language in OTHERS:
        place = folder / FOLDER / language
        for catalogue in sorted(place.rglob("*.po")):
            inside = catalogue.relative_to(place)
            if is_hidden(inside):
                continue
            suffix = ".yml" if inside.parts[0] == BANK_FOLDER else ".md"
            yield source_of(folder / inside.with_suffix(suffix), folder, language)
