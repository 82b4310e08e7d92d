"""Bumpers that stay pressed in: with e = 0 and a push behind, two carts go on as one.

Such a bumper takes any force from nothing to k times its overlap without moving. A method that
only knows “pressing in” and “apart” would leap from one to the other, ever faster; so a located
method joins the two, and asks for the force that keeps them together:

    m_k a_k = N_k − N_(k+1) + others_k        held while 0 < N < k d
"""

from __future__ import annotations

from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.joint_forces import joint_forces
from sim.dynamics.stepping.pairs import Pair, PerCart


def stays_pressed(field: Field, pair: Pair, t: float, s: PerCart, v: PerCart) -> bool:
    """Would the two close at once, were it not for their bumper? It has just come to a stop."""
    force = pair.force
    if force is None or not force.locks or field.memory[pair.gap] <= 0.0:
        return False
    a = field.moved(field.forces(t, s, v)[2], v, 0.0)[0]
    left = 0.0 if pair.left is None else a[pair.left]
    right = 0.0 if pair.right is None else a[pair.right]
    return bool(left - right > 0.0)


def hold(field: Field, pair: Pair) -> None:
    """From now on they are one body."""
    field.held.add(pair.gap)
    field.join(pair.gap)


def one_velocity(field: Field, pair: Pair, v: PerCart) -> None:
    """Of two that have come to a stop on each other: what rounding leaves of their rate goes, so
    that they do not touch once more for it. Momentum stays."""
    bodies = [body for body in field.bodies if pair.left in body or pair.right in body]
    carts = [k for body in bodies for k in body]
    if None in (pair.left, pair.right) or any(map(field.fixed, bodies)):
        common = 0.0
    else:
        common = sum(field.mass[k] * v[k] for k in carts) / sum(field.mass[k] for k in carts)
    for k in carts:
        v[k] = common


def let_go(field: Field, gap: int) -> None:
    """Two bodies again."""
    field.held.discard(gap)
    field.join(gap, part=True)


def guards(field: Field, t: float, s: PerCart, v: PerCart) -> dict[int, tuple[float, float]]:
    """By gap: the force that it takes, and how much more the bumper would take; both in N."""
    total = field.forces(t, s, v)[2]
    a, rub = field.moved(total, v, 0.0)
    found = {}
    joints = joint_forces(field, total, rub, a)
    for gap in field.held:
        push = joints[gap]
        force = field.pair_at[gap].force
        assert force is not None
        found[gap] = (push, force.most(field.memory[gap]) - push)
    return found
