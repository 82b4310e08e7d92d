"""What a motion did to bodies under effects, booked by name: impulses from outside, and work.

steady      F t            F s
linear      −b s           −b ∫v² dt          s [m] is the displacement, t [s] the time
quadratic   −c ∫v|v| dt    −c ∫|v|³ dt
friction    −μN t          −μN |s|            held: the impulse of all others, no work
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

from sim.dynamics.motion.power_series.step import Step
from sim.dynamics.state.body import Accounts, Gap
from sim.dynamics.state.loads import Load
from sim.effects.forces import FRICTION


def book_body_forces(
    accounts: Accounts,
    load: Load,
    time: float,
    displacement: float,
    squares: tuple[float, float, float],
) -> None:
    """Every force on a body by name. squares: ∫v² dt, ∫v|v| dt, ∫|v|³ dt."""
    for one in load.forces:
        impulse = one.steady * time - one.linear * displacement - one.quadratic * squares[1]
        accounts.push_from_outside(impulse, one.kind)
        work = one.steady * displacement - one.linear * squares[0] - one.quadratic * squares[2]
        accounts.work(one.kind, work)


def book_step(accounts: Accounts, step: Step, t: float) -> None:
    """A step of a row, up to t s."""
    for i, body in enumerate(step.bodies):
        load = body.load
        if not body.carts or not (load.forces or load.grips):
            continue
        displacement = step.displacement(i, t)
        book_body_forces(accounts, load, t, displacement, step.squares(i, t))
        if body.held:
            accounts.push_from_outside(-step.others_impulse(i, t), FRICTION)
        elif load.kinetic and body.sliding:
            force = step.steady[i] - load.steady
            accounts.push_from_outside(force * t, FRICTION)
            accounts.work(FRICTION, force * displacement)
    for k, gap in enumerate(step.gaps):
        for link in gap.links:
            damping = link.damping()
            if damping:
                accounts.work(link.kind, -damping * step.rate_square(k, t))
        if gap.links:
            book_from_wall(accounts, gap, step.across_impulse(k, t), t, partial(_over, step, k, t))


def _over(step: Step, k: int, t: float) -> tuple[float, float]:
    return step.summed(k, t), step.overlap(k, t)[0] - step.overlap(k, 0.0)[0]


def book_from_wall(
    accounts: Accounts,
    gap: Gap,
    impulse: float,
    time: float,
    over: Callable[[], tuple[float, float]],
) -> None:
    """Springs and magnets of a gap whose one side stands fast; a cart there sticks to a wall.

    `impulse` [N s] is that of all together in `time` [s]; `over` tells the integral of the overlap
    [m s] and its change [m] in that time, from which the share of a linear force follows.
    """
    fixed = [body for body in (gap.left, gap.right) if body.mass == math.inf]
    if not gap.links or len(fixed) != 1:
        return
    toward = 1.0 if fixed[0] is gap.left else -1.0
    if fixed[0].carts:
        accounts.push_from_outside(toward * impulse)
        return
    *others, last = sorted(gap.links, key=lambda link: not link.linear)
    if time > 0.0 and any(link.kind != last.kind for link in others):
        summed, change = over()
        for link in others:
            # A linear force is on average what it is at the average of gap and rate.
            own = link.force(-summed / time, -change / time) * time
            accounts.push_from_outside(toward * own, link.kind)
            impulse -= own
    accounts.push_from_outside(toward * impulse, last.kind)
