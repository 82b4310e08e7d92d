"""A touch without a duration: an impact, and the velocity that two share."""

from __future__ import annotations

from sim.certify.bodies import Body, Gap
from sim.certify.numbers.balls import ZERO, Ball, NoBoundError, exact, is_zero
from sim.scene.said import said

BOUNCES = 20
FAINT = 2.0**-100
"""Of the hardest impact of a gap. So faint a one, after so many, is one of a series without end: by
chance none is, and each further one would take as long to prove as the first."""


def impact(gap: Gap) -> None:
    """v′ = V + e (V − v), at once."""
    restitution = gap.contact.restitution
    e = exact(restitution or 0.0)
    left, right = gap.left, gap.right
    common = common_velocity(left, right)
    closing = -gap.rate
    for body in (left, right):
        if body.mass is not None:
            body.v = common if is_zero(e) else common + e * (common - body.v)
            body.held = False
    gap.room, gap.rate = ZERO, e * closing


def no_last_bounce(gap: Gap) -> None:
    """Raises where bounces come faster and faster: of infinitely many there is no list."""
    closing = abs(gap.rate)
    gap.struck += 1
    gap.hardest = closing if closing > gap.hardest else gap.hardest
    if gap.struck > BOUNCES and closing < FAINT * gap.hardest:
        raise NoBoundError(said("{pair} bounce ever faster, without a last time", pair=gap.shown))


def common_velocity(left: Body, right: Body) -> Ball:
    """m/s, of the common centre; a wall stands still."""
    if left.mass is None or right.mass is None:
        return ZERO
    return (left.mass * left.v + right.mass * right.v) / (left.mass + right.mass)


def reduced_mass(left: Body, right: Body) -> Ball:
    """kg; None between two that do not move."""
    if left.mass is None or right.mass is None:
        return right.mass if left.mass is None else left.mass
    return left.mass * right.mass / (left.mass + right.mass)
