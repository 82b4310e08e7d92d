"""Two neighbours between which everything is linear, under constant forces: a closed form, tier 1.

    mu o'' = −N + mu (a_A − a_B)         N = sum of kappa (o − rest) + gamma o', also of springs
    o'' + 2 beta o' + w0² (o − centre) = 0      a_A, a_B: constant forces on each, per mass
    V = V0 + A t                                of the common centre of mass

Beside a wall linear drag of the cart is a part of beta. It lasts as long as one branch of the
contact law does, and ends as a step of the power series does (`guards`). A cart that rests against
a wall on an incline, or that swings on a spring, takes one such phase however long it lasts. A wall
has infinite mass: V = 0.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from sim.dynamics.motion.guards import GRAZES, PUSH_ROUNDING, branch_of, guards_of
from sim.dynamics.motion.lasting import Pair
from sim.dynamics.motion.oscillation import Oscillation, rate_of
from sim.dynamics.motion.power_series.series import REACH, is_rounding
from sim.dynamics.motion.power_series.step_ends import FINAL
from sim.dynamics.motion.work_accounting import book_body_forces, book_from_wall
from sim.dynamics.state.body import Accounts, Body, End, Gap, GapRecord, PeakSoFar, kinds_of
from sim.dynamics.state.clock import Time, elapsed
from sim.dynamics.state.flips import NO_MOTION, margin
from sim.dynamics.state.loads import Load
from sim.effects.forces import at_touch
from sim.laws.branch import Branch, Guard
from sim.laws.damped_oscillation import Rate


@dataclass(slots=True)
class LinearPair(Pair):
    """One branch of a pair's motion from `begun`, for `duration` s."""

    bodies: list[Body]
    members: list[Gap]  # one
    begun: Time
    duration: float
    ends: list[End]
    branch: Branch
    between: Oscillation
    mu: float
    drift: tuple[float, float]  # m/s, m/s²: V0 and A
    pull: float  # m/s², a_A − a_B
    touched: list[bool]
    loads: list[Load]
    linked: list[tuple[str, ...]]
    drag: float = 0.0  # N s/m, linear, of the one body beside a wall
    name: str = "pair-phase"
    tier: int = 1
    parabolic: ClassVar[bool] = False
    short_steps: ClassVar[bool] = False
    fading: ClassVar[tuple[Rate, ...]] = ()

    @property
    def gaps(self) -> tuple[int, ...]:
        """The one gap."""
        return (self.members[0].index,)

    def marks(self, end: float) -> list[float]:
        """Every quarter swing."""
        return self.between.marks(end)

    def state(self, side: float, tau: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of the body with that share."""
        o, rate, a, _ = self.between.at(tau)
        v0, drift = self.drift
        displacement = (v0 + 0.5 * drift * tau) * tau + side * (o - self.between.o0)
        return displacement, v0 + drift * tau + side * rate, drift + side * a

    def shift(self, body: Body, start: Time, end: Time) -> float:
        """m. How far a body goes between two times in the phase."""
        a, b = elapsed(self.begun, start), elapsed(self.begun, end)
        side = self.side(body)
        return self.state(side, b)[0] - (self.state(side, a)[0] if a != 0.0 else 0.0)

    def velocity(self, body: Body, now: Time) -> float:
        """m/s. From the body's velocity at the start: unchanged to the last bit while o' is."""
        t = elapsed(self.begun, now)
        change = self.between.over(t)[1] - self.between.u
        return body.v + self.drift[1] * t + self.side(body) * change

    def excess(self, body: Body, start: Time, dt: float) -> float:
        """m. Displacement in dt s beyond that at the velocity of `start`."""
        a, side = elapsed(self.begun, start), self.side(body)
        o, rate = self.between.over(a)
        change = self.between.over(a + dt)[0] - o - rate * dt
        return 0.5 * self.drift[1] * dt * dt + side * change

    def speeds(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """As `Motion.speeds`: least and greatest from now on."""
        t = elapsed(self.begun, now)
        v0, drift = self.drift
        ends = (v0 + drift * t, v0 + drift * (t + horizon))
        reach = abs(self.side(body)) * self.between.fastest()
        return min(ends) - reach, max(ends) + reach

    def accelerations(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """m/s². Least and greatest from `now` on: what it is now, and what its rate can add."""
        bends = self.between.bends(elapsed(self.begun, now), horizon)
        ends = [self.drift[1] + self.side(body) * bend for bend in bends]
        return min(ends), max(ends)

    def force(self, gap: int, tau: float) -> tuple[float, float]:
        """N and dN/dt, of contact and springs: what moves the two besides constant forces."""
        _, rate, a, jerk = self.between.at(tau)
        force, growth = self.mu * (self.pull - a), -self.mu * jerk
        return (force - self.drag * rate, growth - self.drag * a) if self.drag else (force, growth)

    def _changed(self, t: float) -> float:
        """N s. Of contact and springs together, from the motion that they changed."""
        o, v = self.between.over(t)
        total = self.mu * (self.between.u - v) + self.mu * self.pull * t
        return total - self.drag * (o - self.between.o0)

    def _impulse(self, t: float) -> float:
        """N s. Of the contact. Overlaps on a steep line differ in their last figures only."""
        if not self.members[0].links:
            return self._changed(t)
        branch, gone = self.branch, self.between.over(t)[0] - self.between.o0
        return branch.gamma * gone + branch.kappa * (self.between.sum(t) - branch.rest * t)

    def locked(self, k: int) -> bool:
        """As `Motion.locked`: never, it moves."""
        return False

    def parts(self, t: float, *, peaks: bool) -> list[GapRecord]:
        """As `Motion.parts`: the one gap."""
        (gap,), between, branch = self.members, self.between, self.branch
        over, rate = between.over(t)
        summed = between.sum(t) if gap.loose else 0.0
        if gap.touching is None:
            return [GapRecord(over, rate, summed=summed)]
        seen: tuple[PeakSoFar, ...] = ()
        times = between.greatest(branch.kappa, branch.gamma, t) if peaks else ()
        forces = ((when, branch.force(*between.over(when))) for when in times)
        if (found := gap.touching.greatest(forces)) is not None:
            a, b = (self.state(self.side(body), found[0])[1] for body in self.bodies)
            seen = ((*found, self._impulse(found[0]), (a, b)),)
        loss = branch.gamma * between.damped(t) if branch.gamma else 0.0
        if gap.law is not None:
            loss += gap.law.kept(branch, between.o0, over)
        return [GapRecord(over, rate, self._impulse(t), loss, between.deepest(t), seen, summed)]

    def book(self, accounts: Accounts, t: float) -> None:
        """As `Motion.book`: impulses from outside and work, by name."""
        for body in self.bodies:
            if body.carts and body.mass < math.inf and body.load.forces:
                displacement = self.state(self.side(body), t)[0]
                square = self.between.damped(t) if self.drag else 0.0
                book_body_forces(accounts, body.load, t, displacement, (square, 0.0, 0.0))
        gap = self.members[0]
        for link in gap.links:
            if link.damping():
                accounts.work(link.kind, -link.damping() * self.between.damped(t))
        if gap.links:
            between, links = self.between, self._changed(t) - self._impulse(t)
            moved = between.over(t)[0] - between.o0
            book_from_wall(accounts, gap, links, t, lambda: (between.sum(t), moved))


def linear_pair(bodies: list[Body], gap: Gap, now: Time, limit: float) -> LinearPair | None:
    """The closed form of a pair settled at `now`, for at most `limit` s.

    None where that is no more than the beginning of a swing, one step of a series: its place of
    rest is far away then, and differences from it would cancel.
    """
    a, b = bodies
    branch, mu = branch_of(gap), gap.mu
    stiff, damp, free = branch.kappa, branch.gamma, at_touch(gap.links)
    if gap.links:
        bounds = [link.bounds(gap.room) for link in gap.links]
        stiff += math.fsum([k for k, _ in bounds])
        damp += math.fsum([c for _, c in bounds])
    drag = a.load.linear + b.load.linear  # one of them is a wall, or there is none
    rate = rate_of(stiff, damp + drag, mu)
    if rate.w0 * limit <= REACH:
        return None
    own = a.load.steady / a.mass
    pull = own - b.load.steady / b.mass
    if is_rounding(pull, own):
        pull = 0.0
    free -= branch.kappa * branch.rest
    between = Oscillation(rate, (mu * pull - free) / stiff, -gap.room, -gap.rate)
    total = a.mass + b.mass
    drift = (0.0, 0.0)
    if total < math.inf:
        drift = (
            (a.mass * a.v + b.mass * b.v) / total,
            (a.load.steady + b.load.steady) / total,
        )
    ends, duration = _first_ends(gap, branch, between, limit)
    return LinearPair(
        bodies, [gap], now, duration, ends, branch, between, mu, drift, pull,
        [gap.touching is not None], [a.load, b.load], [kinds_of(gap)], drag,
    )  # fmt: skip


def _first_ends(
    gap: Gap, branch: Branch, between: Oscillation, limit: float
) -> tuple[list[End], float]:
    ends: list[End] = []
    duration = limit
    for guard in guards_of(gap, branch):
        t = _happens(gap, branch, between, guard)
        step = 1.0 / between.rate.w0
        stays = guard.cause not in FINAL  # a contact that is taken up again stays on
        if stays and t <= NO_MOTION * step and (part := margin(gap, gap.time, step)):
            t = _happens(gap, branch, between, guard, part)
        if t <= duration:
            if t < duration:
                ends.clear()
            ends.append(End(guard.cause, 0))
            duration = t
    return ends, duration


def _happens(
    gap: Gap, branch: Branch, between: Oscillation, guard: Guard, part: float = 0.0
) -> float:
    """First t at which the guard's event happens, by more than `part` of the quantity's size."""
    c, sign, w = between.centre, -1.0 if guard.rises else 1.0, between.rate.w0
    speed = max(abs(gap.left.v), abs(gap.right.v))
    room = part * (math.hypot(between.o0 - c, between.u / w) + abs(between.o0) + speed / w)
    if guard.of == "force":
        none = branch.kappa * (branch.rest - c) - room * (branch.kappa + branch.gamma * w)
        turns = between.turns_at(branch.rest, GRAZES)  # laid on it: from twice its load to none
        return math.inf if turns else between.falls(branch.kappa, branch.gamma, none)
    if guard.of == "rate":
        return between.falls(0.0, 1.0, -room * w)
    if guard.of == "overlap":
        room = max(room, GRAZES * guard.level) if guard.cause == "climb" else room
        return between.falls(sign, 0.0, sign * (guard.level - c) - room)
    assert gap.law is not None
    k, damper = gap.law.stiffness, gap.law.damper(gap.mu)
    push = k * between.o0 + damper * between.u
    by = room * (k + damper * w)
    if abs(push) > PUSH_ROUNDING * k * between.o0:
        return between.falls(-k, -damper, k * c - by)
    return between.falls(-k, -damper, -k * (between.o0 - c) + -damper * between.u - by)
