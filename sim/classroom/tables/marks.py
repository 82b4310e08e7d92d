"""A cell as a mark: exact, as it was typed. `7`, `7.5`, `7,5`, `7 / 10`, `70 %`; `-` is no mark."""

from __future__ import annotations

import re
from fractions import Fraction

from sim.classroom.statistics.spread import Exact
from sim.classroom.tables.cells import TableError
from sim.classroom.tables.figures import plain
from sim.scene.said import said

NOTHING = frozenset({"", "-", "–", "—", "n/a", "na", "nan", "#n/a", ".", "null", "none"})
MOST_DIGITS = 9

_NUMBER = rf"(-|−)?([0-9]{{0,{MOST_DIGITS}}})(?:[.,]([0-9]{{1,{MOST_DIGITS}}}))?"
_MARK = re.compile(rf"{_NUMBER}(?:\s*(?:/|of|von)\s*{_NUMBER}|\s*(%))?", re.IGNORECASE)
SHOWN = 24


def is_nothing(cell: str) -> bool:
    """Whether it stands for an empty cell, in whatever letters: `N/A` too."""
    return cell.casefold() in NOTHING


def whole(value: Fraction) -> Exact:
    """A whole number as one: whole numbers add fastest."""
    return value.numerator if value.denominator == 1 else value


def mark(text: str) -> tuple[Exact | None, Exact | None]:
    """The mark and the most that it could be, each None where it is not there."""
    if is_nothing(text):
        return None, None
    found = _MARK.fullmatch(plain(text))
    if not found or not (found[2] or found[3]):
        raise TableError(said("“{cell}” is no mark", cell=shown(text)))
    value = _number(found[1], found[2], found[3])
    most: Fraction | None = None
    if found[7]:
        most = Fraction(100)
    elif found[5] or found[6]:
        most = _number(found[4], found[5], found[6])
    if value < 0:
        raise TableError(said("“{cell}” is below 0", cell=shown(text)))
    if most is not None and (most <= 0 or value > most):
        raise TableError(said("“{cell}” is more than the most marks", cell=shown(text)))
    return whole(value), None if most is None else whole(most)


def most_of(text: str) -> Exact:
    """The most marks of a test, as somebody typed it; more than nought."""
    try:
        value, _ = mark(text.strip())
    except TableError:
        value = None
    if not value:
        raise TableError("write the most marks of the test, for example 30")
    return value


def is_mark(text: str) -> bool:
    """Whether there is a mark in this cell."""
    try:
        return mark(text)[0] is not None
    except TableError:
        return False


def shown(text: str) -> str:
    """A cell in a message: short, and on one line."""
    line = "".join(c if c.isprintable() else "·" for c in text)
    return line if len(line) <= SHOWN else f"{line[:SHOWN]}…"


def _number(sign: str | None, before: str | None, after: str | None) -> Fraction:
    digits = f"{before or ''}{after or ''}"
    value = Fraction(int(digits or "0"), 10 ** len(after or ""))
    return -value if sign else value
