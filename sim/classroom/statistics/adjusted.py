"""The difference of two groups after the same start: ANCOVA, adjusted for the pre-test.

A group that starts low tends to rise by itself. Post-test marks are fitted with one slope on the
pre-test for both groups; the adjusted difference is what remains between the groups.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from sim.classroom.refusal import FEWEST, RefusalError, at_least, numbers
from sim.classroom.statistics.compare import TTest, t_test
from sim.classroom.statistics.spread import Spread, moments, spread
from sim.scene.said import template

NO_SPREAD = template(
    "everybody in a group had the same marks before: there is nothing to adjust for"
)

ROUNDING = 1e-13
"""Of the spread of the marks after: what rounding leaves of it where the line goes through all of
them; sums of squares of some hundred marks are exact to that."""


@dataclass(frozen=True, slots=True)
class Before:
    """A group before and after. `shared`: covariance of the two tests, in marks squared."""

    before: Spread
    after: Spread
    shared: float


@dataclass(frozen=True, slots=True)
class Adjusted:
    """`slope`: marks after per mark before. `test`: the adjusted difference."""

    slope: float
    test: TTest


def pairs_of(before: Sequence[float], after: Sequence[float]) -> Before:
    """A group in short, from the marks of students who took both tests."""
    first, second = numbers(before), numbers(after)
    at_least(len(first), 2)
    _, products = moments(first, second)
    return before_of(spread(first), spread(second), products)


def before_of(before: Spread, after: Spread, products: Fraction) -> Before:
    """The same from the exact sum of the products of both deviations from their means."""
    at_least(before.n, 2)
    return Before(before, after, float(products) / (before.n - 1))


def from_deviations(before: Spread, after: Spread, gain_sd: float) -> Before:
    """The same from printed numbers: s²(gain) = s²(before) + s²(after) − 2 cov."""
    return Before(before, after, (before.sd**2 + after.sd**2 - gain_sd**2) / 2)


def adjusted(one: Before, other: Before, *, fewest: int = FEWEST) -> Adjusted:
    """`one` minus `other`. Needs scipy."""
    for group in (one, other):
        at_least(group.before.n, max(2, fewest))
    freedom = [group.before.n - 1 for group in (one, other)]
    x, y, xy = (
        sum(n * value for n, value in zip(freedom, values, strict=True))
        for values in (
            (one.before.sd**2, other.before.sd**2),
            (one.after.sd**2, other.after.sd**2),
            (one.shared, other.shared),
        )
    )
    left = sum(freedom) - 1
    if x <= 0:
        raise RefusalError(NO_SPREAD)
    if left < 1:
        raise RefusalError("too few students for a slope")
    slope = xy / x
    apart = one.before.mean - other.before.mean
    difference = one.after.mean - other.after.mean - slope * apart
    square = (y - xy * slope) / left
    if square <= ROUNDING * y or y == 0:
        raise RefusalError("the marks after follow from the marks before: no spread is left")
    se = math.sqrt(square * (1 / one.before.n + 1 / other.before.n + apart**2 / x))
    return Adjusted(slope, t_test(difference, se, left))
