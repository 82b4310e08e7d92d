"""One contact of two carts in closed form, also while friction brakes them.

With d the overlap of the bumpers and mu = 1 (only w0 = sqrt(k/mu) shows in a motion):

    d'' = −N(d, d') + A ,      A = a1 − a2

N is the force of a law of sim.laws, a1 and a2 the accelerations that friction gives each
cart. Without friction these are the law's own stretches. With friction A is constant between the
instants at which a cart turns round, and the motion is again a swing, about a centre that A moves:
press in about A/w0², spring back about (1 − e²) dm + A e²/w0². The instants of turning are those of
the motion without friction: an error of second order in A.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

from sim.laws.bumper.law import Bumper
from sim.laws.damped_oscillation import Swing, first_turn, first_zero, solve, undamped
from sim.laws.paper.law import Paper

Law = Literal["bumper", "paper"]
LAWS: tuple[Law, ...] = ("bumper", "paper")
STICKS = 1e-6
"""e. Below it the carts stay together after the greatest overlap."""


@dataclass(frozen=True, slots=True)
class Stretch:
    """A swing of the overlap while the accelerations are constant: `a` of each cart, m/s²."""

    swing: Swing
    a: tuple[float, float]

    @property
    def end(self) -> float:
        """s after touch."""
        return self.swing.start + self.swing.duration


def without_friction(law: Law, w0: float, e: float, u: float) -> tuple[Swing, ...]:
    """The law's own stretches from first touch at approach speed u [m/s]."""
    made = Bumper(w0 * w0, _kept(e)) if law == "bumper" else Paper(w0 * w0, max(e, STICKS))
    return made.stretches(1.0, 0.0, u, 0.0)


def _kept(e: float) -> float:
    return e if e >= STICKS else 0.0


def with_friction(
    law: Law,
    w0: float,
    e: float,
    u: float,
    turns: Sequence[float],
    acceleration: Callable[[float], tuple[float, float]],
) -> tuple[Stretch, ...]:
    """The contact in pieces. `acceleration` of both carts at a time after touch; it changes at
    `turns` (s after touch, rising)."""
    out: list[Stretch] = []
    t, d, v = 0.0, 0.0, u
    edges = [*turns, math.inf]
    plain = without_friction(law, w0, e, u)
    phases = ("press", "spring") if law == "bumper" and e >= STICKS else ("press",)
    for phase in phases:
        turning = d  # the greatest overlap, once pressed in
        for edge in edges:
            if edge <= t:
                continue
            a = acceleration(t)
            swing, ends = _piece(law, phase, plain, (w0, e, a[0] - a[1]), (t, d, v), turning)
            length = min(ends, edge - t)
            out.append(Stretch(_shortened(swing, length), a))
            y, v = solve(swing.rate, swing.y0, swing.v0, length)
            t, d = t + length, y + swing.centre
            if length == ends:
                break
    return tuple(out)


def _piece(
    law: Law,
    phase: str,
    plain: tuple[Swing, ...],
    numbers: tuple[float, float, float],
    start: tuple[float, float, float],
    turning: float,
) -> tuple[Swing, float]:
    """The swing from `start` (t, d, d'), and how long it lasts if nothing turns."""
    w0, e, relative = numbers
    t, d, v = start
    if law == "paper":
        rate = plain[0].rate
        centre = relative / (w0 * w0)
        swing = Swing(rate, t, math.inf, centre, d - centre, v)
        return swing, _clear(swing, plain[0].duration - t)
    if phase == "press":
        rate, centre = undamped(w0), relative / (w0 * w0)
        swing = Swing(rate, t, math.inf, centre, d - centre, v)
        return swing, first_turn(rate, d - centre, v) if v > 0.0 else 0.0
    rate = undamped(w0 / e)
    rest = (1.0 - e * e) * turning
    centre = rest + relative * e * e / (w0 * w0)
    reach = math.hypot(d - centre, v / rate.w)
    angle = math.atan2(v / rate.w, d - centre)  # y = reach cos(wt − angle)
    level = max(-1.0, min(1.0, (rest - centre) / reach)) if reach else 1.0
    swing = Swing(rate, t, math.inf, centre, d - centre, v)
    return swing, max(0.0, angle + math.acos(level)) / rate.w


def _clear(swing: Swing, guess: float) -> float:
    """When a damped swing about a moved centre is clear of the other bumper (d = 0)."""
    if swing.centre == 0.0 and swing.y0 == 0.0:
        return first_zero(swing.rate, 0.0, swing.v0)
    t = max(guess, 0.0)
    for _ in range(8):  # Newton: the centre has moved by far less than the overlap
        y, v = solve(swing.rate, swing.y0, swing.v0, t)
        if v >= 0.0:
            return math.inf  # it is held together
        step = (y + swing.centre) / v
        t -= step
        if abs(step) < 1e-15:
            break
    return max(t, 0.0)


def _shortened(swing: Swing, length: float) -> Swing:
    return Swing(swing.rate, swing.start, length, swing.centre, swing.y0, swing.v0)
