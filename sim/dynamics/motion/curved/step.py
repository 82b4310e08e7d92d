"""A step of a row in the own time of a curved contact (`own_time`): polynomials in s, asked at t.

The overlap of the gap that keeps the clock is written as z = d^(1/4). Impulses, losses and
integrals over time are series of their own, for a product with dt/ds stands in each.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from sim.dynamics.motion.curved.own_time import OwnTime
from sim.dynamics.motion.curved_field import curved
from sim.dynamics.motion.guards import along
from sim.dynamics.motion.power_series.crest import crest
from sim.dynamics.motion.power_series.polynomial import Poly, size, slope, value
from sim.dynamics.motion.power_series.step import Step
from sim.laws.branch import Guard

TOUCHES = 1e-8
"""Of the greatest z in a step. A step that ends as near to z = 0 ends without overlap."""

KNOWN = 1e-14
"""Of the greatest force of a contact in a step, to which it is known. What spheres press falls as
z⁶: it is over where their contact is, and not where rounding has hidden the rest of its force."""

STEEP = 1e-9
"""Of the greatest dt/ds. So near a touch the slope of a force is without bound, and not drawn."""

NEAR_TOUCH = (1 / 32, 1 / 8)
"""Of a step in s, where a curve is drawn in parts: d grows as s⁴ there."""

NEAR_DAMPED = tuple(2.0**-k for k in range(11, 1, -1))
"""The same where a damper pushes: its force grows as s, the fourth root of the time. A cubic in t
follows it to 1e-4 of the greatest force; in parts as above it was off by a hundredth."""


@dataclass(slots=True)
class CurvedStep(Step):
    """`over` of the gap that keeps the clock is its z [m^(1/4)]."""

    clock: int | None
    own: OwnTime
    rates: list[Poly]  # m/s
    bends: list[Poly]  # m/s², accelerations
    impulses: list[Poly]  # N s
    losses: list[Poly]  # J, of curved contacts
    rate_squares: list[Poly]  # m²/s, integrals of o'² where a damper asks for them
    drags: list[list[Poly]]  # of v², v|v|, |v|³ of each body, where there is drag
    pulls: list[Poly]  # N s, of what acts across the gaps; empty where there is none
    sums: list[Poly]  # m s, integrals of the overlaps, where a loose spring asks for them

    @property
    def span(self) -> float:
        """In its own time."""
        return self.own.span

    def until_own(self, s: float) -> CurvedStep:
        """The same up to a moment of its own time."""
        own = self.own.until(s)
        return replace(self, own=own, length=own.length)

    def along(self, k: int, guard: Guard) -> Poly:
        """The contact that keeps the clock is over where z falls to zero."""
        over = self.over[k]
        if k == self.clock:
            if guard.cause == "apart":
                return over
            square = _product(over, over)
            over = _product(square, square)
        found = along(self.gaps[k], guard, over, self.contact[k], self.rates[k])
        if guard.cause == "apart" and self.branches[k].locked:
            return [found[0] + KNOWN * size(found, self.span), *found[1:]]
        return found

    def others(self, i: int) -> Poly:
        """N on body i from its neighbours and all that is steady."""
        total = [self.bodies[i].load.steady] + [0.0] * (len(self.contact[0]) - 1)
        for k, sign in ((i - 1, 1.0), (i, -1.0)):
            if 0 <= k < len(self.gaps):
                total = [a + sign * b for a, b in zip(total, self.push(k), strict=True)]
        return total

    def displacement(self, i: int, t: float) -> float:
        """m that body i has gone."""
        return value(self.path[i], self.own.of(t))

    def velocity(self, i: int, t: float) -> float:
        """m/s of body i."""
        return value(self.speed[i], self.own.of(t))

    def motion(self, i: int, t: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of body i."""
        s = self.own.of(t)
        return value(self.path[i], s), value(self.speed[i], s), value(self.bends[i], s)

    def excess(self, i: int, a: float, dt: float) -> float:
        """m. Displacement of body i from a s on, beyond that at the velocity there."""
        displacement = self.displacement(i, a + dt) - (self.displacement(i, a) if a else 0.0)
        return displacement - self.velocity(i, a) * dt

    def speeds(self, i: int, t: float) -> tuple[float, float]:
        """m/s. Least and greatest velocity of body i up to t."""
        return Step.speeds(self, i, self.own.of(t))

    def accelerations(self, i: int, t: float, dt: float) -> tuple[float, float]:
        """m/s². Least and greatest of body i from t s on: it grows by its rate at most.

        Two that part side by side at 1e-17 m/s are told from two that touch by so little.
        """
        bend, begin, end = self.bends[i], self.own.of(t), self.own.of(t + dt)
        here, reach = value(bend, begin), (end - begin) * size(slope(bend), end)
        bound = size(bend, end)
        return max(here - reach, -bound), min(here + reach, bound)

    def overlap(self, k: int, t: float) -> tuple[float, float]:
        """m and m/s."""
        s = self.own.of(t)
        return self._over(k, s), value(self.rates[k], s)

    def _over(self, k: int, s: float) -> float:
        d = value(self.over[k], s)
        if k != self.clock:
            return d
        if s >= self.span and abs(d) <= TOUCHES * size(self.over[k], s):
            return 0.0
        return float(max(d, 0.0) ** 4)

    def summed(self, k: int, t: float) -> float:
        """m s."""
        return value(self.sums[k], self.own.of(t))

    def impulse(self, k: int, t: float) -> float:
        """N s."""
        return value(self.impulses[k], self.own.of(t))

    def across_impulse(self, k: int, t: float) -> float:
        """N s."""
        return value(self.pulls[k], self.own.of(t))

    def others_impulse(self, i: int, t: float) -> float:
        """N s."""
        total = self.bodies[i].load.steady * t
        for k, sign in ((i - 1, 1.0), (i, -1.0)):
            if 0 <= k < len(self.gaps):
                total += sign * (self.impulse(k, t) + self.across_impulse(k, t))
        return total

    def contact_force(self, k: int, t: float) -> float:
        """N."""
        return value(self.contact[k], self.own.of(t))

    def force(self, k: int, t: float) -> tuple[float, float]:
        """N and dN/dt, links included."""
        s, push = self.own.of(t), self.push(k)
        pace, most = self.own.pace(s), size(slope(self.own.at), self.span)
        return value(push, s), value(slope(push), s) / pace if pace > STEEP * most else 0.0

    def squares(self, i: int, t: float) -> tuple[float, float, float]:
        """Integrals of v², v|v| and |v|³."""
        if not self.drags[i]:
            return 0.0, 0.0, 0.0
        square, signed, cube = (value(p, self.own.of(t)) for p in self.drags[i])
        return square, signed, cube

    def rate_square(self, k: int, t: float) -> float:
        """m²/s."""
        return value(self.rate_squares[k], self.own.of(t))

    def dissipated(self, k: int, t: float, end: float) -> float:
        """J. What a bumper keeps follows from its law."""
        gap, branch = self.gaps[k], self.branches[k]
        if curved(gap) is not None:
            return value(self.losses[k], self.own.of(t))
        loss = branch.gamma * self.rate_square(k, t) if branch.gamma else 0.0
        if gap.law is None:
            return loss
        return loss + gap.law.kept(branch, self._over(k, 0.0), end)

    def deepest(self, k: int, t: float, over: float, rate: float) -> float:
        """m. Greatest overlap up to t."""
        s, rates = self.own.of(t), self.rates[k]
        best = max(self._over(k, 0.0), over)
        if (top := crest(rates, s, rate)) is not None:
            best = max(best, self._over(k, top))
        return best

    def strongest(self, k: int, t: float) -> float:
        """N. A bound on the contact's force up to t."""
        return size(self.contact[k], self.own.of(t))

    def greatest(self, k: int, t: float) -> list[float]:
        """Times at which a contact's force may be greatest."""
        growth, s = slope(self.contact[k]), self.own.of(t)
        top = crest(growth, s, value(growth, s))
        return [0.0, t] if top is None else [0.0, self.own.time(top), t]

    def marks(self, end: float) -> list[float]:
        """Closer together near a touch and a separation."""
        if self.clock is None:
            return []
        parts = [0.5]
        if self._over(self.clock, 0.0) == 0.0:
            parts = [*self._near(self.clock, 0.0), *parts]
        if self._over(self.clock, self.span) == 0.0:
            parts += [1.0 - part for part in reversed(self._near(self.clock, self.span))]
        found = [self.own.time(part * self.span) for part in parts]
        return [t for t in found if 0.0 < t < end]

    def _near(self, k: int, s: float) -> tuple[float, ...]:
        """Where to divide near a touch or a separation at s: without a damper N goes as s⁶."""
        push = self.contact[k]
        damped = abs(value(slope(push), s)) * self.span > STEEP * size(push, self.span)
        return NEAR_DAMPED if damped else NEAR_TOUCH


def _product(p: Poly, q: Poly) -> Poly:
    found = [0.0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q, i):
            found[j] += a * b
    return found
