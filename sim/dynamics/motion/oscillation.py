"""The overlap of a pair as a damped oscillation about a place of rest, in closed form."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from sim.dynamics.motion.safe_step import SLACK
from sim.dynamics.motion.threshold import first_fall_to
from sim.laws.damped_oscillation import Rate, first_turn, first_zero, greatest_bend, solve

FADED = 1e-4
"""Of the first swing. Fainter ones are not drawn one by one."""

KEPT = 4
"""Instants: the end of a phase, and where overlap and force are greatest."""

MOST_MARKS = 2000
"""Quarter swings drawn one by one."""


def rate_of(stiff: float, damp: float, mu: float) -> Rate:
    """Rates of an oscillator with these N/m and N s/m."""
    w0, beta = math.sqrt(stiff / mu), 0.5 * damp / mu
    if beta == w0:
        return Rate(w0, beta, 0.0, "critical")
    w = math.sqrt(abs((w0 - beta) * (w0 + beta)))
    return Rate(w0, beta, w, "under" if beta < w0 else "over")


@dataclass(slots=True)
class Oscillation:
    """o'' + 2 beta o' + w0² (o − centre) = 0 from o0 [m] and u [m/s]."""

    rate: Rate
    centre: float  # m
    o0: float
    u: float
    _last: dict[float, tuple[float, float, float, float]] = field(
        init=False, repr=False, compare=False, default_factory=dict
    )
    """The last values: overlap, force, impulse and both bodies ask for one instant in turn."""

    def at(self, t: float) -> tuple[float, float, float, float]:
        """o, o', o'', o''' at t."""
        if (known := self._last.get(t)) is not None:
            return known
        y, v = solve(self.rate, self.o0 - self.centre, self.u, t)
        twice, square = 2.0 * self.rate.beta, self.rate.w0 * self.rate.w0
        a = -twice * v - square * y
        found = y + self.centre, v, a, -twice * a - square * v
        if len(self._last) >= KEPT:
            self._last.clear()
        self._last[t] = found
        return found

    def over(self, t: float) -> tuple[float, float]:
        """Overlap and its rate; the bits of the start are kept at t = 0."""
        return (self.o0, self.u) if t == 0.0 else self.at(t)[:2]

    def strongest_from(self, t: float) -> float:
        """m/s². Bound on |o''| from t on: where it fades, that of the start would bound nothing."""
        rate = self.rate
        start = (rate.w0 + 2.0 * rate.beta) * self.fastest()
        if t <= 0.0 or rate.beta <= 0.0 or rate.w0 == 0.0:
            return start
        return min(start, greatest_bend(rate, *self.at(t)[2:]) * SLACK)

    def bends(self, t: float, dt: float) -> tuple[float, float]:
        """m/s². Least and greatest o'' in dt s from t on: what it is, and what its rate can add.

        That rate, o''', swings as o does, and such a swing's energy never grows.
        """
        _, _, bend, growth = self.at(t)
        w0, beta, most = self.rate.w0, self.rate.beta, self.strongest_from(t)
        if w0 == 0.0:
            return -most, most
        reach = dt * math.hypot(growth, 2.0 * beta / w0 * growth + w0 * bend)
        return max(bend - reach, -most), min(bend + reach, most)

    def deepest(self, t: float) -> float:
        """m. Greatest overlap up to t."""
        turn = first_turn(self.rate, self.o0 - self.centre, self.u)
        best = max(self.o0, self.over(t)[0])
        turns = (turn,) if self.u > 0.0 else (turn, turn + self.half)
        return max([best, *(self.at(one)[0] for one in turns if one < t)])

    def falls(self, over: float, rate: float, level: float) -> float:
        """First t at which over (o − centre) + rate o' falls to a level; it swings as o does."""
        y0 = self.o0 - self.centre
        bend = -2.0 * self.rate.beta * self.u - self.rate.w0 * self.rate.w0 * y0
        return first_fall_to(
            self.rate, over * y0 + rate * self.u, over * self.u + rate * bend, level
        )

    def turns_at(self, level: float, within: float) -> bool:
        """Is that the lowest place of a swing that does not fade, `within` a part of its farthest?

        Then it does not fall below it, though by rounding it does in every swing.
        """
        if self.rate.beta != 0.0:
            return False
        swing = self.fastest() / self.rate.w0
        return abs(self.centre - swing - level) <= within * (swing + abs(self.centre))

    def greatest(self, kappa: float, gamma: float, t: float) -> list[float]:
        """Times up to t at which kappa o + gamma o' may be greatest."""
        y0, w0, beta = self.o0 - self.centre, self.rate.w0, self.rate.beta
        bend = -2.0 * beta * self.u - w0 * w0 * y0
        growth = kappa * self.u + gamma * bend
        third = -2.0 * beta * bend - w0 * w0 * self.u
        if growth <= 0.0:  # it falls first, or lies still: its lowest place may come, and a crest
            low = first_zero(self.rate, growth, kappa * bend + gamma * third)
            return [0.0, *(one for one in (low, low + self.half) if one < t), t]
        turn = first_fall_to(self.rate, growth, kappa * bend + gamma * third, 0.0)
        return [0.0, turn, t] if turn < t else [0.0, t]

    @property
    def half(self) -> float:
        """s. From one turn to the next; inf where it does not swing."""
        return math.pi / self.rate.w if self.rate.regime == "under" else math.inf

    def fastest(self) -> float:
        """m/s. Bound on |o'|: that energy never grows."""
        return math.hypot(self.u, self.rate.w0 * (self.o0 - self.centre))

    def sum(self, t: float) -> float:
        """m s. Integral of the overlap up to t, from the equation of motion."""
        o, v = self.over(t)
        changed = v - self.u + 2.0 * self.rate.beta * (o - self.o0)
        return self.centre * t - changed / (self.rate.w0 * self.rate.w0)

    def damped(self, t: float) -> float:
        """m²/s. Integral of o'² up to t, from what the oscillation has lost."""
        if self.rate.beta == 0.0:
            return 0.0
        o, v = self.over(t)
        y0, y, square = self.o0 - self.centre, o - self.centre, self.rate.w0 * self.rate.w0
        kinetic = (self.u - v) * (self.u + v)
        return (kinetic + square * (y0 - y) * (y0 + y)) / (4.0 * self.rate.beta)

    def marks(self, end: float) -> list[float]:
        """Every quarter swing up to `end` s, while it is worth drawing."""
        rate = self.rate
        quarter = 0.5 * math.pi / (rate.w if rate.regime == "under" else rate.w0)
        if rate.beta > 0.0:
            end = min(end, -math.log(FADED) / rate.beta + quarter)
        return [quarter * (n + 1) for n in range(min(MOST_MARKS, int(end / quarter)))]
