"""From the text of a lesson and words of another language to the lesson in that language.

Characters are put in the place of characters: what has no translation stays, byte for byte.
"""

from __future__ import annotations

import json
from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from sim.pages.teach.pieces import Lines
from sim.pages.text.fence_scan import Block, after_front_matter, meant_kind, scan
from sim.pages.text.plain_lines import lines_of
from sim.pages.translate.block_units import block_units
from sim.pages.translate.catalogues import is_bank
from sim.pages.translate.markdown_units import markdown_units
from sim.pages.translate.unit import Unit


@dataclass(frozen=True, slots=True)
class Span:
    """Where a unit stands in the text with its translation: lines and columns from 1."""

    first: int
    end: tuple[int, int]
    unit: Unit


@dataclass(frozen=True, slots=True)
class PutIn:
    """A text with translations in it.

    `units`: all that the source has, in order; `open`: those without a translation.
    """

    text: str
    spans: tuple[Span, ...]
    units: tuple[Unit, ...]
    open: tuple[Unit, ...]

    def unit_at(self, line: int, col: int) -> Unit | None:
        """What stands there or next; behind the last of a line that one rather than a later."""
        k = bisect_left(self.spans, (line, col), key=lambda span: span.end)
        later = k == len(self.spans) or self.spans[k].first > line
        if k and later and self.spans[k - 1].end[0] == line:
            k -= 1
        return self.spans[k].unit if k < len(self.spans) else None


@lru_cache(maxsize=64)  # one text is put into several languages
def lesson_units(text: str) -> tuple[Unit, ...]:
    """The units of a lesson, in their order."""
    lines = Lines.of(text)
    top = after_front_matter(lines.lines)
    blocks = list(scan(lines.lines))
    units: list[Unit] = []
    if top:
        body = "\n".join(lines.lines[1 : top - 1])
        units += block_units(text, Block("top", "", 0, top, "", body, 0, closed=True), "top")
    for block in blocks:
        units += block_units(text, block, meant_kind(block.name) or "")
    taken = {k for block in blocks for k in range(block.start, block.end)}
    around = ["" if k in taken else line for k, line in enumerate(lines.lines)]
    units += markdown_units(around, lines.starts, top)
    return tuple(sorted(units, key=lambda unit: unit.start))


@lru_cache(maxsize=16)
def bank_units(text: str) -> tuple[Unit, ...]:
    """The units of a bank of questions."""
    count = len(lines_of(text))
    block = Block("bank", "", -1, count + 1, "", text, 0, closed=True)
    return tuple(block_units(text, block, "bank"))


def units_of(path: Path, text: str) -> tuple[Unit, ...]:
    """The units of the lesson or the bank at `path`, whose text this is."""
    return bank_units(text) if is_bank(path) else lesson_units(text)


def put_in(text: str, units: Sequence[Unit], words: Mapping[str, str]) -> PutIn:
    """The text with what `words` say in the place of each unit that they know."""
    parts: list[str] = []
    spans: list[Span] = []
    line, col, done = 1, 1, 0
    for unit in units:
        before = text[done : unit.start]
        said = _written(unit, words[unit.text]) if unit.text in words else None
        made = text[unit.start : unit.end] if said is None else said
        first, col = _behind(before, line, col)
        line, col = _behind(made, first, col)
        spans.append(Span(first, (line, col), unit))
        done = unit.end
        parts += [before, made]
    left = tuple(unit for unit in units if unit.text not in words)
    return PutIn("".join([*parts, text[done:]]), tuple(spans), tuple(units), left)


def _behind(text: str, line: int, col: int) -> tuple[int, int]:
    """Line and column behind a text that begins there."""
    ends = text.count("\n")
    return line + ends, len(text) - text.rfind("\n") if ends else col + len(text)


def _written(unit: Unit, said: str) -> str:
    if unit.form == "yaml":  # JSON's way to write a text is one of YAML's
        return json.dumps(said, ensure_ascii=False)
    return said.strip().replace("\n", f"\n{unit.indent}")


def units_alike(units: Sequence[Unit]) -> Iterator[tuple[str, tuple[Unit, ...]]]:
    """Each text once, in order, with all the places where it stands."""
    found: dict[str, list[Unit]] = {}
    for unit in units:
        found.setdefault(unit.text, []).append(unit)
    yield from ((text, tuple(places)) for text, places in found.items())
