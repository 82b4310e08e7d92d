"""The forces of effects on single carts, named, along a trajectory: for free-body drawings.

Columns are called ("E", kind, cart), in N, + to the right. A force between two neighbours (contact,
spring, magnets) is in the column of their gap. What static friction does is what is left over in
m a = sum of all forces, because it has no formula of its own; carts that stick together share it by
how much each can hold.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator

from sim.dynamics.result.finished import Run
from sim.dynamics.result.record import Piece
from sim.effects.forces import FRICTION


def names(run: Run) -> list[tuple[str, str]]:
    """(kind, cart) of every effect that acts on single carts, in the order listed."""
    found = {
        (effect.kind, name): None
        for effect in run.scene.effects
        if effect.between is None
        for name in effect.carts
    }
    return list(found)


def at(
    run: Run,
    states: list[tuple[float, float, float]],
    motion: list[Piece],
    between: dict[int, float],
    stuck: Collection[int],
    t: float,
) -> dict[tuple[str, str], float]:
    """N by name; `states` are x, v, a of each cart, `between` the forces of neighbours by gap,
    without those of `stuck` gaps, whose carts move as one.

    `t` [s] lies inside the interval whose formulas hold: a push that begins there counts already.
    """
    assert run.forces is not None
    forces: dict[tuple[str, str], float] = {}
    resting_force: list[float] = []  # N, of m a: for friction at rest, and for what joins carts
    for k, (cart, (_, v, a)) in enumerate(zip(run.scene.carts, states, strict=True)):
        total = between.get(k, 0.0) - between.get(k + 1, 0.0)
        for one in run.forces.on_cart(k, t):
            force = one.at(v)
            key = (one.kind, cart.name)
            forces[key] = forces.get(key, 0.0) + force
            total += force
        resting_force.append(cart.mass * a - total)
    grips = [run.forces.friction_on(k) for k in range(len(states))]
    for body in _bodies(len(states), stuck):
        on_wall = body[0] in stuck or body[-1] + 1 in stuck  # which bears all
        held = 0.0 if on_wall else math.fsum(resting_force[k] for k in body)
        limits = math.fsum(grip.static for k in body if (grip := grips[k]))
        for k in body:
            if (grip := grips[k]) is None:
                continue
            side = 0 if on_wall else motion[k].sliding
            # No law says how a body shares it; so none bears more of its limit than another.
            share = grip.static / limits if limits else 1.0 / len(body)
            forces[FRICTION, run.scene.carts[k].name] = (
                -side * grip.kinetic if side else held * share
            )
    return forces


def _bodies(count: int, stuck: Collection[int]) -> Iterator[range]:
    """Carts that move as one, from left to right."""
    first = 0
    for k in range(1, count + 1):
        if k == count or k not in stuck:
            yield range(first, k)
            first = k
