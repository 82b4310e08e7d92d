"""Two neighbours between which everything is linear, under constant forces: a closed form, tier 1.

    mu o'' = −N + mu (a_A − a_B)         N = sum of kappa (o − rest) + gamma o', also of springs
    o'' + 2 beta o' + w0² (o − centre) = 0      a_A, a_B: constant forces on each, per mass
    V = V0 + A t                                of the common centre of mass

It lasts as long as one branch of the contact law does, and ends as a step of the power series does
(`watch`). A cart that rests against a wall on an incline, or that swings on a spring, takes one
such phase however long it lasts. A wall has infinite mass: V = 0.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from sim.dynamics.loop.recontact import PUSH_ROUNDING
from sim.dynamics.motion import guards as watch
from sim.dynamics.motion import work_accounting as booking
from sim.dynamics.motion.series import REACH, is_rounding
from sim.dynamics.motion.threshold import first_fall_to
from sim.dynamics.state.clock import Time, elapsed
from sim.laws.branch import Guard
from sim.laws.damped_oscillation import Rate, first_turn, solve

if TYPE_CHECKING:
    from sim.dynamics.result.ledger import Ledger
    from sim.dynamics.state.chain import Body, Gap
    from sim.dynamics.state.loads import Load
    from sim.laws.branch import Branch

FADED = 1e-4
"""Of the first swing. Fainter ones are not drawn one by one."""

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
class PairPhase:
    """One branch of a pair's motion from `begun`, at most `limit` s."""

    bodies: list[Body]
    members: list[Gap]  # one
    begun: Time
    limit: float
    branches: list[Branch] = field(init=False)
    touched: list[bool] = field(init=False)
    loads: list[Load] = field(init=False)
    rate: Rate = field(init=False)
    mu: float = field(init=False)
    start: tuple[float, float] = field(init=False)  # m, m/s: overlap and its rate
    centre: float = field(init=False)  # m
    drift: tuple[float, float] = field(init=False)  # m/s, m/s²: V0 and A
    pull: float = field(init=False)  # m/s², a_A − a_B
    duration: float = field(init=False)
    ends: list[watch.End] = field(init=False, default_factory=list)
    name = "pair-phase"
    tier = 1

    def __post_init__(self) -> None:
        gap, (a, b) = self.members[0], self.bodies
        branch = watch.branch_of(gap)
        self.branches, self.touched = [branch], [gap.touching is not None]
        self.loads = [a.load, b.load]
        self.mu = mu = gap.mu
        bounds = [link.bounds(gap.room) for link in gap.links]
        stiff = branch.kappa + math.fsum(k for k, _ in bounds)
        damp = branch.gamma + math.fsum(c for _, c in bounds)
        self.rate = rate_of(stiff, damp, mu)
        self.start = (-gap.room, -gap.rate)
        own = a.load.steady / a.mass
        self.pull = own - b.load.steady / b.mass
        if is_rounding(self.pull, own):
            self.pull = 0.0
        free = math.fsum(link.force(0.0, 0.0) for link in gap.links) - branch.kappa * branch.rest
        self.centre = (mu * self.pull - free) / stiff
        total = a.mass + b.mass
        if total == math.inf:
            self.drift = (0.0, 0.0)
        else:
            self.drift = (
                (a.mass * a.v + b.mass * b.v) / total,
                (a.load.steady + b.load.steady) / total,
            )
        self.duration = self.limit
        for guard in watch.guards_of(gap, branch):
            t = self._happens(gap, branch, guard)
            if t <= self.duration:
                if t < self.duration:
                    self.ends.clear()
                self.ends.append((guard.cause, 0))
                self.duration = t

    def _falls(self, over: float, rate: float, level: float) -> float:
        """First t at which over (o − centre) + rate o' falls to a level; it swings as o does."""
        y0, v0 = self.start[0] - self.centre, self.start[1]
        bend = -2.0 * self.rate.beta * v0 - self.rate.w0 * self.rate.w0 * y0
        return first_fall_to(self.rate, over * y0 + rate * v0, over * v0 + rate * bend, level)

    def _happens(self, gap: Gap, branch: Branch, guard: Guard) -> float:
        """First t at which the guard's event happens."""
        c, sign = self.centre, -1.0 if guard.rises else 1.0
        if guard.of == "force":
            return self._falls(branch.kappa, branch.gamma, branch.kappa * (branch.rest - c))
        if guard.of == "rate":
            return self._falls(0.0, 1.0, 0.0)
        if guard.of == "overlap":
            return self._falls(sign, 0.0, sign * (guard.level - c))
        assert gap.law is not None
        k, damper = gap.law.stiffness, gap.law.damper(gap.mu)
        y0, v0 = self.start[0] - c, self.start[1]
        push = k * self.start[0] + damper * v0
        none = abs(push) <= PUSH_ROUNDING * k * self.start[0]
        return self._falls(-k, -damper, -k * y0 + -damper * v0 if none else k * c)

    @property
    def swings(self) -> bool:
        """Long enough to be more than the beginning of a swing? That is one step of a series.

        Its place of rest is far away then, and differences from it would cancel.
        """
        return self.rate.w0 * self.limit > REACH

    @property
    def gaps(self) -> tuple[int, ...]:
        """The one gap."""
        return (self.members[0].index,)

    def at(self, t: float) -> tuple[float, float, float, float]:
        """o, o', o'', o''' at t."""
        y, v = solve(self.rate, self.start[0] - self.centre, self.start[1], t)
        twice, square = 2.0 * self.rate.beta, self.rate.w0 * self.rate.w0
        a = -twice * v - square * y
        return y + self.centre, v, a, -twice * a - square * v

    def over(self, k: int, t: float) -> tuple[float, float]:
        """Overlap and its rate; the bits of the start are kept at t = 0."""
        return self.start if t == 0.0 else self.at(t)[:2]

    def deepest(self, k: int, t: float) -> float:
        """m. Greatest overlap up to t."""
        turn = first_turn(self.rate, self.start[0] - self.centre, self.start[1])
        best = max(self.start[0], self.over(k, t)[0])
        return max(best, self.at(turn)[0]) if self.start[1] > 0.0 and turn < t else best

    def side(self, body: Body) -> float:
        """Signed share in the overlap: +mu/m for the left body, −mu/m for the right one."""
        return self.mu / body.mass if body is self.bodies[0] else -self.mu / body.mass

    def state(self, place: float, tau: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of the body with that share."""
        o, rate, a, _ = self.at(tau)
        v0, drift = self.drift
        way = (v0 + 0.5 * drift * tau) * tau + place * (o - self.start[0])
        return way, v0 + drift * tau + place * rate, drift + place * a

    def shift(self, body: Body, start: Time, end: Time) -> float:
        """m. How far a body goes between two times in the phase."""
        a, b = elapsed(self.begun, start), elapsed(self.begun, end)
        side = self.side(body)
        return self.state(side, b)[0] - (self.state(side, a)[0] if a != 0.0 else 0.0)

    def velocity(self, body: Body, now: Time) -> float:
        """m/s. From the body's velocity at the start: unchanged to the last bit while o' is."""
        t = elapsed(self.begun, now)
        change = self.over(0, t)[1] - self.start[1]
        return body.v + self.drift[1] * t + self.side(body) * change

    def excess(self, body: Body, start: Time, dt: float) -> float:
        """m. Displacement in dt s beyond that at the velocity of `start`."""
        a, side = elapsed(self.begun, start), self.side(body)
        o, rate = self.over(0, a)
        change = self.over(0, a + dt)[0] - o - rate * dt
        return 0.5 * self.drift[1] * dt * dt + side * change

    def _fastest(self) -> float:
        """m/s. Bound on |o'|: that energy never grows."""
        return math.hypot(self.start[1], self.rate.w0 * (self.start[0] - self.centre))

    def speeds(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """Least and greatest velocity from now on."""
        t = elapsed(self.begun, now)
        v0, drift = self.drift
        ends = (v0 + drift * t, v0 + drift * (t + horizon))
        reach = abs(self.side(body)) * self._fastest()
        return min(ends) - reach, max(ends) + reach

    def acceleration(self, body: Body, now: Time) -> float:
        """m/s². Bound over the phase."""
        swing = (self.rate.w0 + 2.0 * self.rate.beta) * self._fastest()
        return abs(self.drift[1]) + abs(self.side(body)) * swing

    def time_left(self, now: Time) -> float:
        """s to the end of the phase."""
        return self.duration - elapsed(self.begun, now)

    def _sum(self, t: float) -> float:
        """m s. Integral of the overlap up to t, from the equation of motion."""
        (o0, u), (o, v) = self.start, self.over(0, t)
        changed = v - u + 2.0 * self.rate.beta * (o - o0)
        return self.centre * t - changed / (self.rate.w0 * self.rate.w0)

    def impulse(self, k: int, t: float) -> float:
        """N s. Of the contact."""
        branch = self.branches[0]
        gone = self.over(0, t)[0] - self.start[0]
        return branch.kappa * (self._sum(t) - branch.rest * t) + branch.gamma * gone

    def contact_force(self, k: int, t: float) -> float:
        """N. Of the contact."""
        return self.branches[0].force(*self.over(0, t))

    def greatest(self, k: int, t: float) -> list[float]:
        """Times up to t at which the contact's force may be greatest."""
        y0, v0 = self.start[0] - self.centre, self.start[1]
        branch, w0, beta = self.branches[0], self.rate.w0, self.rate.beta
        bend = -2.0 * beta * v0 - w0 * w0 * y0
        growth = branch.kappa * v0 + branch.gamma * bend
        third = -2.0 * beta * bend - w0 * w0 * v0
        if growth <= 0.0:
            return [0.0, t]
        turn = first_fall_to(self.rate, growth, branch.kappa * bend + branch.gamma * third, 0.0)
        return [0.0, turn, t] if turn < t else [0.0, t]

    def force(self, gap: int, tau: float) -> tuple[float, float]:
        """N and dN/dt, of contact and springs: what moves the two besides constant forces."""
        _, _, a, jerk = self.at(tau)
        return self.mu * (self.pull - a), -self.mu * jerk

    def velocities(self, k: int, t: float) -> tuple[float, float]:
        """m/s. Of the left and the right body."""
        a, b = (self.state(self.side(body), t)[1] for body in self.bodies)
        return a, b

    def damped(self, t: float) -> float:
        """m²/s. Integral of o'² up to t, from what the oscillation has lost."""
        if self.rate.beta == 0.0:
            return 0.0
        (o0, u), (o, v) = self.start, self.over(0, t)
        y0, y, square = o0 - self.centre, o - self.centre, self.rate.w0 * self.rate.w0
        return ((u - v) * (u + v) + square * (y0 - y) * (y0 + y)) / (4.0 * self.rate.beta)

    def warmed(self, k: int, t: float) -> float:
        """J. What the contact does not give back, up to t."""
        gap, branch = self.members[0], self.branches[0]
        loss = branch.gamma * self.damped(t) if branch.gamma else 0.0
        if gap.law is None:
            return loss
        return loss + gap.law.kept(branch, self.start[0], self.over(0, t)[0])

    def book(self, ledger: Ledger, t: float) -> None:
        """Impulses from outside and work, by name."""
        booking.pair_phase(ledger, self, t)

    def marks(self, end: float) -> list[float]:
        """Every quarter swing up to `end` s, while it is worth drawing."""
        rate = self.rate
        quarter = 0.5 * math.pi / (rate.w if rate.regime == "under" else rate.w0)
        if rate.beta > 0.0:
            end = min(end, -math.log(FADED) / rate.beta + quarter)
        return [quarter * (n + 1) for n in range(min(MOST_MARKS, int(end / quarter)))]
