"""How hard an item was, and whether it tells students apart.

An item left open counts as not right, as in a test on paper. All numbers follow from exact sums
(`ItemMarks`) and from `Levels`: how many students have each total, and how many marks they have
together in the item. So the sums of two schools give the numbers of both.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

from sim.classroom.refusal import ENOUGH_FOR_ITEMS, RefusalError, at_least, numbers
from sim.classroom.statistics.spread import Exact, around, root
from sim.scene.said import template

OUTER = Fraction(27, 100)
"""The share of a class at its upper and at its lower end (Kelley 1939: it tells them best)."""

QUARTER = Fraction(1, 4)
"""The same as physics education research takes it (Ding and Beichner 2009)."""

WORTHLESS = template("the item is worth no marks")
ALL_EQUAL = template("everybody has the same marks in all: there is no upper and lower part")
SAME_REST = template("everybody has the same marks in the other items")
SAME_TOTAL = template("everybody has the same marks in all")

Levels = Mapping[Exact, tuple[int, Exact]]
"""Total → how many students have it, and the sum of their marks in the item."""


@dataclass(frozen=True, slots=True)
class ItemMarks:
    """n students: Σ of the marks m in the item and of the totals t, and of m², t² and m·t."""

    n: int
    m: Exact
    mm: Exact
    t: Exact
    tt: Exact
    mt: Exact


def item_marks(marks: Sequence[float], totals: Sequence[float]) -> ItemMarks:
    """The sums of students, place by place."""
    m, t = list(map(Fraction, numbers(marks))), list(map(Fraction, numbers(totals)))
    return ItemMarks(
        len(m), sum(m), sum(a * a for a in m), sum(t), sum(b * b for b in t),
        sum(a * b for a, b in zip(m, t, strict=True)),
    )  # fmt: skip


def levels_of(marks: Sequence[float], totals: Sequence[float]) -> Levels:
    """Students by their totals."""
    found: dict[Exact, tuple[int, Exact]] = {}
    for mark, total in zip(numbers(marks), numbers(totals), strict=True):
        count, sum_of = found.get(Fraction(total), (0, 0))
        found[Fraction(total)] = count + 1, sum_of + Fraction(mark)
    return found


def share_of_marks(n: int, total: Exact, of: Exact) -> float:
    """Of the marks that n students could have, from the sum of theirs; 1 is very easy, 0 hard."""
    at_least(n, 1)
    if of <= 0:
        raise RefusalError(WORTHLESS)
    return float(Fraction(total) / n / of)


def with_others(sums: ItemMarks, *, fewest: int = ENOUGH_FOR_ITEMS) -> float:
    """Correlation of the marks in an item with the marks in all other items. Rough. An item must
    not be compared with itself, so r = t − m is taken (the corrected point-biserial)."""
    rest = sums.tt - 2 * sums.mt + sums.mm
    return _correlation(sums, sums.t - sums.m, rest, sums.mt - sums.mm, fewest, SAME_REST)


def with_total(sums: ItemMarks, *, fewest: int = ENOUGH_FOR_ITEMS) -> float:
    """Correlation with the total, the item included: what most published tables print.

    Source: L. Ding and R. Beichner, Phys. Rev. ST PER 5 (2009) 020103, equation (3); for items
    marked 0 or 1 it is (x̄₁ − x̄)/σ · √(P/(1 − P)).
    """
    return _correlation(sums, sums.t, sums.tt, sums.mt, fewest, SAME_TOTAL)


def _correlation(sums: ItemMarks, y: Exact, yy: Exact, xy: Exact, fewest: int, equal: str) -> float:
    at_least(sums.n, max(2, fewest))
    of_item, of_rest = around(sums.n, sums.m, sums.mm), around(sums.n, y, yy)
    if of_item == 0:
        raise RefusalError("everybody did equally well in this item")
    if of_rest == 0:
        raise RefusalError(equal)
    products = xy - Fraction(sums.m) * y / sums.n
    size = root(products * products / (of_item * of_rest))
    return size if products >= 0 else -size


def upper_minus_lower(
    levels: Levels, of: Exact, outer: Fraction = OUTER, *, fewest: int = ENOUGH_FOR_ITEMS
) -> float:
    """Difficulty in the upper share of the class minus that in the lower one. Rough.

    Where students on the edge have equal totals, all of them count in part: nobody's place in a
    list decides.
    """
    at_least(sum(count for count, _ in levels.values()), max(2, fewest))
    if len(levels) == 1:
        raise RefusalError(ALL_EQUAL)
    if of <= 0:
        raise RefusalError(WORTHLESS)
    upper = _marks_below(levels, sorted(levels, reverse=True), outer)
    lower = _marks_below(levels, sorted(levels), outer)
    return float((upper - lower) / outer / of)


def curve(
    levels: Levels, of: Exact, parts: int = 4, *, fewest: int = ENOUGH_FOR_ITEMS
) -> list[float]:
    """Mean share of the marks in each quarter of the class, the weakest first: an item curve."""
    at_least(sum(count for count, _ in levels.values()), max(parts, fewest))
    if len(levels) == 1:
        raise RefusalError(ALL_EQUAL)
    order = sorted(levels)
    below = [_marks_below(levels, order, Fraction(k, parts)) for k in range(parts + 1)]
    return [float((b - a) * parts / of) for a, b in pairwise(below)]


def _marks_below(levels: Levels, order: Sequence[Exact], share: Fraction) -> Fraction:
    """Marks of the first part of a class, taken level by level in this order, per student of all.

    Of a level that is only needed in part all students count in part.
    """
    count = sum(n for n, _ in levels.values())
    left, reached = share * count, Fraction(0)
    for level in order:
        if left <= 0:
            break
        here, marks = levels[level]
        weight = min(Fraction(1), left / here)
        reached += weight * marks
        left -= weight * here
    return reached / count
