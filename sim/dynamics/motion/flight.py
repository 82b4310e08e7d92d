"""One body that nobody touches, on its course under forces of its own (`courses`).

Every velocity here is monotone in time and every |acceleration| falls or stays. A body that slides
under friction ends its flight where v = 0.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import ClassVar

from sim.dynamics.motion.courses import Course
from sim.dynamics.motion.lasting import Lasting
from sim.dynamics.state.body import Accounts, Body, End, Gap, GapRecord
from sim.dynamics.state.clock import Time, elapsed
from sim.dynamics.state.loads import Load
from sim.effects.forces import FRICTION
from sim.laws.damped_oscillation import Rate


@dataclass(slots=True)
class Flight(Lasting):
    """A body on its course since `begun`."""

    body: Body
    begun: Time
    v0: float
    load: Load
    sliding: int  # direction in which friction sees it slide; 0: no friction
    course: Course
    duration: float = field(init=False)
    carts: tuple[int, ...] = field(init=False)  # a body may grow or split later
    bodies: list[Body] = field(init=False)
    members: ClassVar[list[Gap]] = []
    ends: ClassVar[list[End]] = [End("halt", 0)]
    name = "flight"
    tier = 0
    gaps: ClassVar[tuple[int, ...]] = ()
    short_steps = False
    fading: ClassVar[tuple[Rate, ...]] = ()

    def __post_init__(self) -> None:
        self.carts, self.bodies = self.body.carts, [self.body]
        self.duration = self.course.halt() if self.load.static > 0.0 else math.inf

    def shift(self, body: Body, start: Time, end: Time) -> float:
        """m. How far it goes between two times."""
        a, b = elapsed(self.begun, start), elapsed(self.begun, end)
        return self.course.at(b)[0] - (self.course.at(a)[0] if a != 0.0 else 0.0)

    def velocity(self, body: Body, now: Time) -> float:
        """m/s."""
        return self.course.at(elapsed(self.begun, now))[1]

    def excess(self, body: Body, start: Time, dt: float) -> float:
        """m. Displacement in dt s beyond that at the velocity of `start`."""
        a = elapsed(self.begun, start)
        x, v, acceleration = self.course.at(a)
        if self.course.sparse:
            return 0.5 * acceleration * dt * dt
        return self.course.at(a + dt)[0] - x - v * dt

    def speeds(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """As `Motion.speeds`: least and greatest from `now` on, as it is monotone."""
        t = elapsed(self.begun, now)
        here, there = self.course.at(t)[1], self.course.at(t + horizon)[1]
        return min(here, there), max(here, there)

    def accelerations(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """Least and greatest from `now` on: a follows from v, falls where v grows, and v is
        monotone."""
        t = elapsed(self.begun, now)
        here, there = self.course.at(t)[2], self.course.at(t + horizon)[2]
        return min(here, there), max(here, there)

    def state(self, side: float, tau: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²]."""
        return self.course.at(tau)

    def force(self, gap: int, tau: float) -> tuple[float, float]:
        """As `Motion.force`: 0, nobody touches it."""
        return 0.0, 0.0

    def marks(self, end: float) -> list[float]:
        """s. As the course has them."""
        return self.course.marks(end)

    @property
    def parabolic(self) -> bool:
        """As the course is."""
        return self.course.sparse

    def locked(self, k: int) -> bool:
        """As `Motion.locked`: no contact."""
        return False

    def parts(self, t: float, *, peaks: bool) -> list[GapRecord]:
        """As `Motion.parts`: none, nobody touches it."""
        return []

    def side(self, body: Body) -> float:
        """As `Motion.side`: it is alone."""
        return 0.0

    def book(self, accounts: Accounts, t: float) -> None:
        """What drag took follows from the change of velocity and of kinetic energy."""
        load, course, mass = self.load, self.course, self.body.mass
        displacement, v, _ = course.at(t)
        force = load.steady - self.sliding * load.kinetic
        slowed = force * t - mass * (v - self.v0)  # N s, taken by drag
        taken = force * displacement - 0.5 * mass * (v - self.v0) * (v + self.v0)  # J
        total = load.linear + load.quadratic
        for one in load.forces:
            share = (one.linear + one.quadratic) / total if total else 0.0  # or all of one kind
            accounts.push_from_outside(one.steady * t - share * slowed, one.kind)
            accounts.work(one.kind, one.steady * displacement - share * taken)
        if load.kinetic:
            accounts.push_from_outside(-self.sliding * load.kinetic * t, FRICTION)
            accounts.work(FRICTION, -self.sliding * load.kinetic * displacement)
