"""One step of a row of bodies, as polynomials in time, whoever found them."""

from __future__ import annotations

from dataclasses import dataclass

from sim.dynamics.motion.guards import along
from sim.dynamics.motion.power_series.crest import crest
from sim.dynamics.motion.power_series.polynomial import (
    Poly,
    integral_value,
    size,
    slope,
    square_integral,
    value,
    value_and_slope,
)
from sim.dynamics.motion.quadrature import square_and_cube
from sim.dynamics.state.body import Body, Gap
from sim.laws.branch import Branch, Guard


@dataclass(slots=True)
class Step:
    """Polynomials in s since the step began, of `gaps` and `bodies` from left to right.

    `steady` are forces that do not change in the step, sliding friction included; without it they
    are in the bodies' loads. `short`: a nonlinear row, whose steps are short. No motion is changed
    once it is made; what a run makes for every phase is not frozen, as that slows its making.
    """

    bodies: list[Body]
    gaps: list[Gap]
    branches: list[Branch]
    length: float  # s
    over: list[Poly]  # m, overlap of each gap
    contact: list[Poly]  # N, of the contact in each gap
    across: list[Poly]  # N, of springs and magnets across each gap; empty where there are none
    speed: list[Poly]  # m/s of each body; walls stay
    path: list[Poly]  # m, from where each was; empty where it is the integral of its speed
    steady: list[float]  # N on each body
    short: bool

    @property
    def rests(self) -> bool:
        """Does everything stay, or go on with one constant acceleration? Paths are parabolas."""
        return bool(self.speed) and len(self.speed[0]) == 2 and not any(map(_moves, self.over))

    @property
    def span(self) -> float:
        """The argument of the polynomials at the end of the step: its length."""
        return self.length

    def along(self, k: int, guard: Guard) -> Poly:
        """What falls to zero where a guard of gap k has its event."""
        return along(self.gaps[k], guard, self.over[k], self.contact[k])

    def displacement(self, i: int, t: float) -> float:
        """m that body i has gone."""
        return value(self.path[i], t) if self.path else integral_value(self.speed[i], t)

    def velocity(self, i: int, t: float) -> float:
        """m/s of body i."""
        return value(self.speed[i], t)

    def motion(self, i: int, t: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of body i."""
        return (self.displacement(i, t), *value_and_slope(self.speed[i], t))

    def excess(self, i: int, a: float, dt: float) -> float:
        """m. Displacement of body i from a s on, beyond that at the velocity there."""
        if a == 0.0:
            return integral_value([0.0, *self.speed[i][1:]], dt)
        return self.displacement(i, a + dt) - self.displacement(i, a) - self.velocity(i, a) * dt

    def speeds(self, i: int, t: float) -> tuple[float, float]:
        """m/s. Least and greatest velocity of body i up to t, bounded by the coefficients."""
        speed = self.speed[i]
        reach = size([0.0, *speed[1:]], t)
        return speed[0] - reach, speed[0] + reach

    def accelerations(self, i: int, t: float, dt: float) -> tuple[float, float]:
        """m/s². Least and greatest of body i from t s on: it grows by its rate at most."""
        growth = slope(self.speed[i])
        here, reach = value(growth, t), dt * size(slope(growth), t + dt)
        return here - reach, here + reach

    def overlap(self, k: int, t: float) -> tuple[float, float]:
        """m and m/s: overlap of gap k and its rate."""
        return value_and_slope(self.over[k], t)

    def summed(self, k: int, t: float) -> float:
        """m s. Integral of the overlap of gap k; asked for by loose springs."""
        return integral_value(self.over[k], t)

    def across_impulse(self, k: int, t: float) -> float:
        """N s. Of springs and magnets across gap k."""
        return integral_value(self.across[k], t)

    def others_impulse(self, i: int, t: float) -> float:
        """N s. What `others` did to body i."""
        return integral_value(self.others(i), t)

    def push(self, k: int) -> Poly:
        """N of gap k: contact and links."""
        force, across = self.contact[k], self.across[k]
        return [a + b for a, b in zip(force, across, strict=True)] if across else force

    def others(self, i: int) -> Poly:
        """N on body i from its neighbours and all that is steady: what static friction balances."""
        total = [self.bodies[i].load.steady] + [0.0] * (len(self.speed[i]) - 2)
        if i > 0:
            total = [a + b for a, b in zip(total, self.push(i - 1), strict=True)]
        if i < len(self.gaps):
            total = [a - b for a, b in zip(total, self.push(i), strict=True)]
        return total

    def contact_force(self, k: int, t: float) -> float:
        """N."""
        return value(self.contact[k], t)

    def force(self, k: int, t: float) -> tuple[float, float]:
        """N and dN/dt, links included."""
        return value_and_slope(self.push(k), t)

    def impulse(self, k: int, t: float) -> float:
        """N s. Of the contact."""
        if t == 0.0:
            return 0.0
        return integral_value(self.contact[k], t)

    def dissipated(self, k: int, t: float, end: float) -> float:
        """J. What the contact does not give back of the work pressed in; `end` [m]: overlap."""
        branch, over, law = self.branches[k], self.over[k], self.gaps[k].law
        loss = 0.0
        if branch.gamma:
            loss += branch.gamma * self.rate_square(k, t)
        return loss + (law.kept(branch, over[0], end) if law is not None else 0.0)

    def marks(self, end: float) -> list[float]:
        """Times up to `end` between which it is drawn."""
        return []

    def cut(self, t: float) -> Step:
        """A power series is as exact within as it is at its end."""
        return self

    def squares(self, i: int, t: float) -> tuple[float, float, float]:
        """Integrals of v² dt, v|v| dt, |v|³ dt of body i, as far as its drag asks for them."""
        load, speed, direction = self.bodies[i].load, self.speed[i], self.bodies[i].sliding
        if not (load.linear or load.quadratic):
            return 0.0, 0.0, 0.0
        if not load.quadratic:
            return square_integral(speed, t), 0.0, 0.0
        square, cube = square_and_cube(speed, t)
        return square, direction * square, direction * cube

    def rate_square(self, k: int, t: float) -> float:
        """m²/s. Integral of o'² dt in gap k."""
        return square_integral(slope_of(self.over[k]), t)

    def deepest(self, k: int, t: float, over: float, rate: float) -> float:
        """m. Greatest overlap up to t; `over` and `rate` are those at t."""
        series = self.over[k]
        best = max(series[0], over)
        if (top := crest(slope(series), t, rate)) is not None:
            best = max(best, value(series, top))
        return best

    def strongest(self, k: int, t: float) -> float:
        """N. A bound on the contact's force up to t."""
        return size(self.contact[k], t)

    def may_peak(self, k: int, t: float) -> bool:
        """May a contact's force become greater up to t than it was in earlier steps?"""
        touching = self.gaps[k].touching
        before = touching.peak if touching is not None else None
        return before is None or self.strongest(k, t) > before.force

    def greatest(self, k: int, t: float) -> list[float]:
        """Times at which a contact's force may be greatest: ends, and where it turns."""
        growth = slope(self.contact[k])
        top = crest(growth, t, value(growth, t))
        return [0.0, t] if top is None else [0.0, top, t]


def _moves(over: Poly) -> bool:
    return len(over) > 2 or over[1] != 0.0


def slope_of(p: Poly) -> Poly:
    """dp/dt, without a term where p has none."""
    return [n * c for n, c in enumerate(p)][1:]
