"""Lists that the page would print as running text, or beside the list that they belong into."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice

_ITEM = re.compile(r"[ \t]*(?:[-*+]|(?P<number>\d{1,3})\.)[ \t]+\S")
_LEVEL = 4  # spaces for each list inside another
_LONGEST = 200  # items that somebody writes
_PRINTED = "this list would be printed as running text"
Told = tuple[int, str, str, str]  # place in the text, code, message, hint


@dataclass(frozen=True, slots=True)
class Line:
    """One line of a lesson, and where in its text it begins."""

    at: int
    text: str

    @property
    def indent(self) -> int:
        """Columns before its first letter."""
        line = self.text.expandtabs(_LEVEL)
        return len(line) - len(line.lstrip())

    @property
    def start(self) -> int:
        """The place of its first letter."""
        return self.at + len(self.text) - len(self.text.lstrip())

    @property
    def item(self) -> str:
        """Of an item of a list its mark: a number, or “-” for every other; empty: it is none."""
        found = _ITEM.match(self.text)
        return (found["number"] or "-") if found else ""

    @property
    def level(self) -> int:
        """How many lists Markdown takes it to be inside of."""
        return self.indent // _LEVEL

    def is_like(self, other: Line) -> bool:
        """Whether both are of one list: both with numbers, or both without."""
        return (self.item == "-") == (other.item == "-")


def list_slips(pieces: Iterable[list[Line]]) -> Iterator[Told]:
    """Where each begins, one in a piece, with what is told of it. An empty piece: a heading or a
    box stands between the others."""
    last: Line | None = None  # item of the piece above
    for piece in pieces:
        items = [line for line in piece if line.item]
        if items and piece[0].item:
            yield from islice(_inside(piece, items, last), 1)
        elif items and _is_list(piece, items):
            yield items[0].start, "no-list", _PRINTED, "leave an empty line above it"
        last = items[-1] if items and piece[0].item else None


def _inside(piece: Sequence[Line], items: Sequence[Line], last: Line | None) -> Iterator[Told]:
    """Items of a list that were meant to be inside another one. `last`: item above this piece."""
    above = last
    for k, item in enumerate(items[:_LONGEST]):
        if above:
            beside = item.level == above.level and item.indent >= above.indent + 2
            hint = f"begin each of its lines with {_LEVEL * (above.level + 1)} spaces"
            if item.level > above.level + 1 and above is not last:  # else it is code
                yield item.start, "no-list", _PRINTED, hint
            elif beside and (item.is_like(above) or above is last):
                told = "this list would stand beside the line above, not inside it"
                yield item.start, "no-list", told, hint
            elif item.level == above.level and above is not last and not item.is_like(above):
                if _is_list(piece, [one for one in items[k:] if one.is_like(item)]):
                    yield item.start, "no-list", _PRINTED, hint
                continue  # to Markdown it is text of the item above
        above = item


def _is_list(piece: Sequence[Line], items: Sequence[Line]) -> bool:
    """Whether these lines below others were meant as a list, and not one of them as a minus, a dash
    or a year that a line happens to begin with."""
    above = piece[piece.index(items[0]) - 1].text.rstrip().endswith((":", "："))
    numbers = [int(item.item) for item in items if item.item != "-"]
    if numbers:
        return numbers[0] == 1 and (above or numbers[1:2] == [2])
    return above or len(items) > 1
