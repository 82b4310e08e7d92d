"""One stretch of a linear contact: a damped oscillation of the overlap, in closed form.

    d'' + 2 beta d' + w0² (d − centre) = 0 ,     N = −mu d''

d [m] is the overlap of two bumpers, mu [kg] the reduced mass m1 m2 / (m1 + m2) (m for a wall),
N [N] the force that pushes the two apart. With y = d − centre and b = y'(0) + beta y(0):

    beta < w0   y = e^(−beta t) (y0 cos wt + (b/w) sin wt),    w  = sqrt(w0² − beta²)
    beta = w0   y = e^(−beta t) (y0 + b t)
    beta > w0   y = e^(−beta t) (y0 cosh wt + (b/w) sinh wt),  w  = sqrt(beta² − w0²)

Every derivative of y solves the same equation, so N does too, and one routine finds all zeros.
Errors: a few units in the last place; w is passed in, because w0² − beta² would cancel.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

Regime = Literal["under", "critical", "over"]


@dataclass(frozen=True, slots=True)
class Rate:
    """Rates of one linear contact: `w0`, `beta`, `w` in 1/s, and which of the three forms holds."""

    w0: float
    beta: float
    w: float
    regime: Regime


def undamped(w0: float) -> Rate:
    """A spring alone."""
    return Rate(w0, 0.0, w0, "under")


@dataclass(frozen=True, slots=True)
class Swing:
    """The overlap from `start` (s after first touch) for `duration` s (may be inf)."""

    rate: Rate
    start: float
    duration: float
    centre: float  # m
    y0: float  # m, overlap at start, from the centre
    v0: float  # m/s, rate of overlap at start

    def at(self, t: float) -> tuple[float, float, float, float]:
        """d, d', d'', d''' at `t` s after first touch (m, m/s, m/s², m/s³)."""
        y, v = solve(self.rate, self.y0, self.v0, t - self.start)
        twice, square = 2.0 * self.rate.beta, self.rate.w0 * self.rate.w0
        a = -twice * v - square * y
        return y + self.centre, v, a, -twice * a - square * v

    def strongest_from(self, t: float) -> float:
        """m/s². |d''| is nowhere greater from `t` on: see `greatest_bend`."""
        _, _, a, j = self.at(t)
        return greatest_bend(self.rate, a, j)

    @property
    def d0(self) -> float:
        """m. Overlap at start."""
        return self.centre + self.y0

    def end(self) -> tuple[float, float]:
        """d and d' where the stretch ends."""
        d, v, _, _ = self.at(self.start + self.duration)
        return d, v


def solve(rate: Rate, y0: float, v0: float, t: float) -> tuple[float, float]:
    """y and y' at time t from y0 and v0."""
    beta, w = rate.beta, rate.w
    c = beta * v0 + rate.w0 * rate.w0 * y0  # y' = e^(−beta t) (v0 cos − (c/w) sin)
    if rate.regime == "under":
        fade, cos, sin = math.exp(-beta * t), math.cos(w * t), math.sin(w * t) / w
        return fade * (y0 * cos + (v0 + beta * y0) * sin), fade * (v0 * cos - c * sin)
    if rate.regime == "critical":
        fade = math.exp(-beta * t)
        if fade == 0.0:
            return 0.0, 0.0
        return fade * (y0 + (v0 + beta * y0) * t), fade * (v0 - c * t)
    slow, fast = math.exp((w - beta) * t), math.exp(-(w + beta) * t)  # cosh alone would overflow
    cosh, sinh = (slow + fast) / 2.0, (slow - fast) / (2.0 * w)
    return y0 * cosh + (v0 + beta * y0) * sinh, v0 * cosh - c * sinh


def greatest_bend(rate: Rate, a: float, j: float) -> float:
    """m/s². Bound on |y''| from an instant on at which y'' = a and y''' = j, but for rounding.

    y'' solves the equation of y, which only loses of  y'''² + w0² y''²  (beta ≥ 0, w0 > 0).
    """
    return math.hypot(a, j / rate.w0)


def first_zero(rate: Rate, y0: float, v0: float) -> float:
    """First t > 0 with y(t) = 0; inf if there is none. A zero at the start does not count."""
    b = v0 + rate.beta * y0
    if rate.regime == "under":
        if y0 == 0.0 and b == 0.0:
            return math.inf
        angle = math.atan2(-y0 * rate.w, b)  # y = R e^(−beta t) sin(wt − angle)
        return (angle if angle > 0.0 else angle + math.pi) / rate.w
    if rate.regime == "critical":
        return -y0 / b if b != 0.0 and -y0 / b > 0.0 else math.inf
    ratio = -y0 * rate.w / b if b != 0.0 else math.inf
    return math.atanh(ratio) / rate.w if 0.0 < ratio < 1.0 else math.inf


def first_turn(rate: Rate, y0: float, v0: float) -> float:
    """First t > 0 with y'(t) = 0; inf if there is none."""
    return first_zero(rate, v0, -2.0 * rate.beta * v0 - rate.w0 * rate.w0 * y0)


def greatest_force(stretches: tuple[Swing, ...]) -> float:
    """Time (s after first touch) at which the force −mu d'' is greatest over all stretches."""
    best, when = -math.inf, 0.0
    for swing in stretches:
        candidates = [swing.start]
        _, _, a, j = swing.at(swing.start)
        if j < 0.0:
            candidates.append(swing.start + min(first_turn(swing.rate, a, j), swing.duration))
        for t in candidates:
            force = -swing.at(t)[2]
            if force > best * (1.0 + WHERE_STRETCHES_MEET):
                best, when = force, t
    return when


WHERE_STRETCHES_MEET = 1e-14
"""Relative. Two stretches meet with one force; rounding must not move the peak to the later."""
