"""Inelastic collapse: infinitely many impacts in a finite time end in one velocity.

Three or more bodies (a wall is one) that hit each other without a duration and with little
restitution do so infinitely often before a certain time: each round of impacts leaves a fixed part
q < 1 of their relative speeds and, with it, of the time to the next round. The sum of that
geometric series is the time of collapse; after it they go on together, and rooms and relative
speeds are nought. (McNamara & Young, Phys. Fluids A 4 (1992) 496; three equal bodies: e < 7 − 4
sqrt 3.)

The rounds are followed as they are, until the speed of approach is rounding: the rest of the series
is shorter than the last bit of the time, and every further impact would be one of rounding errors,
which have no end. Then all that touch and move alike get the velocity of their centre of mass at
once, so that no two of them can differ by rounding and begin anew.
"""

from __future__ import annotations

import math

from sim.dynamics.result.ledger import Ledger
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.chain import Chain
from sim.dynamics.state.clock import Time, elapsed
from sim.dynamics.state.flips import UNDECIDED

ROUNDING = 1e-15
"""Of the velocities of two bodies, or of the approach of a third, per impact at one instant: what
rounding leaves of a relative speed. The errors of many impacts add up."""


def is_over(chain: Chain, gap: Gap, now: Time, instant: float) -> bool:
    """Has the speed of this approach become rounding, after impacts at one instant?"""
    if gap.flips < UNDECIDED:
        return False
    scale = _scale(gap)
    for other in chain.neighbours(gap):
        if other is not None and other.solver is None and elapsed(other.changed, now) <= instant:
            scale = max(scale, abs(other.rate), _scale(other))
    return -gap.rate <= ROUNDING * gap.flips * scale


def _scale(gap: Gap) -> float:
    """m/s. The greater velocity of its bodies."""
    return max(abs(gap.left.v), abs(gap.right.v))


def together(chain: Chain, gap: Gap, now: Time, instant: float, ledger: Ledger) -> None:
    """The bodies of `gap`, and all that collapsed onto them, go on with one velocity."""
    run = [gap]
    while _collapsed(
        before := chain.gaps[run[0].left.left] if run[0].left.carts else None, now, instant
    ):
        assert before is not None
        run.insert(0, before)
    while _collapsed(
        after := chain.gaps[run[-1].right.right] if run[-1].right.carts else None, now, instant
    ):
        assert after is not None
        run.append(after)
    one_velocity([run[0].left, *(member.right for member in run)], ledger)
    for member in run:
        member.rate, member.time = 0.0, now
        member.room = 0.0


def _collapsed(gap: Gap | None, now: Time, instant: float) -> bool:
    """Was this gap hit at the same instant, and do its bodies move alike?"""
    if gap is None or gap.law is not None or gap.joined or gap.solver is not None:
        return False
    close = abs(gap.right.v - gap.left.v) <= ROUNDING * max(gap.flips, 1) * _scale(gap)
    return close and elapsed(gap.changed, now) <= instant


def one_velocity(group: list[Body], ledger: Ledger) -> None:
    """All these bodies get the velocity of their centre of mass; with a wall among them, 0."""
    movers = [body for body in group if body.mass < math.inf]
    fixed = len(movers) < len(group)  # a wall is among them, or a cart that sticks to one
    momentum = math.fsum(body.mass * body.v for body in movers)
    v = 0.0 if fixed else momentum / math.fsum(body.mass for body in movers)
    for body in movers:
        ledger.dissipate(0.5 * body.mass * (body.v - v) * (body.v + v))
        body.v = v
    if fixed:
        ledger.push_from_outside(-momentum)
