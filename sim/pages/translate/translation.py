"""A lesson in another language, made of its text and a catalogue; and what is wrong with it.

The page of it is a lesson like any other, at the address that a translation by hand would have: its
answers lie in the same place when somebody writes it by hand later.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from urllib.parse import unquote

from sim.pages.blocks.scene_block import Lesson
from sim.pages.findings import Finding
from sim.pages.text.author_text import author_text, shown_here
from sim.pages.text.elsewhere import leads_elsewhere
from sim.pages.text.fence_scan import after_front_matter
from sim.pages.text.lesson_places import BANK_FOLDER, described, shown
from sim.pages.text.plain_lines import without_code
from sim.pages.translate.catalogues import OTHERS, Source, is_bank, source_of
from sim.pages.translate.po_file import Words, read_words
from sim.pages.translate.put_in import PutIn, put_in, units_of

_LINK = re.compile(
    r"(?:\]\(|^\[[^\]^\n][^\]\n]*\]:[ \t]+|\b(?:src|href)=\")"
    r"(?:<(?P<wrapped>[^<>\n]+)>|(?P<bare>[^)\s\"](?:[^)\"\n]*[^)\s\"])?))",
    re.MULTILINE,
)
_FROM_THE_SITE = ("/", "#", "?")
"""So begins an address that is not counted from the folder of the page."""


@dataclass(frozen=True, slots=True)
class Part:
    """A lesson or a bank with the words of its catalogue in it. `file`: as findings name it."""

    source: Source
    words: Words
    made: PutIn
    file: str

    def finding(self, found: Finding) -> Finding:
        """The same in the catalogue, where its translation stands there."""
        # What is wrong with a table stands at its name, above its texts.
        unit = self.made.unit_at(found.line, found.col)
        if unit is None or unit.text not in self.words.words:
            return replace(found, file=self.words.file, line=1, col=1)
        message = f"{found.message} (at the translation of “{unit.text[:60]}”)"
        line = self.words.place(unit.text)
        return replace(found, file=self.words.file, line=line, col=1, message=message)


@dataclass(frozen=True, slots=True)
class Translation:
    """A lesson in another language, with the banks that its forms draw from."""

    lesson: Part
    banks: Mapping[Path, Part] = field(default_factory=dict)

    @property
    def source(self) -> Source:
        """Where it all comes from."""
        return self.lesson.source

    def changed(self, beside: Iterable[Path]) -> float:
        """When a file that it is made of was last changed, in seconds as files tell it; `beside`:
        files that it may name, scenes and data."""
        parts = (self.lesson, *self.banks.values())
        files = [path for one in parts for path in (one.source.path, one.source.catalogue)]
        files += [path for path in beside if path.name in self.lesson.made.text]
        return max(path.stat().st_mtime for path in files)

    @property
    def draft(self) -> bool:
        """Whether nobody who teaches has said yet that it was read."""
        return self.lesson.words.draft

    def described(self, root: Path) -> Lesson:
        """The lesson as its blocks are read; the folders are those of the original."""
        texts = {path: bank.made.text for path, bank in self.banks.items()}
        return replace(described(self.source.path, root), file=self.lesson.file, texts=texts)

    def finding(self, found: Finding) -> Finding:
        """What is wrong on the page, at its place in a catalogue."""
        parts = (self.lesson, *self.banks.values())
        part = next((part for part in parts if part.file == found.file), None)
        return part.finding(found) if part else found

    def reporting(self, report: Callable[[Finding], None]) -> Callable[[Finding], None]:
        """A report of what is found in `page`."""

        def told(found: Finding) -> None:
            own = found.file == self.lesson.file
            there = replace(found, line=self._line(found.line)) if own else found
            report(self.finding(there))

        return told

    def counted(self, items: Collection[str] = ()) -> tuple[int, int]:
        """How many texts are still in English, and how many there are; `items`: those of forms."""
        banks = [bank.made for bank in self.banks.values()]
        open_, all_ = (
            {unit.text for unit in own}
            | {unit.text for bank in others for unit in bank if unit.item in items}
            for own, others in (
                (self.lesson.made.open, [bank.open for bank in banks]),
                (self.lesson.made.units, [bank.units for bank in banks]),
            )
        )
        return len(open_), len(all_)

    def page(self, siblings: Collection[str]) -> str:
        """The Markdown of the page. `siblings`: names of lessons that have a page beside it."""
        text = _moved_links(self.lesson.made.text, siblings)
        own = f"language: {self.source.language}"
        lines = text.split("\n")
        top = after_front_matter(lines)
        if top:
            return "\n".join([*lines[: top - 1], own, *lines[top - 1 :]])
        return "\n".join(["---", own, "---", *lines])

    def _line(self, line: int) -> int:
        """The line of the text without what `page` adds in front; lines count from 1."""
        top = after_front_matter(self.lesson.made.text.split("\n"))
        return line - 3 if not top else line - 1 if line > top else line


def part_of(source: Source, root: Path) -> Part:
    """A lesson or a bank with its catalogue; raises `AuthorError` for one that cannot be read."""
    text = author_text(source.path, shown(source.path, root))
    words = read_words(source.catalogue, shown(source.catalogue, root))
    made = put_in(text, units_of(source.path, text), words.words)
    bank = is_bank(source.path)  # named as the form that draws from it does
    file = shown_here(source.path) if bank else shown(source.page, root)
    return Part(source, words, made, file)


def translations_of(path: Path, folder: Path, root: Path) -> Iterator[Translation]:
    """The lesson at `path` in each language that it has a catalogue of and no file by hand.

    One in which nothing is translated is none. Raises `AuthorError`.
    """
    for language in OTHERS:
        source = source_of(path, folder, language)
        if source.catalogue.is_file() and not source.by_hand:
            part = part_of(source, root)
            if part.words.words:
                yield Translation(part, dict(_banks(part, folder, root)))


def _banks(lesson: Part, folder: Path, root: Path) -> Iterator[tuple[Path, Part]]:
    """The banks that a lesson names."""
    for path in sorted((folder / BANK_FOLDER).glob("*.y*ml")):
        source = source_of(path, folder, lesson.source.language)
        if path.name in lesson.made.text and source.catalogue.is_file():
            yield path, part_of(source, root)


def _moved_links(text: str, siblings: Collection[str]) -> str:
    """The text one folder further down: links lead to where they led, or to the same language."""
    for link in reversed(list(_LINK.finditer(without_code(text)))):
        own = "wrapped" if link["wrapped"] else "bare"
        target = unquote(link[own].partition("#")[0])
        stays = leads_elsewhere(link[own]) or link[own].startswith(_FROM_THE_SITE)
        if not stays and target not in siblings:
            text = f"{text[: link.start(own)]}../{text[link.start(own) :]}"
    return text
