"""Accelerations at the end of a run, before what moves the bodies is settled.

A cart that stands still is at rest only where nothing accelerates it: at the top of its way it has
v = 0 and turns round.
"""

from __future__ import annotations

import math

from sim.dynamics.state.body import Body
from sim.dynamics.state.clock import Time, elapsed

ALIKE = 1e-9
"""Of the greater: accelerations that differ by less are those of bodies that move as one."""


def last_accelerations(bodies: list[Body], count: int, end: Time) -> tuple[float, ...]:
    """m/s² of each of `count` carts; nought in free flight, and where static friction holds."""
    found = [0.0] * count
    for body in bodies:
        if body.motion is None:
            continue
        a = _acceleration(body, end)
        if a and not _holds(body, a, end):
            for cart in body.carts:
                found[cart] = a
    return tuple(found)


def _acceleration(body: Body, now: Time) -> float:
    motion = body.motion
    return 0.0 if motion is None else motion.state(motion.side(body), elapsed(motion.begun, now))[2]


def _holds(body: Body, a: float, now: Time) -> bool:
    """Does friction stop it just now, or one that it moves as one with, and then hold it?

    The stop may be due a rounding after the end, and friction is drawn as sliding until then.
    """
    assert body.motion is not None
    for one in body.motion.bodies:
        if one.sliding * a < 0.0 and math.isclose(_acceleration(one, now), a, rel_tol=ALIKE):
            driving = one.mass * a + one.sliding * one.load.kinetic  # N, of all but friction
            if abs(driving) <= one.load.static:
                return True
    return False
