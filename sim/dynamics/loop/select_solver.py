"""The cheapest solver that is exact, for every settled component.

nobody touches it    free flight, or a parabola or another closed form under its own forces
one pair             its closed form, where nothing but constant forces and springs act besides
all else             a step of the power series
"""

from __future__ import annotations

import math

from sim.dynamics.loop.contacts import pair_contact
from sim.dynamics.motion import courses
from sim.dynamics.motion.coupled_group import group_of
from sim.dynamics.motion.flight import Flight
from sim.dynamics.motion.guards import branch_of
from sim.dynamics.motion.linear_pair import linear_pair
from sim.dynamics.motion.power_series.series import ORDER
from sim.dynamics.motion.rows.choose import coupled_group
from sim.dynamics.motion.rows.rounded import nothing_left, told_by_rates
from sim.dynamics.motion.stick_slip import decide
from sim.dynamics.result.record import Record
from sim.dynamics.state.body import Body, Gap, Motion
from sim.dynamics.state.clock import Time, elapsed
from sim.dynamics.state.loads import NO_LOAD, Forces


def select_solvers(
    bodies: list[Body],
    gaps: list[Gap],
    now: Time,
    end: Time,
    forces: Forces | None,
    record: Record,
    nothing: float = 0.0,
) -> list[Motion]:
    """New solvers for bodies settled at `now`, in a row; the run ends at `end`.

    `gaps` are those between them and around them that may be members. Free flights have no solver.
    `nothing` [m/s] is a velocity that takes a body nowhere in all the run.
    """
    if forces is not None:
        for body in bodies:
            body.load = NO_LOAD if body.mass == math.inf else forces.load(body.carts)
    by_left = {id(gap.left): gap for gap in gaps if gap.member}
    by_right = {id(gap.right): gap for gap in gaps if gap.member}
    solvers: list[Motion] = []
    done: set[int] = set()
    for body in bodies:
        if id(body) in done:
            continue
        row, own = [body], []
        first = by_right.get(id(body))
        if first is not None and not first.left.carts:
            row.insert(0, first.left)
            own.append(first)
        while row[-1].carts and (gap := by_left.get(id(row[-1]))) is not None:
            own.append(gap)
            row.append(gap.right)
        done.update(id(one) for one in row if one.carts)
        motion = _solver(row, own, now, end, forces, nothing)
        for one in row:
            if one.carts:
                one.motion = motion
                record.piece(one)
        for gap in own:
            gap.solver = motion
        if motion is not None:
            solvers.append(motion)
    return solvers


def _solver(
    row: list[Body],
    gaps: list[Gap],
    now: Time,
    end: Time,
    forces: Forces | None,
    nothing: float,
) -> Motion | None:
    if all(body.mass == math.inf for body in row):
        return None  # all of them stick to walls: what pulls between them moves nothing
    loaded = any(body.load is not NO_LOAD for body in row)
    if len(row) == 1:
        return _flight(row[0], now, end, forces) if loaded else None
    law = gaps[0].law
    if len(gaps) == 1 and not loaded and not gaps[0].links and law is not None:
        if law.linear:
            return pair_contact(gaps[0], now)
        from sim.dynamics.motion.curved_pair import curved_pair  # where a scene calls for it

        alone = curved_pair(row, gaps[0], now, max(elapsed(now, end), 0.0))
        if alone is not None:
            return alone
    if len(gaps) == 1 and _is_linear(row, gaps[0]):
        phase = linear_pair(row, gaps[0], now, max(elapsed(now, end), 0.0))
        if phase is not None:
            _count(row, gaps, forces, 1)
            return phase
    if gaps and (over := nothing_left(row, gaps, max(elapsed(now, end), 0.0), nothing)) is not None:
        return group_of(over, [], over.length, now)
    return _group(row, gaps, now, end, forces)


def _is_linear(row: list[Body], gap: Gap) -> bool:
    """Constant forces on both, springs between, and a law with linear branches that moves.

    Beside a wall drag that is linear too: it is one damper more.
    """
    loads = [body.load for body in row]
    if any(load.quadratic or load.static or load.kinetic for load in loads):
        return False
    if any(load.linear for load in loads) and all(body.mass < math.inf for body in row):
        return False
    if gap.touching is not None and (
        gap.law is None or not gap.law.linear or branch_of(gap).locked
    ):
        return False
    return all(link.linear for link in gap.links)


def _flight(body: Body, now: Time, end: Time, forces: Forces | None) -> Motion | None:
    """A closed form under the body's own forces; None where it keeps its velocity."""
    load = body.load
    decide([body], [], [])
    _count([body], [], forces, 1)
    if body.held or (body.v == 0.0 and not body.sliding):
        return None
    course = courses.course(body.mass, body.v, body.sliding, load)
    if course is None:
        return _group([body], [], now, end, forces)
    return Flight(body, now, body.v, load, body.sliding, course)


def _group(row: list[Body], gaps: list[Gap], now: Time, end: Time, forces: Forces | None) -> Motion:
    _count(row, gaps, forces, ORDER - 1)
    limit = max(elapsed(now, end), 0.0)
    if any(body.load.linear for body in row):
        told_by_rates(row, gaps)
    if any(gap.touching is not None and gap.law is not None and not gap.law.linear for gap in gaps):
        from sim.dynamics.motion.curved.group import curved_group  # where a scene calls for it

        if (curved := curved_group(row, gaps, now, limit)) is not None:
            return curved
        from sim.dynamics.motion.adaptive import integrated_group  # where that has none

        return integrated_group(row, gaps, now, limit)
    return coupled_group(row, gaps, now, limit)


def _count(row: list[Body], gaps: list[Gap], forces: Forces | None, times: int) -> None:
    if forces is not None:
        for body in row:
            if body.load is not NO_LOAD:
                forces.count(body.load, (), times)
        if links := tuple(link for gap in gaps for link in gap.links):
            forces.count(NO_LOAD, links, times)
