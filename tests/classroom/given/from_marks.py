"""Statistics that the report makes of sums and counts, from the marks of each student."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from fractions import Fraction

from sim.classroom.statistics.compare import TTest, change_of
from sim.classroom.statistics.item_numbers import (
    ENOUGH_FOR_ITEMS,
    item_marks,
    levels_of,
    share_of_marks,
    upper_minus_lower,
    with_others,
)
from sim.classroom.statistics.ranks import SignedRanks, signed_ranks
from sim.classroom.statistics.spread import spread


def differences(later: Sequence[float], earlier: Sequence[float]) -> list[float]:
    """Later minus earlier, student by student."""
    return [b - a for b, a in zip(later, earlier, strict=True)]


def paired_t(later: Sequence[float], earlier: Sequence[float]) -> TTest:
    """Student's t of the differences within students."""
    return change_of(spread(differences(later, earlier)))


def wilcoxon(later: Sequence[float], earlier: Sequence[float]) -> SignedRanks:
    """The test of signed ranks."""
    return signed_ranks(Counter(differences(later, earlier)))


def difficulty(marks: Sequence[float], of: float) -> float:
    """The mean share of the marks."""
    return share_of_marks(len(marks), sum(map(Fraction, marks), Fraction(0)), Fraction(of))


def discrimination(marks: Sequence[float], totals: Sequence[float], of: float) -> float:
    """Difficulty in the upper 27 % of the class minus that in the lower 27 %."""
    return upper_minus_lower(levels_of(marks, totals), Fraction(of))


def corrected_point_biserial(
    marks: Sequence[float], totals: Sequence[float], *, fewest: int = ENOUGH_FOR_ITEMS
) -> float:
    """Correlation of the marks in an item with the marks in all other items."""
    return with_others(item_marks(marks, totals), fewest=fewest)
