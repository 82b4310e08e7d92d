"""Tier 3: what has neither a closed form nor a power series is integrated, with located events.

    y = overlaps, their rates, velocities, displacements, impulses and losses of the contacts,
        integrals of the squares of the rates; of v², v|v| and |v|³ where there is drag;
        impulses of springs and magnets where there are any
    y' = f(y) by an embedded Runge-Kutta method of order 8 (Dormand & Prince, scipy's DOP853)

One accepted step at a time; its dense output (degree 7) serves for events and drawing as a power
series does. Where an event ends the step, the step is done again up to there, so that the state at
the event has the method's full order and not the dense output's. Tolerances: see below. numpy and
scipy are imported here, when first used, and only here. Source: Hairer, Nørsett & Wanner, Solving
Ordinary Differential Equations I, II.5 and II.6.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from sim.dynamics.motion import stick_slip
from sim.dynamics.motion.coupled_group import CoupledGroup
from sim.dynamics.motion.curved_field import curved, dragged, field_of, linked
from sim.dynamics.motion.dense_output import polynomials, scipy_method
from sim.dynamics.motion.guards import branch_of, refuse_too_near
from sim.dynamics.motion.power_series.polynomial import Poly, value
from sim.dynamics.motion.power_series.series import SettledRow
from sim.dynamics.motion.power_series.step import Step, slope_of
from sim.dynamics.motion.power_series.step_ends import first_ends, found_again
from sim.dynamics.motion.rows.settled_row import row_of
from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.state.body import Body, Gap, kinds_of
from sim.dynamics.state.clock import ZERO, Time
from sim.laws.branch import Branch
from sim.laws.contact_law import ContactLaw
from sim.scene.said import said

RELATIVE = 1e-12
"""Error per step, relative: a hundred steps of a contact stay within 1e-10."""

SMALL = 1e-13
"""The same relative to the greatest speed, and to the displacement in a contact at that speed."""

SLOWEST = 1e-6
"""m/s. Stands for the greatest speed where nothing moves."""


@dataclass(slots=True)
class IntegratedStep(Step):
    """Impulses and losses are integrated with the motion; forces follow from the law itself.

    Rates too are those that were integrated: the overlap's slope in a step of 1e-8 s, the last one
    before two spheres part, is the last bit of an overlap over that, and carts and gaps would go on
    from there with velocities that differ by 1e-9.
    """

    closing: list[Poly]  # m/s, rates of the overlaps
    impulses: list[Poly]  # N s
    losses: list[Poly]  # J
    laws: list[ContactLaw | None]  # those that are curved, of gaps that touch
    rates: list[Poly]  # m²/s, integrals of o'²
    drags: list[list[Poly]]  # of v², v|v|, |v|³ of each body, where there is drag
    pulls: list[Poly]  # N s, of springs and magnets; empty where there are none
    row: SettledRow

    def cut(self, t: float) -> IntegratedStep:
        """The step anew up to t s, so that the state there has the full order of the method."""
        if not 0.0 < t < self.length:
            return self
        strides = [gap.stride for gap in self.gaps]
        shorter = _integrated(self.bodies, self.gaps, self.row, ZERO, t, t)
        for gap, stride in zip(self.gaps, strides, strict=True):
            gap.stride = stride
        return shorter if shorter.length == t else self

    def overlap(self, k: int, t: float) -> tuple[float, float]:
        """m and m/s, both as they were integrated."""
        return value(self.over[k], t), value(self.closing[k], t)

    def impulse(self, k: int, t: float) -> float:
        """N s."""
        return value(self.impulses[k], t)

    def across_impulse(self, k: int, t: float) -> float:
        """N s. As it was integrated."""
        return value(self.pulls[k], t)

    def contact_force(self, k: int, t: float) -> float:
        """N."""
        d, rate = self.overlap(k, t)
        law, mu = self.laws[k], self.gaps[k].mu
        return self.branches[k].force(d, rate) if law is None else law.force(mu, d, rate)

    def force(self, k: int, t: float) -> tuple[float, float]:
        """N by the law, dN/dt by the dense output."""
        _, growth = Step.force(self, k, t)
        over, rate = self.overlap(k, t)
        pull = math.fsum(link.force(-over, -rate) for link in self.row.links[k])
        return self.contact_force(k, t) + pull, growth

    def squares(self, i: int, t: float) -> tuple[float, float, float]:
        """As they were integrated."""
        if not self.drags[i]:
            return 0.0, 0.0, 0.0
        square, signed, cube = (value(p, t) for p in self.drags[i])
        return square, signed, cube

    def rate_square(self, k: int, t: float) -> float:
        """As it was integrated."""
        return value(self.rates[k], t)

    def strongest(self, k: int, t: float) -> float:
        """N. Not known from the dense output: it may always be more."""
        return math.inf

    def dissipated(self, k: int, t: float, end: float) -> float:
        """J. What a bumper keeps follows from its law."""
        curved_law = self.laws[k] is not None
        return value(self.losses[k], t) if curved_law else Step.dissipated(self, k, t, end)


def integrated_group(bodies: list[Body], gaps: list[Gap], now: Time, limit: float) -> CoupledGroup:
    """One accepted step of a row in which some contact has a curved law, at most `limit` s."""
    refuse_too_near(gaps, now)
    branches = [branch_of(gap) for gap in gaps]
    stick_slip.decide(bodies, gaps, branches)
    row = row_of(bodies, gaps, branches, [0.0] * len(bodies))
    step = _integrated(bodies, gaps, row, now, limit)
    ends, duration = first_ends(step, [math.inf] * len(gaps))  # none of these rows is long
    if ends and 0.0 < duration < step.length:
        better = found_again(step.cut(duration), [math.inf] * len(gaps), ends[0], duration)
        duration = min(better, step.length)
    step = step.cut(duration)
    touched = [gap.touching is not None for gap in gaps]
    loads, linked = [body.load for body in bodies], [kinds_of(gap) for gap in gaps]
    return CoupledGroup(
        bodies, gaps, now, duration, ends, step, touched, loads, linked, "adaptive", 3
    )


def _integrated(
    bodies: list[Body],
    gaps: list[Gap],
    row: SettledRow,
    now: Time,
    limit: float,
    first: float = 0.0,
) -> IntegratedStep:
    """One accepted step, at most `limit` s, with its dense output; `first` [s] is tried first."""
    start = [*row.overlaps, *row.rates, *row.speeds]
    integrals = len(bodies) + 3 * len(gaps) + 3 * len(dragged(bodies)) + len(linked(gaps))
    start += [0.0] * integrals
    if limit <= 0.0:
        return _kept(bodies, gaps, row, [[y] for y in start], 0.0)
    numpy, dop853 = scipy_method()
    field = field_of(bodies, gaps, row)
    solver = dop853(
        lambda _t, y: field(y.tolist()),
        0.0,
        numpy.array(start),
        limit,
        first_step=first or _stride(bodies, gaps, limit),
        rtol=RELATIVE,
        atol=numpy.array(_tolerances(bodies, gaps, row)),
    )
    solver.step()
    if solver.status == "failed":
        raise UnsolvedError(
            said("the contact is too stiff to be integrated"),
            said("a softer stiffness, or law: bumper, which has a closed form"),
            now[0],
            (),
        )
    for gap in gaps:
        gap.stride = float(solver.h_abs)
    return _kept(bodies, gaps, row, polynomials(solver), float(solver.t))


def _stride(bodies: list[Body], gaps: list[Gap], limit: float) -> float | None:
    """s. The first step to try: what the last one proposed, unless something has just begun."""
    if any(body.sliding and body.v == 0.0 for body in bodies):
        return None
    curved_gaps = [gap for gap in gaps if curved(gap) is not None]
    stride = min(gap.stride for gap in curved_gaps)
    return min(stride, limit) if stride > 0.0 else None


def _tolerances(bodies: list[Body], gaps: list[Gap], row: SettledRow) -> list[float]:
    """Absolute ones, from the greatest speed and the time of a contact at that speed.

    What is stored counts as the speed that it can give: where all turn back together nothing moves
    for a moment, and the tolerances would shrink to nought with the speeds.
    """
    count = len(gaps)
    lightest = min(body.mass for body in bodies if body.mass < math.inf)
    stored = [
        math.sqrt(2.0 * law.stored(-gap.room, 0.0, 0.0) / gap.mu)
        for gap in gaps
        if (law := curved(gap)) is not None
    ]
    speed = max([abs(v) for v in (*row.speeds, *row.rates, *stored)], default=0.0) or SLOWEST
    laws = [gap.law for gap in gaps if gap.law is not None and not gap.law.linear]
    stiff = max([law.stiffness for law in laws], default=1.0)
    displacement = speed * (lightest**2 / (stiff**2 * speed)) ** 0.2
    return (
        [SMALL * displacement] * count
        + [SMALL * speed] * (count + len(bodies))
        + [SMALL * displacement] * len(bodies)
        + [SMALL * lightest * speed] * count
        + [SMALL * lightest * speed * speed] * count
        + [SMALL * displacement * speed] * count
        + [
            SMALL * displacement * speed,
            SMALL * displacement * speed,
            SMALL * displacement * speed * speed,
        ]
        * len(dragged(bodies))
        + [SMALL * lightest * speed] * len(linked(gaps))
    )


def _kept(
    bodies: list[Body], gaps: list[Gap], row: SettledRow, dense: list[Poly], length: float
) -> IntegratedStep:
    count, n = len(gaps), len(bodies)
    over, closing, speed = dense[:count], dense[count : 2 * count], dense[2 * count : 2 * count + n]
    path = dense[2 * count + n : 2 * count + 2 * n]
    behind = 2 * count + 2 * n
    impulses, losses, rates = (dense[behind + j * count :][:count] for j in range(3))
    rest = dense[behind + 3 * count :]
    drags: list[list[Poly]] = [[] for _ in bodies]
    for j, i in enumerate(dragged(bodies)):
        drags[i] = rest[3 * j : 3 * j + 3]
    force = [slope_of(p) or [0.0] for p in impulses]
    branches: list[Branch] = row.branches
    pulls: list[Poly] = [[] for _ in gaps]
    for k, p in zip(linked(gaps), rest[3 * len(dragged(bodies)) :], strict=True):
        pulls[k] = p
    across = [slope_of(p) or [0.0] if p else [] for p in pulls]
    return IntegratedStep(
        bodies, gaps, branches, length, over, force, across, speed, path, row.steady, row.nonlinear,
        closing, impulses, losses, [curved(gap) for gap in gaps], rates, drags, pulls, row,
    )  # fmt: skip
