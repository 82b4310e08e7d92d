"""Several bodies that push or pull each other, all at once: tier 2, stepped by power series.

A cluster is a row of bodies whose neighbours touch or are linked by a spring or magnets, or one
body under forces that have no closed form together. It lives for one step of the series, or until
something happens in it: a contact's force becomes zero, a bumper turns from one line of its law to
the other, a linked pair touches, a sliding body halts, a held one slips. Then it is taken apart
and what still belongs together forms anew, by the cheapest solver that is exact.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from sim.dynamics.motion import guards as watch
from sim.dynamics.motion import stick_slip as modes
from sim.dynamics.motion import work_accounting as booking
from sim.dynamics.motion.friction_shares import share
from sim.dynamics.motion.polynomial import (
    Poly,
    first_fall,
    integral,
    size,
    slope,
    value,
    value_and_slope,
)
from sim.dynamics.motion.series import Expansion, Row, converged_step, expand, step_length
from sim.dynamics.state.clock import Time, elapsed
from sim.laws.branch import Branch

if TYPE_CHECKING:
    from sim.dynamics.result.ledger import Ledger
    from sim.dynamics.state.chain import Body, Gap
    from sim.dynamics.state.loads import Load

NEGLIGIBLE = 1e-13
"""Of the largest force in the cluster. Far ahead of the push that runs through a touching chain the
forces are a rounding error of it and less, and their sign means nothing: such a contact is kept."""


@dataclass(slots=True)
class Cluster:
    """One step of a row of bodies from `begun`, at most `limit` s. `duration` is its length in s.

    `bodies` include a wall at an end that is touched; gap k lies between bodies k and k + 1.
    """

    bodies: list[Body]
    members: list[Gap]
    begun: Time
    limit: float
    branches: list[Branch] = field(init=False)
    row: Row = field(init=False)
    series: Expansion = field(init=False)
    speed: list[Poly] = field(init=False)  # m/s, of bodies; walls stay
    path: list[Poly] = field(init=False)  # m, from where they were
    duration: float = field(init=False)
    ends: list[watch.End] = field(init=False, default_factory=list)
    touched: list[bool] = field(init=False)  # which gaps are contacts, not links alone
    loads: list[Load] = field(init=False)
    name = "power-series"
    tier = 2

    def __post_init__(self) -> None:
        watch.refuse_too_near(self.members, self.begun)
        self.touched = [gap.touching is not None for gap in self.members]
        self.loads = [body.load for body in self.bodies]
        self.branches = [watch.branch_of(gap) for gap in self.members]
        modes.decide(self.bodies, self.members, self.branches)
        self._solve()
        self._find_ends()

    def _solve(self) -> None:
        """The series, and a step in which it has converged."""
        self._expand([self._drag_sign(body) for body in self.bodies])
        unsigned = [
            i for i, body in enumerate(self.bodies) if body.load.quadratic and not body.sliding
        ]
        if unsigned:  # at rest, and nothing pushes yet: the first term of its motion tells
            for i in unsigned:
                first = next((c for c in self.speed[i] if c != 0.0), 0.0)
                self.bodies[i].sliding = (first > 0.0) - (first < 0.0)
            self._expand([self._drag_sign(body) for body in self.bodies])
        self.duration = min(step_length(self.row), self.limit)
        if self.row.nonlinear:
            self.duration = converged_step(self.row, self.series, self.speed, self.duration)

    @staticmethod
    def _drag_sign(body: Body) -> float:
        return body.sliding * body.load.quadratic

    def _expand(self, quadratic: list[float]) -> None:
        self.row = self._row(quadratic)
        self.series = expand(self.row)
        share(self.bodies, self.branches, self.row.steady, self.series)
        self.speed = [
            [body.v, *integral(a)[1:]]
            for body, a in zip(self.bodies, self.series.bodies, strict=True)
        ]
        self.path = [integral(v) for v in self.speed]

    def _row(self, quadratic: list[float]) -> Row:
        bodies, gaps = self.bodies, self.members
        return Row(
            inverse=[0.0 if body.held else 1.0 / body.mass for body in bodies],
            speeds=[body.v for body in bodies],
            overlaps=[-gap.room for gap in gaps],
            rates=[-gap.rate for gap in gaps],
            branches=self.branches,
            links=[gap.links for gap in gaps],
            steady=self._steady(),
            linear=[body.load.linear for body in bodies],
            quadratic=quadratic,
        )

    def _steady(self) -> list[float]:
        """N on each body besides its neighbours and drag: constant in the step."""
        found = []
        for i, body in enumerate(self.bodies):
            load = body.load
            force = load.steady
            if load.kinetic and body.sliding:
                force += modes.friction(body, load.steady + self.between(i))
            found.append(force)
        return found

    def between(self, i: int) -> float:
        """N. What the neighbours of body i do to it at the beginning of the step."""
        total = 0.0
        for k, sign in ((i - 1, 1.0), (i, -1.0)):
            if 0 <= k < len(self.members):
                total += sign * watch.push_now(self.members[k], self.branches[k])
        return total

    def _find_ends(self) -> None:
        sizes = self._sizes()
        noise = NEGLIGIBLE * max((s for s in sizes if s < math.inf), default=0.0)
        for end, watched in self._watched(sizes, noise):
            found = first_fall(watched, self.duration)
            if found is not None:
                if found < self.duration:
                    self.ends.clear()
                self.ends.append(end)
                self.duration = found

    def _sizes(self) -> list[float]:
        """N. Bounds on the contact forces in the step."""
        return [size(force, self.duration) for force in self.series.force]

    def _watched(self, sizes: list[float], noise: float) -> list[tuple[watch.End, Poly]]:
        """Everything that ends the step when it falls to zero."""
        found: list[tuple[watch.End, Poly]] = []
        for k, (gap, branch) in enumerate(zip(self.members, self.branches, strict=True)):
            over, force = self.series.over[k], self.series.force[k]
            if gap.touching is not None and branch.locked and (sizes[k] <= noise or gap.rate > 0.0):
                found.append((("apart", k), [-1.0]))  # nobody pushes them together any more
            elif gap.touching is None or sizes[k] >= noise:
                guards = watch.guards_of(gap, branch)
                found += [((g.cause, k), watch.along(gap, g, over, force)) for g in guards]
        for i, body in enumerate(self.bodies):
            if body.carts and body.held:
                found += [(("slip", i), p) for p in watch.grip(body, self.other_force(i))]
            elif body.sliding and (body.load.static or body.load.quadratic):
                found.append((("halt", i), [body.sliding * c for c in self.speed[i]]))
        return found

    @property
    def gaps(self) -> tuple[int, ...]:
        """The gaps of the chain that it moves."""
        return tuple(gap.index for gap in self.members)

    def impulse(self, k: int, t: float) -> float:
        """N s. Of the contact in gap k, up to t."""
        return value(integral(self.series.force[k]), t)

    def contact_force(self, k: int, t: float) -> float:
        """N. Of the contact in gap k at t."""
        return value(self.series.force[k], t)

    def greatest(self, k: int, t: float) -> list[float]:
        """Times up to t at which a contact's force may be greatest: ends, and where it turns."""
        growth = slope(self.series.force[k])
        turn = first_fall(growth, t) if value(growth, t) < 0.0 else None
        return [0.0, t] if turn is None else [0.0, turn, t]

    def warmed(self, k: int, t: float) -> float:
        """J. What the contact in gap k does not give back of the work pressed in, up to t."""
        return booking.warmed(self.members[k], self.branches[k], self.series.over[k], t)

    def push(self, k: int) -> Poly:
        """N of gap k: contact and links."""
        force, pull = self.series.force[k], self.series.pull[k]
        return [a + b for a, b in zip(force, pull, strict=True)] if pull else force

    def other_force(self, i: int) -> Poly:
        """N on body i from its neighbours and all that is steady: what static friction balances."""
        total = [self.bodies[i].load.steady] + [0.0] * (len(self.series.bodies[i]) - 1)
        if i > 0:
            total = [a + b for a, b in zip(total, self.push(i - 1), strict=True)]
        if i < len(self.members):
            total = [a - b for a, b in zip(total, self.push(i), strict=True)]
        return total

    def state(self, place: float, tau: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of the body at that place in the row."""
        k = int(place)
        return (value(self.path[k], tau), *value_and_slope(self.speed[k], tau))

    def force(self, gap: int, tau: float) -> tuple[float, float]:
        """N and dN/dt of a gap of the chain."""
        push = self.push(next(k for k, own in enumerate(self.members) if own.index == gap))
        return value_and_slope(push, tau)

    def marks(self, end: float) -> list[float]:
        """One formula holds for the whole step."""
        return []

    def over(self, k: int, t: float) -> tuple[float, float]:
        """Overlap [m] of gap k and its rate [m/s]."""
        return value_and_slope(self.series.over[k], t)

    def deepest(self, k: int, t: float) -> float:
        """m. Greatest overlap of gap k up to t."""
        series = self.series.over[k]
        over, rate = self.over(k, t)
        best = max(series[0], over)
        # A step that the end of the run leaves no time has no series beyond its start.
        rising = len(series) > 1 and series[1] > 0.0
        if rising and rate < 0.0 and (turn := first_fall(slope(series), t)) is not None:
            best = max(best, value(series, turn))
        return best

    def velocities(self, k: int, t: float) -> tuple[float, float]:
        """m/s. Of the bodies left and right of gap k."""
        return value(self.speed[k], t), value(self.speed[k + 1], t)

    def book(self, ledger: Ledger, t: float) -> None:
        """Impulses from outside and work, by name."""
        booking.cluster(ledger, self, t)

    def side(self, body: Body) -> float:
        """The body's place in the row."""
        return float(self.index(body))

    def index(self, body: Body) -> int:
        """Place of a body in the row."""
        return next(k for k, other in enumerate(self.bodies) if other is body)

    def shift(self, body: Body, start: Time, end: Time) -> float:
        """m. How far a body goes between two times within the step."""
        path = self.path[self.index(body)]
        a, b = elapsed(self.begun, start), elapsed(self.begun, end)
        return value(path, b) - (value(path, a) if a != 0.0 else 0.0)

    def velocity(self, body: Body, now: Time) -> float:
        """m/s."""
        return value(self.speed[self.index(body)], elapsed(self.begun, now))

    def excess(self, body: Body, start: Time, dt: float) -> float:
        """m. Displacement in dt s beyond that at the velocity of `start`."""
        path = self.path[self.index(body)]
        a = elapsed(self.begun, start)
        if a == 0.0:
            return value([0.0, 0.0, *path[2:]], dt)
        return value(path, a + dt) - value(path, a) - value(slope(path), a) * dt

    def speeds(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """Least and greatest velocity in the step, bounded by the coefficients."""
        speed = self.speed[self.index(body)]
        reach = size([0.0, *speed[1:]], self.duration)
        return speed[0] - reach, speed[0] + reach

    def acceleration(self, body: Body, now: Time) -> float:
        """m/s². Bound over the step."""
        return size(slope(self.speed[self.index(body)]), self.duration)

    def time_left(self, now: Time) -> float:
        """s to the end of the step."""
        return self.duration - elapsed(self.begun, now)
