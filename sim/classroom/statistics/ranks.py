"""Wilcoxon's signed-rank test: did more go up than down, counting how far?

Marks are whole numbers: many differences are equal or zero, and tables for different numbers do not
hold. So the chance is counted: every difference could have had the other sign, and all such cases
are gone through (by sums, not one by one). Equal differences share their middle rank; zeros are
left out, as Wilcoxon did. Beyond MOST_COUNTED pairs the normal curve takes over.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from sim.classroom.refusal import RefusalError, at_least
from sim.classroom.statistics.spread import Exact, differences
from sim.classroom.statistics.tails import normal_two_sided

MOST_COUNTED = 50
FEWEST_CHANGED = 5  # with four, even “all went up” has p = 0.125


@dataclass(frozen=True, slots=True)
class SignedRanks:
    """`statistic`: the smaller sum of ranks. `up`, `down`, `same`: students by what they did.

    `p_normal`: the p of the normal curve with ties counted, which other programs give with ties.
    """

    statistic: float
    p: float
    p_normal: float
    up: int
    down: int
    same: int
    way: Literal["counted", "normal"]


def wilcoxon(
    later: Sequence[float], earlier: Sequence[float], *, fewest: int = FEWEST_CHANGED
) -> SignedRanks:
    """The test of later against earlier; refuses where too few changed at all."""
    return signed_ranks(Counter(differences(later, earlier)), fewest=fewest)


def signed_ranks(found: Mapping[Any, int], *, fewest: int = FEWEST_CHANGED) -> SignedRanks:
    """The same from how many students have each difference, as floats or exact numbers."""
    changed = [d for d, count in sorted(found.items()) if d for _ in range(count)]
    at_least(len(changed), max(1, fewest), "students whose marks changed")
    doubled = _doubled_ranks([abs(d) for d in changed])
    plus = sum(rank for rank, d in zip(doubled, changed, strict=True) if d > 0)
    smaller = min(plus, sum(doubled) - plus)
    few = len(changed) <= MOST_COUNTED
    normal = _normal(doubled, smaller)
    p = _counted(doubled, smaller) if few else normal
    up = sum(d > 0 for d in changed)
    down, same = len(changed) - up, sum(found.values()) - len(changed)
    return SignedRanks(smaller / 2, p, normal, up, down, same, "counted" if few else "normal")


def _doubled_ranks(sizes: Sequence[float | Exact]) -> list[int]:
    """Twice the rank of each: middle ranks are halves, and stay whole numbers so."""
    order = sorted(sizes)
    first = {size: k for k, size in reversed(list(enumerate(order)))}
    last = {size: k for k, size in enumerate(order)}
    return [first[size] + last[size] + 2 for size in sizes]


def _counted(doubled: Sequence[int], smaller: int) -> float:
    """The share of all 2ⁿ choices of signs with a sum this far from the middle, or further."""
    ways = [1] + [0] * sum(doubled)
    reached = 0
    for rank in doubled:
        reached += rank
        for total in range(reached, rank - 1, -1):
            ways[total] += ways[total - rank]
    tail = sum(ways[: smaller + 1])
    return min(1.0, float(2 * tail / 2.0 ** len(doubled)))


def _normal(doubled: Sequence[int], smaller: int) -> float:
    """The same from a normal curve with the exact mean and variance, ties included."""
    squares = sum(rank * rank for rank in doubled)
    if squares == 0:
        raise RefusalError("nobody's marks changed")
    deviation = math.sqrt(squares) / 2
    return normal_two_sided((smaller - sum(doubled) / 2) / deviation)
