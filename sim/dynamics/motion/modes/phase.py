"""One phase of a row that swings, from one change of a contact to the next, in closed form.

All that a step of a row tells, from quantities told from their beginning (`started`) instead of
polynomials: as exact, and as long as the phase is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from operator import mul

from sim.dynamics.motion.modes.crests import greatest
from sim.dynamics.motion.modes.falls import first_fall
from sim.dynamics.motion.modes.modal_sum import ModalSum
from sim.dynamics.motion.modes.shares import Swings
from sim.dynamics.motion.modes.started import Grown, Started, Swinging
from sim.dynamics.motion.power_series.step import Step

ONE_CREST = 2.0
"""Radians of the fastest mode. A shorter phase is no longer than one step of the series."""

KEPT = 4
"""Times: the end of the phase, and where its forces are greatest."""


@dataclass(slots=True)
class Phase(Step):
    """Overlaps, forces and velocities as quantities told from their beginning; no polynomials."""

    found: Swings
    modes: Swinging
    overlaps: list[Started]  # m
    pushes: list[Started]  # N, of the contacts
    speeds_of: list[Started]  # m/s
    seen: dict[float, Grown] = field(default_factory=dict)
    """The last times asked for: all quantities are asked for at the end of the phase."""

    def at(self, t: float) -> Grown:
        """What the modes have grown to at t s."""
        found = self.seen.get(t)
        if found is None:
            if len(self.seen) >= KEPT:
                self.seen.clear()
            found = self.seen[t] = self.modes.at(t)
        return found

    def closing(self, k: int) -> Started:
        """m/s. The rate of the overlap of gap k."""
        o = self.over[k]
        return Started(o[1], o[2], o[3], self.found.closing[k])

    def displacement(self, i: int, t: float) -> float:
        """m that body i has gone."""
        return self.speeds_of[i].integral(t, self.at(t))

    def velocity(self, i: int, t: float) -> float:
        """m/s of body i."""
        v = self.speeds_of[i]
        return v.value(t, self.at(t)) if t else v.first

    def motion(self, i: int, t: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of body i."""
        v, at = self.speeds_of[i], self.at(t)
        return v.integral(t, at), v.value(t, at), v.rate(at)

    def excess(self, i: int, a: float, dt: float) -> float:
        """m. Displacement of body i from a s on, beyond that at the velocity there."""
        if a == 0.0:
            v = self.speeds_of[i]
            return Started(0.0, v.slope, v.bend, v.shape).integral(dt, self.at(dt))
        before = self.displacement(i, a) if a else 0.0
        return self.displacement(i, a + dt) - before - self.velocity(i, a) * dt

    def speeds(self, i: int, t: float) -> tuple[float, float]:
        """m/s. Least and greatest velocity of body i up to t."""
        v = self.speeds_of[i]
        reach = Started(0.0, v.slope, v.bend, v.shape).size(self.modes, t)
        return v.first - reach, v.first + reach

    def accelerations(self, i: int, t: float, dt: float) -> tuple[float, float]:
        """m/s². Least and greatest of body i up to t + dt."""
        v = self.speeds_of[i]
        modes = self.modes
        swing = sum(
            [
                a * b * min(t + dt, 2.0 / abs(z))
                for a, b, z in zip(modes.sizes, v.shape.size, modes.rates, strict=True)
            ]
        )
        return v.slope - swing, v.slope + swing

    def overlap(self, k: int, t: float) -> tuple[float, float]:
        """m and m/s: overlap of gap k and its rate."""
        q = self.overlaps[k]
        if self.branches[k].locked:
            return q.first + q.slope * t, q.slope
        at = self.at(t)
        return q.value(t, at), q.rate(at)

    def contact_force(self, k: int, t: float) -> float:
        """N."""
        return self.pushes[k].value(t, self.at(t))

    def force(self, k: int, t: float) -> tuple[float, float]:
        """N and dN/dt."""
        q, at = self.pushes[k], self.at(t)
        return q.value(t, at), q.rate(at)

    def impulse(self, k: int, t: float) -> float:
        """N s. Of the contact."""
        return self.pushes[k].integral(t, self.at(t))

    def squares(self, i: int, t: float) -> tuple[float, float, float]:
        """There is no drag."""
        return 0.0, 0.0, 0.0

    def rate_square(self, k: int, t: float) -> float:
        """m²/s. Integral of o'² dt in gap k: o' is a sum of modes, and of nothing else.

        Told from its beginning as well: second derivatives, beside those of a fast swing, do not
        tell how much there is of a slow one. What they leave of the known rate is a constant.
        """
        modes, q = self.modes, self.overlaps[k]
        shares = tuple(map(mul, modes.amplitudes, q.shape.in_rate))
        terms = tuple([(z, y) for z, y in zip(modes.rates, shares, strict=True) if y])
        return ModalSum(q.slope - sum(shares).real, terms).square_integral(t)

    def marks(self, end: float) -> list[float]:
        """Every quarter swing of the fastest mode."""
        quarter = 0.5 * math.pi * self.swing
        return [n * quarter for n in range(1, math.ceil(end / quarter))] if quarter else []

    @property
    def swing(self) -> float:
        """s. Of the fastest mode, over 2 pi; 0 where nothing swings."""
        return 1.0 / self.found.pace if self.found.rates else 0.0

    def deepest(self, k: int, t: float, over: float, rate: float) -> float:
        """m. Greatest overlap up to t; `over` and `rate` are those at t."""
        q = self.overlaps[k]
        best = max(q.first, over)
        if (top := self._crest(q, self.closing(k), t, rate)) is not None:
            best = max(best, q.value(top, self.at(top)))
        return best

    def strongest(self, k: int, t: float) -> float:
        """N. A bound on the contact's force up to t."""
        return self.pushes[k].size(self.modes, t)

    def greatest(self, k: int, t: float) -> list[float]:
        """When a contact's force is greatest: at an end, or at a crest."""
        q, growth = self.pushes[k], self.found.growth[k]
        bend = sum(map(mul, self.modes.amplitudes, growth.of)).real
        top = self._crest(q, Started(q.slope, q.bend, bend, growth), t, q.rate(self.at(t)))
        if top is not None:
            return [top]
        return [t] if q.value(t, self.at(t)) > q.first else [0.0]

    def _crest(self, q: Started, growth: Started, t: float, rate: float) -> float | None:
        """s. When q is greatest up to t, if not at an end; `rate` is its growth at t."""
        if t * self.found.pace > ONE_CREST:
            return greatest(q, growth, self.modes, t, self.found.pace)
        if q.slope > 0.0 and rate < 0.0:
            return first_fall(growth, self.modes, t)
        return None
