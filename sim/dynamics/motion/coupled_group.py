"""Several bodies that push or pull each other, all at once: tier 2, stepped by power series.

A group is a row of bodies whose neighbours touch or are linked, or one body under forces that have
no closed form together. It lives for one step, or until something happens in it: a contact's force
becomes zero, a bumper turns to the other line of its law, a linked pair touches, a body halts or
slips. Then what still belongs together forms anew, by the cheapest solver that is exact.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

from sim.dynamics.motion.lasting import Row
from sim.dynamics.motion.power_series.step import Step
from sim.dynamics.motion.work_accounting import book_step
from sim.dynamics.state.body import Accounts, Body, End, Gap, GapRecord, PeakSoFar, kinds_of
from sim.dynamics.state.clock import Time, elapsed
from sim.dynamics.state.loads import Load
from sim.laws.damped_oscillation import Rate


@dataclass(slots=True)
class CoupledGroup(Row):
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

    def marks(self, end: float) -> list[float]:
        """One formula holds for the whole step; near a touch it may be steep."""
        return self.step.marks(end)

    def until(self, now: Time) -> CoupledGroup:
        """The same up to now, as exactly as it can be had; made anew where it was integrated."""
        cut = self.step.cut(elapsed(self.begun, now))
        return self if cut is self.step else replace(self, step=cut)

    def state(self, side: float, tau: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of the body at that place in the row."""
        return self.step.motion(int(side), tau)

    def shift(self, body: Body, start: Time, end: Time) -> float:
        """m. How far a body goes between two times within the step."""
        i, step = self.place(body), self.step
        a, b = elapsed(self.begun, start), elapsed(self.begun, end)
        return step.displacement(i, b) - (step.displacement(i, a) if a != 0.0 else 0.0)

    def velocity(self, body: Body, now: Time) -> float:
        """m/s."""
        return self.step.velocity(self.place(body), elapsed(self.begun, now))

    def excess(self, body: Body, start: Time, dt: float) -> float:
        """m. Displacement in dt s beyond that at the velocity of `start`."""
        return self.step.excess(self.place(body), elapsed(self.begun, start), dt)

    def speeds(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """As `Motion.speeds`: least and greatest in the step."""
        return self.step.speeds(self.place(body), self.duration)

    def accelerations(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """As `Motion.accelerations`: m/s², least and greatest within the step."""
        return self.step.accelerations(self.place(body), elapsed(self.begun, now), horizon)

    def force(self, gap: int, tau: float) -> tuple[float, float]:
        """As `Motion.force`: N and dN/dt of a gap of the chain."""
        return self.step.force(self.gaps.index(gap), tau)

    def book(self, accounts: Accounts, t: float) -> None:
        """As `Motion.book`: impulses from outside and work, by name."""
        book_step(accounts, self.step, t)

    def locked(self, k: int) -> bool:
        """As `Motion.locked`: the branch of its law says so."""
        return self.step.branches[k].locked

    def parts(self, t: float, *, peaks: bool) -> list[GapRecord]:
        """As `Motion.parts`: gap by gap."""
        step, found = self.step, []
        for k, gap in enumerate(self.members):
            over, rate = step.overlap(k, t)
            summed = step.summed(k, t) if gap.loose else 0.0
            if gap.touching is None:
                found.append(GapRecord(over, rate, summed=summed))
                continue
            seen: tuple[PeakSoFar, ...] = ()
            if peaks and step.may_peak(k, t):
                forces = ((when, step.contact_force(k, when)) for when in step.greatest(k, t))
                if (best := gap.touching.greatest(forces)) is not None:
                    when, force = best
                    speeds = (step.velocity(k, when), step.velocity(k + 1, when))
                    seen = ((when, force, step.impulse(k, when), speeds),)
            kept, deepest = step.dissipated(k, t, over), step.deepest(k, t, over, rate)
            found.append(GapRecord(over, rate, step.impulse(k, t), kept, deepest, seen, summed))
        return found


def group_of(
    step: Step, ends: list[End], duration: float, now: Time, name: str = "power-series"
) -> CoupledGroup:
    """The group that takes this step."""
    bodies, gaps = step.bodies, step.gaps
    touched = [gap.touching is not None for gap in gaps]
    loads, linked = [body.load for body in bodies], [kinds_of(gap) for gap in gaps]
    return CoupledGroup(bodies, gaps, now, duration, ends, step, touched, loads, linked, name)
