"""Rows in which some contacts are those of spheres, step by step in their own time: tier 2.

A step ends where the series (`series`) stop converging, or where something happens in it.
A contact that touches without overlap and without approach has no series there. Its overlap grows
as a high power of the time, and its force as a higher one: as long as that is FAINT beside the
others it is left out, which ends the step; then it is pressed, and has a series. Behind a push that
runs through a row of them the overlaps are 1e-50 m, and would need steps of their own.
"""

from __future__ import annotations

import math
from dataclasses import replace

from sim.dynamics.motion import stick_slip
from sim.dynamics.motion.coupled_group import CoupledGroup, group_of
from sim.dynamics.motion.curved.own_time import fresh, keeper, unit_of
from sim.dynamics.motion.curved.resting import resting_step
from sim.dynamics.motion.curved.series import OfRoot, RowSeries
from sim.dynamics.motion.curved_field import curved
from sim.dynamics.motion.friction_shares import share
from sim.dynamics.motion.guards import branch_of, push_now, refuse_too_near
from sim.dynamics.motion.power_series.polynomial import size, value
from sim.dynamics.motion.power_series.series import Expansion, SettledRow
from sim.dynamics.motion.power_series.step_ends import first_ends
from sim.dynamics.motion.rows.settled_row import row_of
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.clock import Time
from sim.laws.contact_law import ContactLaw

FAINT = 1e-16
"""Of the greatest force in the row, or, as an impulse, of the lightest body's momentum at the
greatest speed: what a sum does not notice."""

FAINTER = 1e-3
"""Of what is faint, at the beginning of a step: so that it stays faint for some time."""

SHORTER = 0.7
"""Of a step: tried again and again until what is left out is faint."""


def curved_group(
    bodies: list[Body], gaps: list[Gap], now: Time, limit: float
) -> CoupledGroup | None:
    """The row of these bodies, settled at `now`, for at most `limit` s; None: it has no series.

    That is: two contacts of spheres begin at one instant, a law is no polynomial in z, or a body
    under quadratic drag is at rest.
    """
    refuse_too_near(gaps, now)
    branches = [branch_of(gap) for gap in gaps]
    stick_slip.decide(bodies, gaps, branches)
    fastest = max([*(abs(body.v) for body in bodies), *(abs(gap.rate) for gap in gaps)])
    if (rest := resting_step(bodies, gaps, branches, limit)) is not None:
        return group_of(rest, [], limit, now)
    if any(body.load.quadratic and not (body.sliding or body.held) for body in bodies):
        return None
    row = row_of(bodies, gaps, branches, [body.sliding * body.load.quadratic for body in bodies])
    silent = _silent(gaps, row, fastest)
    clock = keeper(gaps, silent)
    for k, gap in enumerate(gaps):
        begins = gap.room >= 0.0 and k != clock and k not in silent
        if curved(gap) is not None and (begins or not isinstance(gap.law, OfRoot)):
            return None
    unit = 1.0 if clock is None else unit_of(gaps[clock])
    series = RowSeries(row, gaps, clock, unit, silent)
    share(bodies, branches, row.steady, Expansion(series.o, series.force, series.pull, series.a))
    least = fastest * min(body.mass for body in bodies)
    step = series.step(bodies, _faint_until(series, series.converged(limit), least))
    ends, s = first_ends(step, [math.inf] * len(gaps), clock)  # none of these rows is long
    step = step.until_own(s)
    if step.length > limit:
        step, ends = step.until_own(step.own.of(limit)), []
        step = replace(step, length=limit, own=replace(step.own, length=limit))
    return group_of(step, ends, step.length, now)


def _silent(gaps: list[Gap], row: SettledRow, fastest: float) -> list[int]:
    """Contacts of spheres that may be left out: without overlap or approach, or faint just now."""
    pushes = [push_now(gap, branch) for gap, branch in zip(gaps, row.branches, strict=True)]
    greatest = max([*map(abs, pushes), *map(abs, row.steady)])
    return [
        k
        for k, gap in enumerate(gaps)
        if (law := curved(gap)) is not None
        and (gap.room >= 0.0 or _strength(law, gap) <= FAINT * FAINTER * greatest)
        and not fresh(gap, fastest)
    ]


def _strength(law: ContactLaw, gap: Gap) -> float:
    """N. Of spring and damper each: their sum passes through zero where neither is faint."""
    spring = law.force(gap.mu, -gap.room, 0.0)
    return spring + abs(law.force(gap.mu, -gap.room, -gap.rate) - spring)


def _faint_until(series: RowSeries, span: float, momentum: float) -> float:
    """The span up to which the contacts that are left out stay faint; `momentum` in kg m/s.

    All the way: at its end a pair may have parted again.
    """
    for k in series.silent:
        gap, law = series.gaps[k], curved(series.gaps[k])
        assert law is not None
        while span > 0.0:
            push = law.force(gap.mu, size(series.o[k], span), size(series.r[k], span))
            others = [abs(value(n, span)) for n in (*series.force, *series.pull) if n]
            greatest = max([*others, *map(abs, series.row.steady)])
            if push <= FAINT * greatest or push * value(series.t, span) <= FAINT * momentum:
                break
            span *= SHORTER
    return span
