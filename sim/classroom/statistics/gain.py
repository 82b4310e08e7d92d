"""Hake's gain: how much of what a class could still gain it did gain."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from sim.classroom.refusal import RefusalError
from sim.classroom.statistics.spread import Exact

EDGE = 0.15
"""Share of the students at 0 or at full marks above which a test is too hard or too easy."""


def hake_gain(before: float, after: float, of: float) -> float:
    """(after − before)/(of − before), from the means of a class. Never for single students.

    Source: R. R. Hake, Am. J. Phys. 66 (1998) 64, equation (1); the students are those who took
    both tests.
    """
    if of <= 0:
        raise RefusalError("the test is worth no marks")
    if before >= of:
        raise RefusalError("the class had full marks before: nothing was left to gain")
    return (after - before) / (of - before)


def at_the_edges(counts: Iterable[tuple[Exact, int]], of: Exact | None) -> tuple[int, int]:
    """How many students have 0 marks, and how many have full marks (0 if that is not known).

    `counts`: marks, and how many students have them.
    """
    found = list(counts)
    full = 0 if of is None else sum(n for m, n in found if m >= of)
    return sum(n for m, n in found if m <= 0), full


def gain_of_student(before: Exact, after: Exact, of: Exact) -> Fraction | None:
    """(after − before)/(of − before) of one student, exactly; None with full marks before.

    Only the mean of a class is told (Hake 1998 calls it the average of the single-student gains):
    one student's is mostly luck.
    """
    return Fraction(after - before) / (of - before) if before < of else None
