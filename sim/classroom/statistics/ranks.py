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
from sim.classroom.statistics.tails import normal_two_sided
from sim.scene.said import Said, counted

MOST_COUNTED = 50
FEWEST_CHANGED = 5  # with four, even “all went up” has p = 0.125


def of_changed(n: int, needed: int) -> Said:
    """That the marks of too few students changed at all."""
    return counted(
        "1 student whose marks changed: at least {needed} are needed",
        "{n} students whose marks changed: at least {needed} are needed",
        n=n, needed=f"{needed}",
    )  # fmt: skip


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


def signed_ranks(found: Mapping[Any, int], *, fewest: int = FEWEST_CHANGED) -> SignedRanks:
    """The test from how many students have each difference, as floats or exact numbers; refuses
    where too few changed at all."""
    changed = {d: count for d, count in found.items() if d and count}
    n = sum(changed.values())
    at_least(n, max(1, fewest), of_changed)
    ranks = _doubled_ranks(changed)
    whole = sum(ranks[abs(d)] * count for d, count in changed.items())
    plus = sum(ranks[abs(d)] * count for d, count in changed.items() if d > 0)
    smaller = min(plus, whole - plus)
    squares = sum(ranks[abs(d)] ** 2 * count for d, count in changed.items())
    normal = _normal(whole, squares, smaller)
    few = n <= MOST_COUNTED
    doubled = [ranks[abs(d)] for d, count in changed.items() for _ in range(count)] if few else []
    p = _counted(doubled, smaller) if few else normal
    up = sum(count for d, count in changed.items() if d > 0)
    same = sum(found.values()) - n
    return SignedRanks(smaller / 2, p, normal, up, n - up, same, "counted" if few else "normal")


def _doubled_ranks(changed: Mapping[Any, int]) -> dict[Any, int]:
    """Twice the rank of each size: middle ranks are halves, and stay whole numbers so."""
    sizes: Counter[Any] = Counter()
    for d, count in changed.items():
        sizes[abs(d)] += count
    ranks, below = {}, 0
    for size in sorted(sizes):
        ranks[size] = 2 * below + sizes[size] + 1
        below += sizes[size]
    return ranks


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


def _normal(whole: int, squares: int, smaller: int) -> float:
    """The same from a normal curve with the exact mean and variance, ties included."""
    if squares == 0:
        raise RefusalError("nobody's marks changed")
    deviation = math.sqrt(squares) / 2
    return normal_two_sided((smaller - whole / 2) / deviation)
