"""How a row of bodies moves from now on: what is cheapest of all that is exact.

at rest         one step as long as its load stays (`rest`)
a sum of modes  where all is linear and the series has taken some steps (`modes`)
led             where forces without linear branches lead contacts that do not swing (`led`)
else            one step of the power series
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from sim.dynamics.motion import stick_slip
from sim.dynamics.motion.coupled_group import CoupledGroup, group_of
from sim.dynamics.motion.friction_shares import share
from sim.dynamics.motion.guards import branch_of, refuse_too_near
from sim.dynamics.motion.power_series.polynomial import integral, size
from sim.dynamics.motion.power_series.series import (
    REACH,
    Expansion,
    SettledRow,
    converged_step,
    expand,
    step_length,
)
from sim.dynamics.motion.power_series.step import Step
from sim.dynamics.motion.power_series.step_ends import first_ends
from sim.dynamics.motion.rest import at_rest, blocks
from sim.dynamics.motion.rows.rounded import is_faint
from sim.dynamics.motion.rows.settled_row import row_of
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.clock import Time
from sim.laws.branch import Branch

if TYPE_CHECKING:
    from sim.dynamics.motion.modes.group import ModalGroup


def coupled_group(
    bodies: list[Body], gaps: list[Gap], now: Time, limit: float
) -> CoupledGroup | ModalGroup:
    """The group of these bodies, settled at `now`, for at most `limit` s."""
    refuse_too_near(gaps, now)
    branches = [branch_of(gap) for gap in gaps]
    if any(body.load.grips or body.load.quadratic for body in bodies):
        stick_slip.decide(bodies, gaps, branches)
    row = row_of(bodies, gaps, branches, [body.sliding * body.load.quadratic for body in bodies])
    if (rest := _at_rest(bodies, gaps, branches, row, limit)) is not None:
        return group_of(rest, [], limit, now)
    if (swinging := _in_modes(bodies, gaps, row, now, limit)) is not None:
        return swinging
    if (rattling := _rattles(bodies, gaps, row, now, limit)) is not None:
        return rattling
    step = _led(bodies, gaps, row, limit) or _converged(bodies, gaps, branches, row, limit)
    return group_of(step, *first_ends(step, [size(n, step.length) for n in step.contact]), now)


def _at_rest(
    bodies: list[Body], gaps: list[Gap], branches: list[Branch], row: SettledRow, limit: float
) -> Step | None:
    """The step of a row at rest; None where it is not."""
    if not gaps or not _slow(gaps, apart=any(body.load.quadratic for body in bodies)):
        return None
    plain = replace(row, quadratic=[0.0] * len(bodies)) if any(row.quadratic) else row
    locked = all(branch.locked for branch in branches)
    fastest = _rate(gaps) if locked else REACH / step_length(plain)
    return at_rest(bodies, gaps, branches, fastest, limit)


def _in_modes(
    bodies: list[Body], gaps: list[Gap], row: SettledRow, now: Time, limit: float
) -> ModalGroup | None:
    """A sum of modes, where the series has taken some steps and all is linear."""
    if not gaps or min(gap.plain for gap in gaps) < STEPS_FIRST:
        return None
    if not is_faint(bodies, [abs(body.v) for body in bodies], limit):
        return None
    row = replace(row, quadratic=[0.0] * len(bodies))
    if row.nonlinear:
        return None
    from sim.dynamics.motion.modes.group import modal_group  # where a scene calls for it

    try:
        found = modal_group(bodies, gaps, row, now, limit)
    except ArithmeticError:  # numbers so far apart that their products leave the range of floats
        found = None
    if found is not None:
        ranges = [found.speeds(body, now, found.duration) for body in bodies]
        if not is_faint(bodies, [max(map(abs, one)) for one in ranges], found.duration):
            found = None
    if found is None:
        for gap in gaps:
            gap.plain = 0
    return found


def _led(bodies: list[Body], gaps: list[Gap], row: SettledRow, limit: float) -> Step | None:
    """A longer step, where forces without linear branches lead stiff contacts that do not swing."""
    if not row.nonlinear or not gaps or min(gap.plain for gap in gaps) < STEPS_FIRST:
        return None
    from sim.dynamics.motion.rows.led import led_step  # where a scene calls for it

    found = led_step(bodies, gaps, row, limit)
    if found is None:
        for gap in gaps:
            gap.plain = STEPS_FIRST - STEPS_MORE
    return found


def _rattles(
    bodies: list[Body], gaps: list[Gap], row: SettledRow, now: Time, limit: float
) -> CoupledGroup | None:
    """One phase of a small row that has formed often, in closed form up to its event."""
    often = False
    for gap in gaps:
        gap.formed += 1
        often = often or gap.formed > OFTEN
    if not often or len(gaps) > FEW:
        return None
    from sim.dynamics.motion.modes.rattle import phase  # where a scene calls for it

    try:
        found = phase(bodies, gaps, row, limit)
    except ArithmeticError:
        return None
    return None if found is None else group_of(*found, now, "modes")


OFTEN = 100
"""Steps of one contact's rows: then modes that serve them all pay."""

FEW = 8
"""Gaps. Modes of longer rows cost more than their steps."""


STEPS_MORE = 16
"""Steps before it is asked again whether a swing has faded, which costs as much as several."""


STEPS_FIRST = 4
"""Steps without an event before a row is looked at as a sum of modes, which costs three of them."""


def _slow(gaps: list[Gap], *, apart: bool) -> bool:
    """Do all overlaps change so little that it pays to ask whether the row is at rest?

    `apart`: also where only springs hold some of them; other rows like that are sums of modes.
    """
    if not apart and any(gap.touching is None for gap in gaps):
        return False
    deepest = max(abs(gap.room) for gap in gaps)
    swing = LOOK_CLOSER * _rate(gaps) * deepest
    return all(abs(gap.rate) <= swing for gap in gaps)


def _rate(gaps: list[Gap]) -> float:
    """1/s. Of the fastest pair by itself, on its steepest line."""
    stiff = [gap.law.steepest / gap.mu for gap in gaps if gap.law is not None]
    return math.sqrt(max(stiff, default=0.0))


LOOK_CLOSER = 1e-9
"""Of the speed at which an overlap as great as the greatest would swing."""


def _converged(
    bodies: list[Body], gaps: list[Gap], branches: list[Branch], row: SettledRow, limit: float
) -> Step:
    """The series, and a step in which it has converged."""
    series = _expanded(row, bodies, branches)
    free = _free(bodies, branches)
    unsigned = [body for body in free if body.load.quadratic and not body.sliding]
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
    if _stays(series):
        length = limit
    elif row.nonlinear:
        length = converged_step(row, series, speed, length)
        if length == 0.0 < limit:  # a coefficient is infinite: steps of no time, for ever
            raise OverflowError("a coefficient leaves the range of floats")
    return Step(
        bodies, gaps, branches, length, series.over, series.force, series.pull, speed, [],
        row.steady, row.nonlinear,
    )  # fmt: skip


def _stays(series: Expansion) -> bool:
    """Does no overlap change, and no acceleration? A series that ends is exact however long."""
    return not any(any(p[1:]) for p in (*series.over, *series.bodies))


def _free(bodies: list[Body], branches: list[Branch]) -> list[Body]:
    """Those that are locked to nothing that stands fast: of others an acceleration is rounding."""
    found: list[Body] = []
    for block in blocks([branch.locked for branch in branches]):
        row = [bodies[i] for i in block]
        if not any(body.held or body.mass == math.inf for body in row):
            found += row
    return found


def _expanded(row: SettledRow, bodies: list[Body], branches: list[Branch]) -> Expansion:
    series = expand(row)
    share(bodies, branches, row.steady, series)
    return series
