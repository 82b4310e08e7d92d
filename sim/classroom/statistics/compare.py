"""Two lists of marks compared: paired t, Welch's t, the paper's Z, Cohen's d.

`difference` is always the second or experimental minus the first or control.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from sim.classroom.refusal import FEWEST, RefusalError, at_least
from sim.classroom.statistics.spread import Spread
from sim.classroom.statistics.tails import normal_inside, normal_two_sided, t_quantile, t_two_sided
from sim.scene.said import Said, counted, template

ALL_EQUAL = template("all the differences are equal: there is no spread to compare them with")
NO_SPREAD = template("all marks within both groups are equal: there is no spread")


def of_pairs(n: int, needed: int) -> Said:
    """That there are too few students with both marks."""
    return counted(
        "1 pair: at least {needed} are needed", "{n} pairs: at least {needed} are needed",
        n=n, needed=f"{needed}",
    )  # fmt: skip


@dataclass(frozen=True, slots=True)
class TTest:
    """A difference of means in marks, with its interval first and its p last."""

    difference: float
    se: float
    low: float
    high: float
    df: float
    t: float
    p: float


def t_test(difference: float, se: float, df: float, level: float = 0.95) -> TTest:
    """The test of a difference with this standard error against 0. Needs scipy."""
    if not (se > 0 and math.isfinite(se)):
        raise RefusalError(ALL_EQUAL)
    half = t_quantile(0.5 + level / 2, df) * se
    t = difference / se
    low, high = difference - half, difference + half
    return TTest(difference, se, low, high, df, t, t_two_sided(t, df))


def change_of(gain: Spread, *, fewest: int = FEWEST) -> TTest:
    """Student's t of differences within students. Refuses fewer than `fewest` pairs."""
    at_least(gain.n, max(2, fewest), of_pairs)
    if gain.sd == 0:
        raise RefusalError(ALL_EQUAL)
    return t_test(gain.mean, gain.se, gain.n - 1)


def welch(one: Spread, other: Spread, *, fewest: int = FEWEST) -> TTest:
    """Welch's t of two groups, `one` minus `other`: their deviations may differ."""
    for group in (one, other):
        at_least(group.n, max(2, fewest))
    a, b = one.sd**2 / one.n, other.sd**2 / other.n
    if a + b == 0:
        raise RefusalError(NO_SPREAD)
    df = (a + b) ** 2 / (a**2 / (one.n - 1) + b**2 / (other.n - 1))
    return t_test(one.mean - other.mean, math.sqrt(a + b), df)


@dataclass(frozen=True, slots=True)
class PaperZ:
    """Equation (4) of the paper. `inside` is what it prints as P; the p-value is `p` = 1 − that."""

    z: float
    inside: float
    p: float


def paper_z(one: Spread, other: Spread) -> PaperZ:
    """Z = (x̄₁ − x̄₂)/√(s₁²/n₁ + s₂²/n₂), and how much of a normal distribution lies inside."""
    for group in (one, other):
        at_least(group.n, 2)
    square = one.sd**2 / one.n + other.sd**2 / other.n
    if square == 0:
        raise RefusalError(NO_SPREAD)
    z = (one.mean - other.mean) / math.sqrt(square)
    return PaperZ(z, normal_inside(z), normal_two_sided(z))


def cohen_d(one: Spread, other: Spread) -> float:
    """(x̄₁ − x̄₂) divided by the pooled standard deviation of two groups of students."""
    for group in (one, other):
        at_least(group.n, 2)
    freedom = one.n + other.n - 2
    pooled = math.sqrt(((one.n - 1) * one.sd**2 + (other.n - 1) * other.sd**2) / freedom)
    if pooled == 0:
        raise RefusalError(NO_SPREAD)
    return (one.mean - other.mean) / pooled


def cohen_d_within(earlier: Spread, later: Spread) -> float:
    """(later − earlier) of one group, divided by √((s₁² + s₂²)/2) of the two tests."""
    for test in (earlier, later):
        at_least(test.n, 2)
    typical = math.sqrt((earlier.sd**2 + later.sd**2) / 2)
    if typical == 0:
        raise RefusalError("all marks of both tests are equal: there is no spread")
    return (later.mean - earlier.mean) / typical
