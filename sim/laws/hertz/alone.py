"""A pair of spheres that nobody else touches, from any overlap and rate to the end: see `course`.

N = y^(1/5) (K y + (4/5) C y_s) is greatest, and least, where y_s = r W y with

    (2 zeta/5) r² + (6/5 − 4 zeta²) r − 2 zeta = 0
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from sim.laws.hertz.course import Creeping, Swinging, creeping, swinging

UNDAMPED, DAMPED = 4, 7
"""Powers of ten: the force goes with t^(3/2) at first, that of a damper with t^(1/4)."""

AT_TOUCH = 1e-9
"""Of a contact's overlap. There the force has no slope that could be drawn."""

DEEPEST = 0.0
"""r, where y is greatest."""


@dataclass(frozen=True, slots=True)
class Alone:
    """Overlap d0 [m] and rate u [m/s] at t = 0; `fresh`: from first touch."""

    course: Swinging | Creeping
    stiffness: float  # K
    damper: float  # C
    e: float
    zeta: float
    mu: float
    d0: float
    u: float

    @property
    def fresh(self) -> bool:
        """Does it begin at no overlap?"""
        return self.d0 == 0.0

    @property
    def duration(self) -> float:
        """s; inf for e = 0."""
        return self.course.duration

    def at(self, t: float) -> tuple[float, float]:
        """d and d' at t."""
        if t <= 0.0:
            return self.d0, self.u
        if t >= self.duration and self.fresh:
            return 0.0, -self.e * self.u
        y, rate = self.course.at(self.course.phase(min(t, self.duration)))
        return (0.0 if t >= self.duration else max(y, 0.0) ** 0.8), 0.8 * rate

    def force(self, d: float, v: float) -> tuple[float, float]:
        """N, and what the rate alone makes of it in N/s; that is without bound at d = 0."""
        if d <= 0.0:
            return 0.0, 0.0
        root = math.sqrt(d)
        quarter = math.sqrt(root)
        if d <= AT_TOUCH * self.d_scale:
            return self.stiffness * d * root + self.damper * quarter * v, 0.0
        growth = 1.5 * self.stiffness * root * v + 0.25 * self.damper * v * v * quarter / d
        return self.stiffness * d * root + self.damper * quarter * v, growth

    @property
    def d_scale(self) -> float:
        """m. An overlap of the size of those that occur, or more."""
        moving = 1.25 * self.mu * self.u * self.u / self.stiffness
        return float(max(self.d0, moving**0.4))

    def marks(self, end: float) -> list[float]:
        """Times up to `end` between which it can be drawn: ever shorter stretches towards touch
        and end, ever longer ones in a tail."""
        top, last = self.deepest()[0], self.duration
        found = [top]
        near = range(1, DAMPED if self.damper else UNDAMPED)
        found += [top * 10.0**-k for k in near]
        if last < math.inf:
            found += [last - (last - top) * 10.0**-k for k in near]
        while last == math.inf and found[0] > 0.0 and max(found) < end:
            found.append(3.0 * max(found))
        return sorted(t for t in found if 0.0 < t < end)

    def damping(self, d: float) -> float:
        """N s/m just now."""
        return self.damper * math.sqrt(math.sqrt(d)) if d > 0.0 else 0.0

    def deepest(self) -> tuple[float, float]:
        """When [s] and how deep [m] it gets from now on."""
        return self._turn(DEEPEST)[:2]

    def greatest_force(self) -> float:
        """s."""
        return self._turn(self._extremes()[0])[0]

    def strongest(self) -> float:
        """N. A bound on the force, pushing or pulling."""
        return max(abs(self.force(*self._turn(r)[1:])[0]) for r in self._extremes())

    def _extremes(self) -> tuple[float, ...]:
        """r of the greatest push and of the greatest pull."""
        if self.zeta == 0.0:
            return (DEEPEST,)
        a, b, c = 0.4 * self.zeta, 1.2 - 4.0 * self.zeta * self.zeta, -2.0 * self.zeta
        q = -0.5 * (b + math.copysign(math.sqrt(b * b - 4.0 * a * c), b))
        return (q / a, c / q) if q > 0.0 else (c / q, q / a)

    def _turn(self, r: float) -> tuple[float, float, float]:
        """When y_s = r W y [s], with d and d' there; the beginning where that is over."""
        x = self.course.turn(r)
        if x <= self.course.begin:
            return 0.0, self.d0, self.u
        y, rate = self.course.at((x, math.pi - x))
        return self.course.time(x), max(y, 0.0) ** 0.8, 0.8 * rate


def alone(
    stiffness: float, damper: float, e: float, zeta: float, mu: float, d: float, v: float
) -> Alone | None:
    """The closed form; None where there is none that is good to the last bits, or no motion."""
    w = math.sqrt(1.25 * stiffness / mu)
    y, rate = d**1.25, 1.25 * v
    if not 0.0 < math.hypot(y * w, rate) < math.inf:
        return None
    course: Swinging | Creeping | None
    if e == 0.0:
        course = creeping(y, rate, w)
    else:
        c = -math.log(e) / math.pi
        course = swinging(y, rate, w / math.sqrt(1.0 + c * c), c)
    return None if course is None else Alone(course, stiffness, damper, e, zeta, mu, d, v)
