"""Where the boxes of an interaction diagram stand.

No three boxes stand in a line, so that every link can be seen. Lengths in pixels of a picture that
is 320 wide: on the smallest phones it is shown at 0.9 of that, and a box is then still 44 high.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from unicodedata import east_asian_width

WIDTH, BOX = 320, 50  # of the picture; height of a box
LETTER, ROOM = 7.8, 24  # width of an average letter, and what a box has beside its name
LEFT, MIDDLE, RIGHT = 68, 160, 252
PLACES: dict[int, Sequence[tuple[int, int]]] = {
    2: ((MIDDLE, 30), (MIDDLE, 160)),
    3: ((LEFT, 30), (RIGHT, 115), (LEFT, 200)),
    4: ((MIDDLE, 30), (RIGHT, 125), (MIDDLE, 220), (LEFT, 125)),
    5: ((MIDDLE, 30), (RIGHT, 110), (RIGHT, 220), (LEFT, 220), (LEFT, 110)),
    6: ((MIDDLE, 30), (RIGHT, 100), (RIGHT, 220), (MIDDLE, 290), (LEFT, 220), (LEFT, 100)),
}
"""Centres by the number of boxes, in their order clockwise."""


@dataclass(frozen=True, slots=True)
class Box:
    """One object: its name, its centre and its width."""

    name: str
    x: int
    y: int
    width: int


@dataclass(frozen=True, slots=True)
class Diagram:
    """The boxes of a question, in a picture `WIDTH` wide and `height` high."""

    boxes: tuple[Box, ...]
    height: int


def diagram(names: Sequence[str]) -> Diagram:
    """The blank diagram of two to six objects."""
    places = PLACES[len(names)]
    boxes = tuple(
        Box(name, x, y, max(60, round(ROOM + LETTER * _letters(name))))
        for name, (x, y) in zip(names, places, strict=True)
    )
    return Diagram(boxes, max(y for _, y in places) + BOX // 2 + 5)


def _letters(name: str) -> int:
    """How many average letters a name is as wide as: a Chinese character is as wide as two."""
    return sum(2 if east_asian_width(one) in "WF" else 1 for one in name)
