"""A row in which all is linear for a while: its motion as a sum of modes, however long it lasts.

It takes over from the power series where that has taken some steps in which nothing happened, and
hands back before anything happens: the series finds the event itself. So its end is a time up to
which none of the quantities that are positive while the formulas hold can have fallen to zero
(`modal_sum.clear_until`), and the cost depends on what swings, not on how long. The row has come
to rest when what still swings is rounding; it ends there too, so that rest is recognised.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from typing import ClassVar

from sim.dynamics.motion.lasting import Row
from sim.dynamics.motion.modes.forces import contact_sums, others
from sim.dynamics.motion.modes.guards import guarded
from sim.dynamics.motion.modes.modal_sum import ModalSum, clear_until, maximum, plus
from sim.dynamics.motion.modes.state import ModalState, modal_state
from sim.dynamics.motion.power_series.series import SettledRow, step_length
from sim.dynamics.motion.rest import QUIET
from sim.dynamics.motion.work_accounting import book_body_forces, book_from_wall
from sim.dynamics.state.body import Accounts, Body, End, Gap, GapRecord, kinds_of
from sim.dynamics.state.clock import Time, elapsed
from sim.dynamics.state.loads import Load
from sim.effects.forces import FRICTION
from sim.laws.branch import Branch
from sim.laws.damped_oscillation import Rate

WORTH = 6.0
"""Steps of a series that a sum of modes has to be worth."""

LOOKS = 3000
"""At one quantity, for its next zero. A row that swings on gets so far, and forms anew."""

CLEAR = 1e-9
"""Of all that adds up to a quantity. Nearer to zero than that it has no sign as a sum."""


@dataclass(frozen=True, slots=True)
class ModalGroup(Row):
    """A row of bodies from `begun`, for `duration` s; nothing happens in it."""

    bodies: list[Body]
    members: list[Gap]
    begun: Time
    duration: float
    sums: ModalState
    branches: list[Branch]
    contact: list[ModalSum]  # N
    across: list[ModalSum]  # N, of springs
    steady: list[float]  # N on each body
    step: float  # s, of the series that it stands for
    touched: list[bool]
    loads: list[Load]
    linked: list[tuple[str, ...]]
    ends: list[End]  # who halts, where all has come to rest
    name: ClassVar[str] = "modes"
    tier: ClassVar[int] = 2
    parabolic: ClassVar[bool] = False
    short_steps: ClassVar[bool] = False
    fading: ClassVar[tuple[Rate, ...]] = ()

    def marks(self, end: float) -> list[float]:
        """Every quarter swing of the fastest mode that has not faded."""
        speeds = self.sums.speed
        top = max((speed.bound(0.0, 0) for speed in speeds), default=0.0)
        amplitudes: dict[complex, float] = {}
        for z, a in (term for speed in speeds for term in speed.terms):
            amplitudes[z] = max(amplitudes.get(z, 0.0), abs(a))
        swings = sorted(amplitudes.items(), key=lambda swing: -abs(swing[0]))
        found: list[float] = []
        t = 0.0
        while len(found) < MOST_MARKS:
            rate = next((abs(z) for z, a in swings if a * math.exp(z.real * t) > FADED * top), 0.0)
            if rate == 0.0:
                break
            t += 0.5 * math.pi / rate
            if t >= end:
                break
            found.append(t)
        return found

    def state(self, side: float, tau: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of the body at that place in the row."""
        speed = self.sums.speed[int(side)]
        return (speed.integral(tau), *speed.both(tau))

    def shift(self, body: Body, start: Time, end: Time) -> float:
        """m. How far a body goes between two times."""
        speed = self.sums.speed[self.place(body)]
        a, b = elapsed(self.begun, start), elapsed(self.begun, end)
        return speed.integral(b) - (speed.integral(a) if a != 0.0 else 0.0)

    def velocity(self, body: Body, now: Time) -> float:
        """m/s; the bits of the start are kept."""
        t = elapsed(self.begun, now)
        return body.v if t == 0.0 else self.sums.speed[self.place(body)].value(t)

    def excess(self, body: Body, start: Time, dt: float) -> float:
        """m. Displacement in dt s beyond that at the velocity of `start`."""
        speed, a = self.sums.speed[self.place(body)], elapsed(self.begun, start)
        before = speed.integral(a) if a != 0.0 else 0.0
        return speed.integral(a + dt) - before - speed.value(a) * dt

    def speeds(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """As `Motion.speeds`: least and greatest from now on."""
        speed, t = self.sums.speed[self.place(body)], elapsed(self.begun, now)
        ends = [speed.constant + speed.growth * one for one in (t, t + horizon)]
        reach = speed.bound(t, 0)
        return min(ends) - reach, max(ends) + reach

    def accelerations(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """As `Motion.accelerations`: m/s², least and greatest from now on."""
        speed, t = self.sums.speed[self.place(body)], elapsed(self.begun, now)
        return speed.growth - speed.bound(t, 1), speed.growth + speed.bound(t, 1)

    def force(self, gap: int, tau: float) -> tuple[float, float]:
        """As `Motion.force`: N and dN/dt of a gap of the chain."""
        k = self.gaps.index(gap)
        return plus((1.0, self.contact[k]), (1.0, self.across[k])).both(tau)

    def locked(self, k: int) -> bool:
        """As `Motion.locked`: the branch of its law says so."""
        return self.branches[k].locked

    def parts(self, t: float, *, peaks: bool) -> list[GapRecord]:
        """As `Motion.parts`: gap by gap."""
        found, least = [], NOTHING_WITHIN * self.step
        for k, gap in enumerate(self.members):
            over, force, branch = self.sums.over[k], self.contact[k], self.branches[k]
            o, rate = over.both(t)
            summed = over.integral(t) if gap.loose else 0.0
            if gap.touching is None:
                found.append(GapRecord(o, rate, summed=summed))
                continue
            seen = []
            for when in (0.0, maximum(force, t, least, LOOKS), t) if peaks else ():
                left, right = (self.sums.speed[i].value(when) for i in (k, k + 1))
                seen.append((when, force.value(when), force.integral(when), (left, right)))
            kept = branch.gamma * over.slope.square_integral(t) if branch.gamma else 0.0
            if gap.law is not None:
                kept += gap.law.kept(branch, -gap.room, o)
            deepest = max(-gap.room, over.value(maximum(over, t, least, LOOKS)))
            found.append(GapRecord(o, rate, force.integral(t), kept, deepest, tuple(seen), summed))
        return found

    def book(self, accounts: Accounts, t: float) -> None:
        """As `Motion.book`: impulses from outside and work, by name."""
        for i, body in enumerate(self.bodies):
            load, speed = body.load, self.sums.speed[i]
            if not body.carts or not (load.forces or load.grips):
                continue
            displacement = speed.integral(t)
            square = speed.square_integral(t) if load.linear else 0.0
            book_body_forces(accounts, load, t, displacement, (square, 0.0, 0.0))
            if body.held:
                held = others(i, load, self.contact, self.across)
                accounts.push_from_outside(-held.integral(t), FRICTION)
            elif load.kinetic and body.sliding:
                force = self.steady[i] - load.steady
                accounts.push_from_outside(force * t, FRICTION)
                accounts.work(FRICTION, force * displacement)
        for k, gap in enumerate(self.members):
            for link in gap.links:
                if damping := link.damping():
                    lost = damping * self.sums.over[k].slope.square_integral(t)
                    accounts.work(link.kind, -lost)
            if gap.links:
                moved = partial(self._moved, k, t)
                book_from_wall(accounts, gap, self.across[k].integral(t), t, moved)

    def _moved(self, k: int, t: float) -> tuple[float, float]:
        return (over := self.sums.over[k]).integral(t), over.value(t) - over.value(0.0)


FADED = 1e-4
"""Of the greatest speed. Fainter swings are not drawn one by one."""

MOST_MARKS = 2000
"""Quarter swings drawn one by one."""

NOTHING_WITHIN = 0.01
"""Of a step of the series. Two maxima are not so close."""


def modal_group(
    bodies: list[Body], gaps: list[Gap], row: SettledRow, now: Time, limit: float
) -> ModalGroup | None:
    """The row, settled at `now` and judged, as a sum of modes for at most `limit` s.

    None where it is none, where that is not well told, and where something happens soon.
    """
    step = step_length(row)
    if row.nonlinear or limit <= WORTH * step or not step < math.inf:
        return None
    state = modal_state(bodies, gaps, row)
    forces = contact_sums(bodies, gaps, row, state) if state is not None else None
    if state is None or forces is None:
        return None
    contact, across = forces
    rest = _to_rest(state, step)
    duration = min(limit, rest)
    if duration < WORTH * step:
        return None
    positive = list(guarded(bodies, gaps, row, state, contact, across))
    for quantity in positive:  # whether it is worth while costs little; how far it goes, much more
        if not quantity.value(0.0) > CLEAR * quantity.size:
            return None
        if clear_until(quantity, WORTH * step, step, LOOKS) < WORTH * step:
            return None
    for quantity in positive:
        duration = clear_until(quantity, duration, step, LOOKS)
    if duration < WORTH * step:
        return None
    halted = [End("halt", i) for i, body in enumerate(bodies) if body.sliding and body.load.static]
    return ModalGroup(
        bodies, gaps, now, duration, state, row.branches, contact, across, row.steady, step,
        [gap.touching is not None for gap in gaps], [body.load for body in bodies],
        [kinds_of(gap) for gap in gaps],
        halted if duration == rest else [],
    )  # fmt: skip


def _to_rest(state: ModalState, step: float) -> float:
    """s until nothing that swings counts any more; inf where that is never, or by now."""
    deepest = max((abs(over.constant) for over in state.over), default=0.0)
    slowest = max((z.real for over in state.over for z, _ in over.terms), default=-math.inf)
    swing = max((over.bound(0.0, 0) for over in state.over), default=0.0)
    if not state.anchored or deepest == 0.0 or swing == 0.0 or slowest >= 0.0:
        return math.inf
    rest = math.log(0.1 * QUIET * deepest / swing) / slowest
    return rest if rest > WORTH * step else math.inf
