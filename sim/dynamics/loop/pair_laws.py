"""What every touch of two bodies comes to: each law of nature is applied once, here.

two carts  v' = V + e (V − v)  (see `impact`)        a wall  v' = −e v
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from sim.dynamics.motion.impact import rebound
from sim.dynamics.state.body import Accounts, Body


def common_velocity(left: Body, right: Body) -> float:
    """m/s, of the common centre of mass; 0 with a wall."""
    if math.inf in (left.mass, right.mass):
        return 0.0
    if left.v == right.v:
        return left.v  # as of any number that move alike, see below
    return (left.mass * left.v + right.mass * right.v) / (left.mass + right.mass)


def centre_velocity(bodies: Sequence[tuple[float, float]]) -> float:
    """m/s, of the centre of mass of any number, by mass [kg] and velocity; 0 with a wall.

    Of bodies that move alike it is theirs to the last bit: else a touch that changes nothing would
    give them a speed of rounding against the next one, which would touch in its turn, for ever.
    """
    if any(mass == math.inf for mass, _ in bodies):
        return 0.0
    if len({v for _, v in bodies}) == 1:
        return bodies[0][1]
    momentum = math.fsum(mass * v for mass, v in bodies)
    return momentum / math.fsum(mass for mass, _ in bodies)


def velocities_after(left: Body, right: Body, e: float) -> tuple[float, float]:
    """m/s, after an impact with restitution e."""
    return rebound(left.mass, right.mass, left.v, right.v, e)


def shares(left: Body, right: Body, mu: float) -> tuple[float, float]:
    """mu/mA and mu/mB; nought for a wall."""
    return mu / left.mass, mu / right.mass


def outside(left: Body, right: Body, impulse: float, accounts: Accounts) -> None:
    """A wall pushes from outside: book its impulse."""
    if left.mass == math.inf:
        accounts.push_from_outside(impulse)
    elif right.mass == math.inf:
        accounts.push_from_outside(-impulse)
