"""The most marks of a test as its heading tells them: `pre (30)`. A year and a day tell none."""

from __future__ import annotations

import re
from collections.abc import Iterable
from fractions import Fraction

from sim.classroom.statistics.spread import Exact
from sim.classroom.tables.marks import is_mark, mark, whole

_MOST = re.compile(
    r"(?P<name>.*?)\s*(?:/\s*|[(\[]\s*(?P<word>/|of|m[aá]x\.?|von|sur|sobre|de|daripada|满分|滿分)?\s*)"
    r"(?P<most>[0-9]{1,6}(?:[.,][0-9]{1,6})?)\s*(?P<end>[)\]])?"
)  # fmt: skip
_YEAR = re.compile("19[0-9]{2}|20[0-9]{2}|2100")
_DAY_BEFORE = re.compile(r"(?:.*\W)?([0-9]{1,2})/")
_DAY_AND_MONTH = re.compile(r"(?:[1-9]|[12][0-9]|3[01])[.,](?:0[1-9]|1[0-2])")
DAYS, MONTHS = range(1, 32), range(1, 13)
FEW = 1 / 4
"""Share of the marks of a column up to which those above the most are mistakes of who typed."""


def split_most(heading: str) -> tuple[str, Exact | None]:
    """What stands before the number at the end of a heading, and the number, whatever it counts."""
    found = _MOST.fullmatch(heading.strip())
    if not found or not found["name"]:
        return heading.strip(), None
    if ("(" in heading.strip()[found.end("name") :]) != (found["end"] == ")"):
        return heading.strip(), None
    most = Fraction(found["most"].replace(",", "."))
    return found["name"].strip(), whole(most) if most > 0 else None


def with_most(heading: str) -> tuple[str, Exact | None]:
    """`Q. 1 /1.00` is Q. 1 of 1 and `pre (30)` is pre of 30; `Test 3/2025` and `Test 12/05` are not
    of that many marks."""
    return (heading.strip(), None) if _is_a_date(heading.strip()) else split_most(heading)


def too_low(most: Exact, cells: Iterable[str]) -> bool:
    """Whether a number of a heading cannot be the most marks: in `Quiz (1)` it counts quizzes. One
    cell above it, or a few, are slips and refused one by one."""
    marks = [mark(cell)[0] or 0 for cell in cells if is_mark(cell)]
    above = sum(value > most for value in marks)
    return above > 1 and above > FEW * len(marks)


def _is_a_date(heading: str) -> bool:
    """A year, `12/05`, `(12.05)` or `25/26`; `(max 2000)` says itself that it is the most."""
    found = _MOST.fullmatch(heading)
    if not found or found["word"]:
        return False
    if _YEAR.fullmatch(found["most"]) or _DAY_AND_MONTH.fullmatch(found["most"]):
        return True
    before = _DAY_BEFORE.fullmatch(heading[: found.start("most")])
    if not before or not found["most"].isdecimal():
        return False
    one, other = int(before[1]), int(found["most"])
    return other == one + 1 or (
        one in DAYS and other in DAYS and (one in MONTHS or other in MONTHS)
    )
