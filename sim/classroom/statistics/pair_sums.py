"""Students who took both tests, as exact sums: what gains and comparisons are computed from.

Sums of two classes add to those of both, in any order, without rounding. From n, Σx, Σy, Σx²,
Σy² and Σxy follow all means, deviations and the covariance; signed ranks need how many students
have each difference.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from fractions import Fraction
from typing import Any

from sim.classroom.statistics.adjusted import Before, before_of
from sim.classroom.statistics.gain import at_the_edges, gain_of_student
from sim.classroom.statistics.spread import Exact, Spread, spread_of


@dataclass(frozen=True, slots=True, kw_only=True)
class PairSums:
    """`x` before and `y` after, in marks. `shares`: sum of the gains of the `gained` students who
    could gain. `zero` and `full`: students with 0 and with full marks, before and after.
    """

    n: int = 0
    x: Exact = 0
    y: Exact = 0
    xx: Exact = 0
    yy: Exact = 0
    xy: Exact = 0
    shares: Exact = 0
    gained: int = 0
    zero_before: int = 0
    full_before: int = 0
    zero_after: int = 0
    full_after: int = 0
    differences: Mapping[Exact, int]

    def __add__(self, other: PairSums) -> PairSums:
        total: dict[str, Any] = {
            f.name: getattr(self, f.name) + getattr(other, f.name)
            for f in fields(self)
            if f.name != "differences"
        }
        return PairSums(**total, differences=Counter(self.differences) + Counter(other.differences))

    @property
    def before(self) -> Spread:
        """The earlier test."""
        return spread_of(self.n, self.x, self.xx)

    @property
    def after(self) -> Spread:
        """The later test."""
        return spread_of(self.n, self.y, self.yy)

    @property
    def gain(self) -> Spread:
        """Later minus earlier, student by student."""
        return spread_of(self.n, self.y - self.x, self.yy + self.xx - 2 * self.xy)

    @property
    def both(self) -> Before:
        """What an adjusted difference needs."""
        products = self.xy - Fraction(self.x) * self.y / self.n
        return before_of(self.before, self.after, products)


NOBODY = PairSums(differences={})


def pair_sums(
    before: Sequence[float | Exact], after: Sequence[float | Exact], of: float | Exact | None
) -> PairSums:
    """The sums of students, place by place; `of`: the most marks, None where nobody knows."""
    x, y = [_exact(value) for value in before], [_exact(value) for value in after]
    return pair_sums_of(Counter(zip(x, y, strict=True)), None if of is None else _exact(of))


def pair_sums_of(counts: Mapping[tuple[Exact, Exact], int], of: Exact | None) -> PairSums:
    """The same from how many students have each two totals, before and after."""
    found = [(x, y, n) for (x, y), n in counts.items()]
    gains = [(None if of is None else gain_of_student(x, y, of), n) for x, y, n in found]
    differences: Counter[Exact] = Counter()
    for x, y, n in found:
        differences[y - x] += n
    zero_before, full_before = at_the_edges([(x, n) for x, _, n in found], of)
    zero_after, full_after = at_the_edges([(y, n) for _, y, n in found], of)
    return PairSums(
        n=sum(n for _, _, n in found),
        x=sum(n * x for x, _, n in found), y=sum(n * y for _, y, n in found),
        xx=sum(n * x * x for x, _, n in found), yy=sum(n * y * y for _, y, n in found),
        xy=sum(n * x * y for x, y, n in found),
        shares=sum((n * gain for gain, n in gains if gain is not None), Fraction(0)),
        gained=sum(n for gain, n in gains if gain is not None),
        zero_before=zero_before, full_before=full_before, zero_after=zero_after,
        full_after=full_after, differences=differences,
    )  # fmt: skip


def _exact(value: float | Exact) -> Exact:
    """A whole number stays one: whole numbers add fastest."""
    if isinstance(value, int):
        return value
    found = Fraction(value)
    return found.numerator if found.denominator == 1 else found
