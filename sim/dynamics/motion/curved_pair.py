"""One contact by a law that is not linear, between two bodies that nothing else touches, tier 1.

    mu d'' = −N(d, d')        v_A = V + (mu/mA) d'        v_B = V − (mu/mB) d'

The law knows d(t) from any start (`Alone`); impulse and losses follow from d and d'.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar, Protocol, runtime_checkable

from sim.dynamics.motion.impact import outgoing
from sim.dynamics.motion.lasting import Pair
from sim.dynamics.motion.safe_step import SLACK
from sim.dynamics.state.body import Accounts, Body, End, Gap, GapRecord
from sim.dynamics.state.clock import Time, elapsed
from sim.dynamics.state.loads import Load
from sim.laws.damped_oscillation import Rate


class Course(Protocol):
    """Overlap d [m] and rate d' [m/s] of a contact that is alone."""

    @property
    def duration(self) -> float:
        """s; may be inf."""

    @property
    def fresh(self) -> bool:
        """Does it begin at no overlap?"""

    @property
    def e(self) -> float:
        """Restitution."""

    @property
    def d0(self) -> float:
        """m at the start."""

    @property
    def u(self) -> float:
        """m/s at the start."""

    def at(self, t: float) -> tuple[float, float]:
        """d and d'."""

    def force(self, d: float, v: float) -> tuple[float, float]:
        """N, and its growth [N/s] at no acceleration."""

    def damping(self, d: float) -> float:
        """N s/m."""

    def deepest(self) -> tuple[float, float]:
        """s and m."""

    def marks(self, end: float) -> list[float]:
        """Times up to `end` between which it can be drawn."""

    def greatest_force(self) -> float:
        """s."""

    def strongest(self) -> float:
        """N."""


@runtime_checkable
class HasCourse(Protocol):
    """A contact law that knows the course of a pair by itself."""

    def alone(self, mu: float, d: float, v: float) -> Course | None:
        """From overlap d and rate v; None where it is not known well enough."""


@dataclass(frozen=True, slots=True)
class CurvedPair(Pair):
    """A contact from `begun` for `duration` s."""

    bodies: list[Body]
    members: list[Gap]  # one
    begun: Time
    duration: float
    ends: list[End]
    course: Course
    mu: float
    velocity_of_centre: float
    touched: list[bool]
    loads: list[Load]
    name: str = "pair-contact"
    tier: int = 1
    parabolic: ClassVar[bool] = False
    short_steps: ClassVar[bool] = False
    fading: ClassVar[tuple[Rate, ...]] = ()

    @property
    def gap(self) -> int:
        """Its index in the chain."""
        return self.members[0].index

    @property
    def gaps(self) -> tuple[int, ...]:
        """The one gap."""
        return (self.gap,)

    def marks(self, end: float) -> list[float]:
        """Between which it can be drawn."""
        return self.course.marks(end)

    def state(self, side: float, tau: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of the body with that share."""
        d, v = self.course.at(tau)
        centre = self.velocity_of_centre
        a = -self.course.force(d, v)[0] / self.mu
        return centre * tau + side * (d - self.course.d0), centre + side * v, side * a

    def shift(self, body: Body, start: Time, end: Time) -> float:
        """m. How far a body goes between two times in the contact."""
        a, b = elapsed(self.begun, start), elapsed(self.begun, end)
        stretched = self.course.at(b)[0] - self.course.at(a)[0]
        return self.velocity_of_centre * (b - a) + self.side(body) * stretched

    def velocity(self, body: Body, now: Time) -> float:
        """m/s. Unchanged to the last bit while d' is; after a whole contact v' = V + e (V − v)."""
        t, course = elapsed(self.begun, now), self.course
        if t < course.duration or not course.fresh:
            return body.v + self.side(body) * (course.at(t)[1] - course.u)
        left, right = self.bodies
        if math.inf in (left.mass, right.mass):
            return -course.e * body.v
        return outgoing(left.mass, right.mass, left.v, right.v, course.e)[body is right]

    def excess(self, body: Body, start: Time, dt: float) -> float:
        """m. Displacement in dt s beyond that at the velocity of `start`."""
        a = elapsed(self.begun, start)
        d, v = self.course.at(a)
        return self.side(body) * (self.course.at(a + dt)[0] - d - v * dt)

    def speeds(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """Least and greatest velocity: |d'| never exceeds all the energy in motion."""
        law, course = self.members[0].law, self.course
        stored = 0.0 if law is None else law.stored(course.d0, course.u, 0.0)
        reach = abs(self.side(body)) * math.hypot(course.u, math.sqrt(2.0 * stored / self.mu))
        return self.velocity_of_centre - reach * SLACK, self.velocity_of_centre + reach * SLACK

    def accelerations(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """m/s². Bounds over the contact."""
        bound = abs(self.side(body)) * self.course.strongest() / self.mu * SLACK
        return -bound, bound

    def force(self, gap: int, tau: float) -> tuple[float, float]:
        """N and dN/dt."""
        d, v = self.course.at(tau)
        force, growth = self.course.force(d, v)
        return force, growth - self.course.damping(d) * force / self.mu

    def book(self, accounts: Accounts, t: float) -> None:
        """As `Motion.book`: nothing but the contact acts."""

    def locked(self, k: int) -> bool:
        """It moves."""
        return False

    def parts(self, t: float, *, peaks: bool) -> list[GapRecord]:
        """As `Motion.parts`: the one gap."""
        (gap,), course = self.members, self.course
        d, v = course.at(t)
        seen = []
        top = course.greatest_force() if peaks else math.inf
        for when in (0.0, *((top,) if 0.0 < top < t else ()), t) if peaks else ():
            over, rate = course.at(when)
            a, b = (body.v + self.side(body) * (rate - course.u) for body in self.bodies)
            seen.append((when, course.force(over, rate)[0], self.mu * (course.u - rate), (a, b)))
        law = gap.law
        assert law is not None
        lost = law.stored(course.d0, course.u, 0.0) - law.stored(d, v, 0.0)
        lost += 0.5 * self.mu * (course.u - v) * (course.u + v)
        when, most = course.deepest()
        deepest = most if when <= t else max(d, course.d0)
        return [GapRecord(d, v, self.mu * (course.u - v), lost, deepest, tuple(seen))]


def curved_pair(bodies: list[Body], gap: Gap, now: Time, limit: float) -> CurvedPair | None:
    """The closed form of a pair settled at `now`, for at most `limit` s; None: none is known."""
    if not isinstance(gap.law, HasCourse):
        return None
    course = gap.law.alone(gap.mu, max(-gap.room, 0.0), -gap.rate)
    if course is None:
        return None
    a, b = bodies
    centre = 0.0
    if math.inf not in (a.mass, b.mass):
        centre = (a.mass * a.v + b.mass * b.v) / (a.mass + b.mass)
    ends = [End("apart", 0)] if course.duration <= limit else []
    duration, loads = min(course.duration, limit), [a.load, b.load]
    return CurvedPair(bodies, [gap], now, duration, ends, course, gap.mu, centre, [True], loads)
