"""Hake's gain: how much of what a class could still gain it did gain."""

from __future__ import annotations

from sim.classroom.refusal import RefusalError

EDGE = 0.15
"""Share of the students at 0 or at full marks above which a test is too hard or too easy."""


def hake_gain(before: float, after: float, of: float) -> float:
    """(after − before)/(of − before), from the means of a class. Never for single students."""
    if of <= 0:
        raise RefusalError("the test is worth no marks")
    if before >= of:
        raise RefusalError("the class had full marks before: nothing was left to gain")
    return (after - before) / (of - before)


def at_the_edges(marks: tuple[float, ...], of: float) -> tuple[float, float]:
    """The shares of students at 0 and at full marks."""
    if not marks:
        raise RefusalError("0 students: at least 1 is needed")
    count = len(marks)
    return sum(m <= 0 for m in marks) / count, sum(m >= of for m in marks) / count
