"""Exact numbers in a file: whole ones as they are, fractions as text, `"7/2"`."""

from __future__ import annotations

import re
from fractions import Fraction
from functools import lru_cache

from sim.classroom.statistics.spread import Exact

MOST_DIGITS = 2_000
"""Digits of a numerator or denominator: sums of gains of many students have long ones."""

SHORT = 12
"""Characters of a number that is likely to come again."""

MOST_STUDENTS = 10_000_000
_FRACTION = re.compile(rf"(-?[0-9]{{1,{MOST_DIGITS}}})(?:/([0-9]{{1,{MOST_DIGITS}}}))?")
_LARGEST = 10**40


class SummaryError(ValueError):
    """This is no summary that can be added; the message is for the teacher."""


def written(value: Exact) -> int | str:
    """A number for JSON."""
    found = Fraction(value)
    small = found.denominator == 1 and abs(found.numerator) < _LARGEST
    return found.numerator if small else f"{found.numerator}/{found.denominator}"


def exact(value: object) -> Exact:
    """The number back; raises `SummaryError`."""
    if type(value) is int and -_LARGEST < value < _LARGEST:  # a bool is none
        return value
    if isinstance(value, str):
        return _of_text(value) if len(value) <= SHORT else _parsed(value)
    raise SummaryError("a number in it is damaged")


def _parsed(text: str) -> Exact:
    found = _FRACTION.fullmatch(text)
    if not found:
        raise SummaryError("a number in it is damaged")
    if not found[2]:
        return int(found[1])
    if int(found[2]) == 0:
        raise SummaryError("a number in it is divided by 0")
    number = Fraction(int(found[1]), int(found[2]))
    return number.numerator if number.denominator == 1 else number


_of_text = lru_cache(maxsize=2**14)(_parsed)  # marks: of a thousand schools the same few


def count(value: object) -> int:
    """How many students; raises `SummaryError`."""
    if type(value) is int and 0 <= value <= MOST_STUDENTS:
        return value
    raise SummaryError("a count in it is damaged")
