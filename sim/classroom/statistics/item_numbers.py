"""How hard an item was, and whether it tells students apart.

An item left open counts as not right, as in a test on paper. `rest` is the student's marks in all
other items: an item must not be compared with itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from sim.classroom.refusal import ENOUGH_FOR_ITEMS, RefusalError, at_least, numbers
from sim.classroom.statistics.spread import moments, root

OUTER = Fraction(27, 100)
"""The share of a class at its upper and at its lower end (Kelley 1939: it tells them best)."""


def difficulty(marks: Sequence[float], of: float) -> float:
    """The mean share of the marks; 1 is very easy, 0 very hard."""
    given = numbers(marks)
    at_least(len(given), 1)
    if of <= 0:
        raise RefusalError("the item is worth no marks")
    return float(sum(map(Fraction, given), Fraction(0)) / len(given) / Fraction(of))


def corrected_point_biserial(
    marks: Sequence[float], totals: Sequence[float], *, fewest: int = ENOUGH_FOR_ITEMS
) -> float:
    """Correlation of the marks in an item with the marks in all other items. Rough."""
    given, whole = numbers(marks), numbers(totals)
    at_least(len(given), max(2, fewest))
    rest = [float(Fraction(t) - Fraction(m)) for m, t in zip(given, whole, strict=True)]
    (_, x), (_, y) = moments(given, given), moments(rest, rest)
    if x == 0:
        raise RefusalError("everybody did equally well in this item")
    if y == 0:
        raise RefusalError("everybody has the same marks in the other items")
    _, xy = moments(given, rest)
    size = root(xy * xy / (x * y))
    return size if xy >= 0 else -size


def discrimination(
    marks: Sequence[float],
    totals: Sequence[float],
    of: float,
    *,
    fewest: int = ENOUGH_FOR_ITEMS,
) -> float:
    """Difficulty in the upper 27 % of the class minus that in the lower 27 %. Rough.

    Where students on the edge of the 27 % have equal totals, all of them count in part: nobody's
    place in a list decides.
    """
    given, whole = numbers(marks), numbers(totals)
    at_least(len(given), max(2, fewest))
    if len(set(whole)) == 1:
        raise RefusalError("everybody has the same marks in all: there is no upper and lower part")
    if of <= 0:
        raise RefusalError("the item is worth no marks")
    pairs = list(zip(given, whole, strict=True))
    upper = _share_of_marks(pairs, sorted(set(whole), reverse=True))
    lower = _share_of_marks(pairs, sorted(set(whole)))
    return float((upper - lower) / Fraction(of))


def _share_of_marks(pairs: Sequence[tuple[float, float]], levels: Sequence[float]) -> Fraction:
    """Mean marks of the first 27 % when students are taken level by level."""
    wanted = OUTER * len(pairs)
    left, reached = wanted, Fraction(0)
    for level in levels:
        here = [Fraction(mark) for mark, total in pairs if total == level]
        weight = min(Fraction(1), left / len(here))
        reached += weight * sum(here, Fraction(0))
        left -= weight * len(here)
        if left <= 0:
            break
    return reached / wanted
