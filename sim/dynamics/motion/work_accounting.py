"""What a solver did to bodies under effects, booked by name: impulses from outside, and work.

steady      F t            F s
linear      −b s           −b ∫v² dt          s [m] is the way, t [s] the time
quadratic   −c ∫v|v| dt    −c ∫|v|³ dt
friction    −μN t          −μN |s|            held: the impulse of all others, no work
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from sim.dynamics.motion.polynomial import Poly, cube_integral, integral, square_integral, value
from sim.effects.forces import FRICTION

if TYPE_CHECKING:
    from sim.dynamics.motion.coupled_group import Cluster
    from sim.dynamics.motion.flight import Flight
    from sim.dynamics.motion.linear_pair import PairPhase
    from sim.dynamics.result.ledger import Ledger
    from sim.dynamics.state.chain import Gap
    from sim.dynamics.state.loads import Load
    from sim.laws.branch import Branch


def _body_forces(
    ledger: Ledger, load: Load, time: float, way: float, squares: tuple[float, float, float]
) -> None:
    """Every force by name. squares: ∫v² dt, ∫v|v| dt, ∫|v|³ dt."""
    for one in load.forces:
        impulse = one.steady * time - one.linear * way - one.quadratic * squares[1]
        ledger.push_from_outside(impulse, one.kind)
        work = one.steady * way - one.linear * squares[0] - one.quadratic * squares[2]
        ledger.work(one.kind, work)


def flight(ledger: Ledger, flown: Flight, mass: float, time: float) -> None:
    """A closed form: what drag took follows from the change of velocity and of kinetic energy."""
    load, course = flown.load, flown.course
    way, v, _ = course.at(time)
    force = load.steady - flown.sliding * load.kinetic
    slowed = force * time - mass * (v - flown.v0)  # N s, taken by drag
    taken = force * way - 0.5 * mass * (v - flown.v0) * (v + flown.v0)  # J
    total = load.linear + load.quadratic
    for one in load.forces:
        share = (one.linear + one.quadratic) / total if total else 0.0  # one of the two is nought
        ledger.push_from_outside(one.steady * time - share * slowed, one.kind)
        ledger.work(one.kind, one.steady * way - share * taken)
    if load.kinetic:
        ledger.push_from_outside(-flown.sliding * load.kinetic * time, FRICTION)
        ledger.work(FRICTION, -flown.sliding * load.kinetic * way)


def cluster(ledger: Ledger, step: Cluster, t: float) -> None:
    """A step of the power series, up to t s."""
    for i, body in enumerate(step.bodies):
        load = body.load
        if not body.carts or not (load.forces or load.grips):
            continue
        way, speed = value(step.path[i], t), step.speed[i]
        squares = (0.0, 0.0, 0.0)
        if load.linear or load.quadratic:
            square = square_integral(speed, t)
            cube = body.sliding * cube_integral(speed, t) if load.quadratic else 0.0
            squares = (square, body.sliding * square, cube)
        _body_forces(ledger, load, t, way, squares)
        if body.held:
            impulse = -value(integral(step.other_force(i)), t)
            ledger.push_from_outside(impulse, FRICTION)
        elif load.kinetic and body.sliding:
            force = step.row.steady[i] - load.steady
            ledger.push_from_outside(force * t, FRICTION)
            ledger.work(FRICTION, force * way)
    for k, gap in enumerate(step.members):
        for link in gap.links:
            damping = link.damping()
            if damping:
                rate = [n * c for n, c in enumerate(step.series.over[k])][1:]
                ledger.work(link.kind, -damping * square_integral(rate, t))
        if gap.links:
            _from_wall(ledger, gap, value(integral(step.series.pull[k]), t))


def pair_phase(ledger: Ledger, phase: PairPhase, t: float) -> None:
    """A closed form of two neighbours, up to t s."""
    for body in phase.bodies:
        if body.carts and body.mass < math.inf and body.load.forces:
            way = phase.state(phase.side(body), t)[0]
            _body_forces(ledger, body.load, t, way, (0.0, 0.0, 0.0))
    gap = phase.members[0]
    for link in gap.links:
        if link.damping():
            ledger.work(link.kind, -link.damping() * phase.damped(t))
    if gap.links:
        (_, u), (_, v) = phase.start, phase.over(0, t)
        total = phase.mu * (u - v) + phase.mu * phase.pull * t
        _from_wall(ledger, gap, total - phase.impulse(0, t))


def _from_wall(ledger: Ledger, gap: Gap, impulse: float) -> None:
    """Springs and magnets of a gap whose one side stands fast; a cart there sticks to a wall."""
    fixed = [body for body in (gap.left, gap.right) if body.mass == math.inf]
    if gap.links and len(fixed) == 1:
        toward = 1.0 if fixed[0] is gap.left else -1.0
        ledger.push_from_outside(toward * impulse, "walls" if fixed[0].carts else gap.links[0].kind)


def warmed(gap: Gap, branch: Branch, over: Poly, t: float) -> float:
    """J. What a touching gap does not give back of the work pressed in, up to t s."""
    loss = 0.0
    if branch.gamma:
        rate = [n * c for n, c in enumerate(over)][1:]
        loss += branch.gamma * square_integral(rate, t)
    return loss + (gap.law.kept(branch, over[0], value(over, t)) if gap.law is not None else 0.0)
