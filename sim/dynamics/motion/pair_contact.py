"""One contact between two neighbours, in closed form, as long as nobody else touches them.

    A (mass mA) --> N N <-- B (mass mB)        force on A: −N, force on B: +N, one number

With V the velocity of the common centre of mass and d the overlap:

    v_A = V + (mu/mA) d'      x_A(t) = x_A(0) + V t + (mu/mA) (d − d0)
    v_B = V − (mu/mB) d'      x_B(t) = x_B(0) + V t − (mu/mB) (d − d0)

A wall has infinite mass: V = 0, mu is the cart's mass, and the wall's share of d is nought.
From first touch the outcome is taken from the law's figures, v' = V + e (V − v): exact to the
last bit or two. From any other start (a contact resumed, an overlap at the beginning) it is taken
from the end of the last stretch.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import ClassVar

from sim.dynamics.motion.lasting import Lasting
from sim.dynamics.motion.safe_step import SLACK
from sim.dynamics.state.body import Accounts, Body, End, Gap, GapRecord, PeakSoFar
from sim.dynamics.state.clock import Time, elapsed
from sim.laws.contact_law import ContactLaw, IsolatedContact
from sim.laws.damped_oscillation import Rate, Swing, first_turn, greatest_force

FAR = 1e300
"""s. In place of infinity for a contact that never ends: everything has faded there."""


@dataclass(slots=True)
class PairContact(Lasting):
    """A contact that began at `begun` with overlap d0 and approach speed u."""

    bodies: list[Body]
    members: list[Gap]  # one
    law: ContactLaw
    mu: float  # kg
    begun: Time
    d0: float  # m
    u: float  # m/s
    memory: float  # m, of the bumper, before this contact
    velocity_of_centre: float  # m/s, V
    shares: tuple[float, float]  # mu/mA, mu/mB
    figures: IsolatedContact | None  # where it starts from first touch
    duration: float = field(init=False)
    _stretches: tuple[Swing, ...] | None = field(init=False, default=None)
    gap: int = field(init=False)
    ends: ClassVar[list[End]] = [End("apart", 0)]
    name = "pair-contact"
    tier = 1
    parabolic = False
    short_steps = False

    def __post_init__(self) -> None:
        self.gap = self.members[0].index
        if self.figures is not None:
            self.duration = self.figures.duration
        else:
            self.duration = math.fsum(swing.duration for swing in self.stretches)

    @property
    def stretches(self) -> tuple[Swing, ...]:
        """The closed form, made when first asked for: a run that is only counted never asks."""
        if self._stretches is None:
            self._stretches = self.law.stretches(self.mu, self.d0, self.u, self.memory)
        return self._stretches

    @property
    def gaps(self) -> tuple[int]:
        """The one gap."""
        return (self.gap,)

    def at(self, tau: float) -> tuple[float, float, float, float]:
        """d, d', d'', d''' at tau s after the contact began."""
        stretches = self.stretches
        for swing in stretches:  # a stretch holds at its own end: the last force, not the next
            if tau <= swing.start + swing.duration or swing is stretches[-1]:
                return swing.at(max(tau, swing.start))
        return self.d0, self.u, 0.0, 0.0

    def out(self) -> tuple[float, float]:
        """Separation speed and overlap left at the end."""
        if self.figures is not None:
            return self.figures.e * self.u, self.figures.out_overlap * self.u
        if not self.stretches:
            return -self.u, self.d0
        d, v = self.stretches[-1].end()
        return max(-v, 0.0), max(d, 0.0)  # what ends is over: by rounding e = 0 would close again

    def overlap(self, tau: float) -> float:
        """d at tau; at the ends without evaluating the closed form."""
        if tau <= 0.0:
            return self.d0
        return self.out()[1] if tau >= self.duration else self.at(tau)[0]

    def first_force(self) -> float:
        """N just after the contact began."""
        if self.figures is not None:
            return self.figures.first_force * self.u
        return -self.mu * self.at(0.0)[2]

    def last_force(self) -> float:
        """N just before the contact ends."""
        if self.figures is not None:
            return self.figures.last_force * self.u
        return -self.mu * self.stretches[-1].at(self.duration)[2] if self.stretches else 0.0

    def deepest_until(self, tau: float) -> float:
        """m. Greatest overlap in the first tau seconds."""
        if tau >= self.duration:
            return self.greatest_overlap()
        best = max(self.d0, self.at(tau)[0])
        for swing in self.stretches:
            if swing.start < tau:
                best = max(best, swing.at(min(swing.start + _turn(swing), tau))[0])
        return best

    def greatest_overlap(self) -> float:
        """m. Over the whole contact."""
        if self.figures is not None:
            return self.figures.peak_overlap * self.u
        best = self.d0
        for swing in self.stretches:
            d, _ = swing.end()
            best = max(best, d, swing.at(swing.start + _turn(swing))[0])
        return best

    def side(self, body: Body) -> float:
        """Signed share of a body in the overlap: x = x0 + V t + side (d − d0)."""
        return self.shares[0] if self.gap == body.right else -self.shares[1]

    def shift(self, body: Body, start: Time, end: Time) -> float:
        """m. How far a body goes between two times in the contact."""
        a, b = elapsed(self.begun, start), elapsed(self.begun, end)
        return self.velocity_of_centre * (b - a) + self.side(body) * (
            self.overlap(b) - self.overlap(a)
        )

    def velocity(self, body: Body, now: Time) -> float:
        """m/s. From the body's velocity at touch: unchanged to the last bit while d' is."""
        return body.v + self.side(body) * (self.at(elapsed(self.begun, now))[1] - self.u)

    def excess(self, body: Body, start: Time, dt: float) -> float:
        """m. Displacement in dt s beyond that at the velocity of `start`."""
        a = elapsed(self.begun, start)
        d, v, _, _ = self.at(a) if a > 0.0 else (self.d0, self.u, 0.0, 0.0)
        return self.side(body) * (self.at(a + dt)[0] - d - v * dt)

    def speeds(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """Least and greatest velocity: |d'| never exceeds all the energy in motion."""
        fastest = math.hypot(self.u, self.d0 * math.sqrt(self.law.stiffness / self.mu))
        reach = abs(self.side(body)) * fastest
        return self.velocity_of_centre - reach, self.velocity_of_centre + reach

    def accelerations(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """m/s². Bounds from `now` on: where it fades, what was at first would bound nothing."""
        tau, swings = elapsed(self.begun, now), self.stretches
        if swings and swings[-1].rate.beta > 0.0 and tau > swings[-1].start:
            bend = swings[-1].strongest_from(tau)
        else:
            bend = max(self.peak()[1] / self.mu, abs(self.at(min(self.duration, FAR))[2]))
        bend *= abs(self.side(body)) * SLACK
        return -bend, bend

    def state(self, side: float, tau: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of the body with that side, tau s after the start."""
        d, v, a, _ = self.at(tau)
        centre = self.velocity_of_centre
        return centre * tau + side * (d - self.d0), centre + side * v, side * a

    def force(self, gap: int, tau: float) -> tuple[float, float]:
        """N and dN/dt."""
        _, _, a, j = self.at(tau)
        return -self.mu * a, -self.mu * j

    def marks(self, end: float) -> list[float]:
        """s after the start, where the formula changes."""
        return [swing.start for swing in self.stretches[1:]]

    @property
    def fading(self) -> tuple[Rate, ...]:
        """Rates of its damped stretches."""
        return tuple(swing.rate for swing in self.stretches if swing.rate.beta > 0.0)

    def book(self, accounts: Accounts, t: float) -> None:
        """As `Motion.book`: nothing but the contact acts."""

    def locked(self, k: int) -> bool:
        """It moves."""
        return False

    def parts(self, t: float, *, peaks: bool) -> list[GapRecord]:
        """As `Motion.parts`: up to a moment in the middle of it."""
        d, v, _, _ = self.at(t)
        deepest = self.deepest_until(t)
        memory = self.law.remember(deepest, self.memory)
        given = 0.5 * self.mu * (self.u - v) * (self.u + v)
        before = self.law.stored(self.d0, self.u, self.memory)
        return [
            GapRecord(
                d,
                v,
                self.mu * (self.u - v),
                given + before - self.law.stored(d, v, memory),
                deepest,
                (self.peak_until(t),) if peaks else (),
            )
        ]

    def peak_until(self, t: float) -> PeakSoFar:
        """The greatest force of the first t seconds."""
        when, force, rate = self.peak()
        if when > t:
            _, rate, a, _ = self.at(t)
            when, force = t, -self.mu * a
        change = self.u - rate
        left, right = self.bodies
        a, b = self.shares
        return when, force, self.mu * change, (left.v - a * change, right.v + b * change)

    def peak(self) -> tuple[float, float, float]:
        """Time after the beginning, N, and d' of the greatest force."""
        if self.figures is not None:
            f = self.figures
            return f.peak_time, f.peak_force * self.u, f.peak_rate * self.u
        tau = greatest_force(self.stretches)
        _, v, a, _ = self.at(tau)
        return tau, -self.mu * a, v


def _turn(swing: Swing) -> float:
    """Where the overlap of a stretch is greatest, in s after its start."""
    if swing.v0 <= 0.0:
        return 0.0
    return min(first_turn(swing.rate, swing.y0, swing.v0), swing.duration)
