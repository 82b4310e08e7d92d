"""Inelastic collapse: infinitely many impacts in a finite time end in one velocity.

Three or more bodies (a wall is one) that hit each other without a duration and with little
restitution do so infinitely often before a certain time: each round of impacts leaves a fixed part
q < 1 of their relative speeds and, with it, of the time to the next round. The sum of that
geometric series is the time of collapse; after it they go on together, and rooms and relative
speeds are nought. (McNamara & Young, Phys. Fluids A 4 (1992) 496; three equal bodies: e < 7 − 4
sqrt 3.)

Of three that touch and are hit in turn in two gaps the limit is known at once (`hit_in_turn`), and
of any number that give nothing back (`plastic`).

Of more bodies, and of three that other things act on, rounds are linear maps of the relative
speeds: whatever they begin with, the greatest eigenvalue q of one round remains. Where the same
round has come again and again, and every speed in it is q < 1 times that of the round before, and
was so before (`Hits`), no later round differs: the rest of the series is left out.

Otherwise the rounds are followed as they are, until the speed of approach is rounding: the rest of
the series is shorter than the last bit of the time, and every further impact would be one of
rounding errors, which have no end. Then all that touch and move alike get the velocity of their
centre of mass at once, so that no two of them can differ by rounding and begin anew.
"""

from __future__ import annotations

import math

from sim.dynamics.loop import plastic
from sim.dynamics.loop.first_struck import touches
from sim.dynamics.loop.pair_laws import centre_velocity
from sim.dynamics.loop.rounds import Hits
from sim.dynamics.motion.hit_in_turn import at_once_for_ever, for_ever
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.chain import Chain, velocity
from sim.dynamics.state.clock import Time, elapsed
from sim.dynamics.state.flips import UNDECIDED

ROUNDING = 1e-15
"""Of the velocities of two bodies, or of the approach of a third, per impact at one instant: what
rounding leaves of a relative speed. The errors of many impacts add up."""


def third(chain: Chain, gap: Gap, now: Time, instant: float) -> Gap | None:
    """The gap beside this one with which it is hit in turn, infinitely often from now on.

    None where what is beside the two may be hit in between.
    """
    for other in chain.neighbours(gap):
        if other is None or not _is_hit_in_turn(other, now, instant):
            continue
        if not _are_alone(chain, gap, other, now):
            continue
        middle = gap.right if other.left is gap.right else gap.left
        if middle.mass == math.inf or gap.rate >= 0.0:
            continue
        outer = gap.left if gap.right is middle else gap.right
        beyond = other.left if other.right is middle else other.right
        if for_ever(
            [1.0 / body.mass for body in (outer, middle, beyond)],
            [-gap.rate, -_rate(other, now)],
            [one.contact.restitution or 0.0 for one in (gap, other)],
        ):
            return other
    return None


def _is_hit_in_turn(other: Gap, now: Time, instant: float) -> bool:
    alike = other.law is None and not other.contact.joins and not other.joined
    touches = other.solver is None and abs(elapsed(other.changed, now)) <= instant
    return alike and touches and _rate(other, now) >= 0.0


def either_first(chain: Chain, block: list[Gap], now: Time) -> bool:
    """Would two that close equally fast be hit in turn for ever, whichever came first?"""
    if len(block) != 2 or any(gap.contact.joins for gap in block):
        return False
    return _are_alone(chain, block[0], block[1], now) and at_once_for_ever(
        [1.0 / body.mass for body in (block[0].left, block[0].right, block[1].right)],
        [-gap.rate for gap in block],
        [gap.contact.restitution or 0.0 for gap in block],
    )


def _are_alone(chain: Chain, gap: Gap, other: Gap, now: Time) -> bool:
    """Does no gap beside these two touch at this instant by a law without a duration?"""
    beside = {*chain.neighbours(gap), *chain.neighbours(other)} - {gap, other, None}
    return not any(near is not None and touches(near, now) for near in beside)


def _rate(gap: Gap, now: Time) -> float:
    return velocity(gap.right, now) - velocity(gap.left, now)


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


def run_of(chain: Chain, block: list[Gap], now: Time, instant: float, hits: Hits) -> list[Gap]:
    """The gaps of all bodies that the coming impact leaves with one velocity; often none.

    `block`: those in which it comes. From left to right. They touch without a duration.
    """
    often = False
    for gap in block:
        if gap.law is not None or gap.contact.joins:
            return []
        often = often or gap.flips + 1 >= UNDECIDED
    if not often:
        return []
    if row := plastic.row_of(chain, block, now):
        return row
    for gap in block:
        hits.note(gap, now, instant)
    if (found := hits.rounds()) is not None:
        inside = [one for one in chain.gaps[found[0] : found[1] + 1] if one is not None]
        alike = all(one.joined or _is_plain_hit(one, now, instant) for one in inside)
        if alike and any((one.contact.restitution or 0.0) < 1.0 for one in inside):
            hits.collapse()
            return [one for one in inside if not one.joined]
    other = third(chain, block[0], now, instant) if len(block) == 1 else None
    if other is None and not all(is_over(chain, gap, now, instant) for gap in block):
        return []
    run = block if other is None else sorted([block[0], other], key=lambda one: one.index)
    return _with_collapsed(chain, run, now, instant)


def _is_plain_hit(gap: Gap, now: Time, instant: float) -> bool:
    """Was it hit at this instant? A gap between two groups that collapse at once was not."""
    return gap.law is None and not gap.contact.joins and elapsed(gap.changed, now) <= instant


def _with_collapsed(chain: Chain, run: list[Gap], now: Time, instant: float) -> list[Gap]:
    """With the gaps beside them that were hit at the same instant, and move alike."""
    run = list(run)
    while _collapsed(before := chain.neighbours(run[0])[0], now, instant):
        assert before is not None
        run.insert(0, before)
    while _collapsed(after := chain.neighbours(run[-1])[1], now, instant):
        assert after is not None
        run.append(after)
    return run


def together(run: list[Gap], now: Time, ledger: Ledger) -> None:
    """All bodies of these gaps, settled, get one velocity."""
    one_velocity([run[0].left, *(member.right for member in run)], ledger)
    for member in run:
        member.rate, member.time, member.room = 0.0, now, 0.0


def _collapsed(gap: Gap | None, now: Time, instant: float) -> bool:
    """Was this gap hit at the same instant, and do its bodies move alike?"""
    if gap is None or gap.law is not None or gap.joined or gap.solver is not None:
        return False
    close = abs(_rate(gap, now)) <= ROUNDING * max(gap.flips, 1) * _scale(gap)
    return close and elapsed(gap.changed, now) <= instant


def one_velocity(group: list[Body], ledger: Ledger) -> None:
    """All these bodies get the velocity of their centre of mass; with a wall among them, 0."""
    movers = [body for body in group if body.mass < math.inf]
    fixed = len(movers) < len(group)  # a wall is among them, or a cart that sticks to one
    momentum = math.fsum(body.mass * body.v for body in movers)
    v = centre_velocity([(body.mass, body.v) for body in group])
    for body in movers:
        ledger.dissipate(0.5 * body.mass * (body.v - v) * (body.v + v))
        body.v = v
    if fixed:
        ledger.push_from_outside(-momentum)
