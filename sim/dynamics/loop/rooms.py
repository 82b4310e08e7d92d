"""The room between two neighbours while they move, without moving them."""

from __future__ import annotations

from sim.dynamics.state.body import Gap
from sim.dynamics.state.chain import velocity
from sim.dynamics.state.clock import Time, later
from sim.dynamics.state.flips import UNDECIDED

SAME_SPEED = 1e-13
"""Relative to the velocities. Two that touch and move alike open or close by what acts on them."""


def resting(gap: Gap) -> float:
    """m. The overlap at which the pair would touch: a bumper that has not cleared remembers."""
    return 0.0 if gap.law is None or gap.room >= 0.0 else gap.law.resting_overlap(gap.memory)


def room_at(gap: Gap, now: Time, t: float) -> float:
    """m. The room of a gap t s after `now`: its present rate, and what the motions add to it."""
    return gap.room + gap.rate * t + _beyond(gap, now, t)


def clearance(gap: Gap, now: Time, t: float, rest: float) -> float:
    """m. The room beyond the resting overlap, t s after `now`.

    Where the pair parts and touches at one instant the two lengths, of millimetres, are subtracted
    first: it parts by 1e-19 m before it is pressed again, less than the last bit of either.
    """
    if rest == 0.0 or gap.flips <= UNDECIDED:
        return room_at(gap, now, t) + rest
    return (gap.room + rest) + (gap.rate * t + _beyond(gap, now, t))


def _beyond(gap: Gap, now: Time, t: float) -> float:
    """m. How much further the two move apart in t s than at their present rate."""
    left, right = gap.left.motion, gap.right.motion
    pulled = 0.0 if left is None else left.excess(gap.left, now, t)
    pushed = 0.0 if right is None else right.excess(gap.right, now, t)
    return pushed - pulled


def rate_at(gap: Gap, now: Time, t: float) -> float:
    """m/s. How fast the room grows t s after `now`."""
    if t == 0.0:
        return gap.rate
    moment = later(now, t)
    return velocity(gap.right, moment) - velocity(gap.left, moment)


def no_approach(gap: Gap, now: Time) -> bool:
    """Do the two move alike, but for rounding?"""
    largest = max(abs(velocity(gap.left, now)), abs(velocity(gap.right, now)))
    return abs(gap.rate) <= SAME_SPEED * largest
