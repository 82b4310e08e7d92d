"""Several bodies that push or pull each other, all at once: tier 2, stepped by power series.

A group is a row of bodies whose neighbours touch or are linked, or one body under forces that have
no closed form together. It lives for one step, or until something happens in it: a contact's force
becomes zero, a bumper turns to the other line of its law, a linked pair touches, a body halts or
slips. Then what still belongs together forms anew, by the cheapest solver that is exact.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from sim.dynamics.motion import stick_slip
from sim.dynamics.motion.friction_shares import share
from sim.dynamics.motion.guards import branch_of, refuse_too_near
from sim.dynamics.motion.polynomial import integral, size
from sim.dynamics.motion.rest import at_rest
from sim.dynamics.motion.row_now import row_of
from sim.dynamics.motion.series import REACH, Expansion, Row, converged_step, expand, step_length
from sim.dynamics.motion.step import Step
from sim.dynamics.motion.step_ends import first_ends
from sim.dynamics.motion.work_accounting import book_step
from sim.dynamics.state.body import Accounts, Body, End, Gap, Part, kinds_of
from sim.dynamics.state.clock import Time, elapsed
from sim.dynamics.state.loads import Load
from sim.laws.branch import Branch
from sim.laws.damped_oscillation import Rate

if TYPE_CHECKING:
    from sim.dynamics.motion.modes.group import ModalGroup


@dataclass(frozen=True, slots=True)
class CoupledGroup:
    """One step of a row of bodies from `begun`, for `duration` s.

    `bodies` include a wall at an end that is touched; gap k lies between bodies k and k + 1.
    """

    bodies: list[Body]
    members: list[Gap]
    begun: Time
    duration: float
    ends: list[End]
    step: Step
    touched: list[bool]  # which gaps are contacts, not links alone
    loads: list[Load]
    linked: list[tuple[str, ...]]
    name: str = "power-series"
    tier: int = 2
    parabolic: ClassVar[bool] = False
    fading: ClassVar[tuple[Rate, ...]] = ()

    @property
    def short_steps(self) -> bool:
        """A nonlinear row converges for a short time only."""
        return self.step.short

    @property
    def gaps(self) -> tuple[int, ...]:
        """The gaps of the chain that it moves."""
        return tuple(gap.index for gap in self.members)

    def marks(self, end: float) -> list[float]:
        """One formula holds for the whole step; near a touch it may be steep."""
        return self.step.marks(end)

    def until(self, now: Time) -> CoupledGroup:
        """The same up to now, as exactly as it can be had; made anew where it was integrated."""
        cut = self.step.cut(elapsed(self.begun, now))
        return self if cut is self.step else replace(self, step=cut)

    def time_left(self, now: Time) -> float:
        """s to the end of the step."""
        return self.duration - elapsed(self.begun, now)

    def side(self, body: Body) -> float:
        """The body's place in the row."""
        return float(self._place(body))

    def _place(self, body: Body) -> int:
        for k, other in enumerate(self.bodies):
            if other is body:
                return k
        raise ValueError(body)

    def state(self, side: float, tau: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of the body at that place in the row."""
        return self.step.motion(int(side), tau)

    def shift(self, body: Body, start: Time, end: Time) -> float:
        """m. How far a body goes between two times within the step."""
        i, step = self._place(body), self.step
        a, b = elapsed(self.begun, start), elapsed(self.begun, end)
        return step.way(i, b) - (step.way(i, a) if a != 0.0 else 0.0)

    def velocity(self, body: Body, now: Time) -> float:
        """m/s."""
        return self.step.velocity(self._place(body), elapsed(self.begun, now))

    def excess(self, body: Body, start: Time, dt: float) -> float:
        """m. Displacement in dt s beyond that at the velocity of `start`."""
        return self.step.excess(self._place(body), elapsed(self.begun, start), dt)

    def speeds(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """Least and greatest velocity in the step."""
        return self.step.speeds(self._place(body), self.duration)

    def acceleration(self, body: Body, now: Time) -> float:
        """m/s². Bound over the step."""
        return self.step.acceleration(self._place(body), self.duration)

    def force(self, gap: int, tau: float) -> tuple[float, float]:
        """N and dN/dt of a gap of the chain."""
        return self.step.force(self.gaps.index(gap), tau)

    def book(self, accounts: Accounts, t: float) -> None:
        """Impulses from outside and work, by name."""
        book_step(accounts, self.step, t)

    def locked(self, k: int) -> bool:
        """As the branch of its law."""
        return self.step.branches[k].locked

    def parts(self, t: float, *, peaks: bool) -> list[Part]:
        """Gap by gap."""
        step, found = self.step, []
        for k, gap in enumerate(self.members):
            over, rate = step.overlap(k, t)
            summed = step.summed(k, t) if gap.loose else 0.0
            if gap.touching is None:
                found.append(Part(over, rate, summed=summed))
                continue
            seen = tuple(
                (
                    when,
                    step.contact_force(k, when),
                    step.impulse(k, when),
                    (step.velocity(k, when), step.velocity(k + 1, when)),
                )
                for when in (step.greatest(k, t) if peaks and step.may_peak(k, t) else ())
            )
            kept, deepest = step.dissipated(k, t, over), step.deepest(k, t, over, rate)
            found.append(Part(over, rate, step.impulse(k, t), kept, deepest, seen, summed))
        return found


def coupled_group(
    bodies: list[Body], gaps: list[Gap], now: Time, limit: float
) -> CoupledGroup | ModalGroup:
    """The group of these bodies, settled at `now`, for at most `limit` s."""
    refuse_too_near(gaps, now)
    branches = [branch_of(gap) for gap in gaps]
    stick_slip.decide(bodies, gaps, branches)
    row = row_of(bodies, gaps, branches, [body.sliding * body.load.quadratic for body in bodies])
    if (rest := _at_rest(bodies, gaps, branches, row, limit)) is not None:
        return group_of(rest, [], limit, now)
    if (swinging := _in_modes(bodies, gaps, row, now, limit)) is not None:
        return swinging
    step = _led(bodies, gaps, row, limit) or _converged(bodies, gaps, branches, row, limit)
    return group_of(step, *first_ends(step, [size(n, step.length) for n in step.contact]), now)


def group_of(step: Step, ends: list[End], duration: float, now: Time) -> CoupledGroup:
    """The group that takes this step."""
    bodies, gaps = step.bodies, step.gaps
    touched = [gap.touching is not None for gap in gaps]
    loads, linked = [body.load for body in bodies], [kinds_of(gap) for gap in gaps]
    return CoupledGroup(bodies, gaps, now, duration, ends, step, touched, loads, linked)


def _at_rest(
    bodies: list[Body], gaps: list[Gap], branches: list[Branch], row: Row, limit: float
) -> Step | None:
    """The step of a row at rest; None where it is not."""
    if not gaps or not _slow(gaps):
        return None
    fastest = REACH / step_length(replace(row, quadratic=[0.0] * len(bodies)))
    return at_rest(bodies, gaps, branches, fastest, limit)


def _in_modes(
    bodies: list[Body], gaps: list[Gap], row: Row, now: Time, limit: float
) -> ModalGroup | None:
    """A sum of modes, where the series has taken some steps and all is linear."""
    if not gaps or min(gap.plain for gap in gaps) < STEPS_FIRST:
        return None
    if row.nonlinear or any(body.load.quadratic for body in bodies):
        return None
    from sim.dynamics.motion.modes.group import modal_group  # where a scene calls for it

    try:
        found = modal_group(bodies, gaps, row, now, limit)
    except ArithmeticError:  # numbers so far apart that their products leave the range of floats
        found = None
    if found is None:
        for gap in gaps:
            gap.plain = 0
    return found


def _led(bodies: list[Body], gaps: list[Gap], row: Row, limit: float) -> Step | None:
    """A longer step, where forces without linear branches lead stiff contacts that do not swing."""
    if not row.nonlinear or not gaps or min(gap.plain for gap in gaps) < STEPS_FIRST:
        return None
    from sim.dynamics.motion.led_row import led_step  # where a scene calls for it

    found = led_step(bodies, gaps, row, limit)
    if found is None:
        for gap in gaps:
            gap.plain = STEPS_FIRST - STEPS_MORE
    return found


STEPS_MORE = 16
"""Steps before it is asked again whether a swing has faded, which costs as much as several."""


STEPS_FIRST = 4
"""Steps without an event before a row is looked at as a sum of modes, which costs three of them."""


def _slow(gaps: list[Gap]) -> bool:
    """Do all overlaps change so little that it pays to ask whether the row is at rest?"""
    if any(gap.touching is None for gap in gaps):
        return False
    stiff = max((gap.law.steepest / gap.mu for gap in gaps if gap.law is not None), default=0.0)
    deepest = max(abs(gap.room) for gap in gaps)
    swing = LOOK_CLOSER * math.sqrt(stiff) * deepest
    return all(abs(gap.rate) <= swing for gap in gaps)


LOOK_CLOSER = 1e-9
"""Of the speed at which an overlap as great as the greatest would swing."""


def _converged(
    bodies: list[Body], gaps: list[Gap], branches: list[Branch], row: Row, limit: float
) -> Step:
    """The series, and a step in which it has converged."""
    series = _expanded(row, bodies, branches)
    unsigned = [body for body in bodies if body.load.quadratic and not body.sliding]
    if unsigned:  # at rest, and nothing pushes yet: the first term of its motion tells
        for body, a in zip(bodies, series.bodies, strict=True):
            if body in unsigned:
                first = next((c for c in [body.v, *a] if c != 0.0), 0.0)
                body.sliding = (first > 0.0) - (first < 0.0)
        signed = [body.sliding * body.load.quadratic for body in bodies]
        row = row_of(bodies, gaps, branches, signed)
        series = _expanded(row, bodies, branches)
    speed = [[b.v, *integral(a)[1:]] for b, a in zip(bodies, series.bodies, strict=True)]
    length = min(step_length(row), limit)
    if row.nonlinear:
        length = converged_step(row, series, speed, length)
    path = [integral(v) for v in speed]
    return Step(
        bodies, gaps, branches, length, series.over, series.force, series.pull, speed, path,
        row.steady, row.nonlinear,
    )  # fmt: skip


def _expanded(row: Row, bodies: list[Body], branches: list[Branch]) -> Expansion:
    series = expand(row)
    share(bodies, branches, row.steady, series)
    return series
