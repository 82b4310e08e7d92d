"""The forces of effects on single carts, named, along a trajectory: for free-body drawings.

Columns are called ("E", kind, cart), in N, + to the right. A force between two neighbours (contact,
spring, magnets) is in the column of their gap. What static friction does is what is left over in
m a = sum of all forces, because it has no formula of its own; carts that stick together share it by
how much each can hold.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from dataclasses import dataclass

from sim.dynamics.result.record import Piece
from sim.effects.forces import FRICTION, BodyForce, CoulombFriction
from sim.scene.model import Cart, Scene


def names(scene: Scene) -> list[tuple[str, str]]:
    """(kind, cart) of every effect that acts on single carts, in the order listed."""
    found = {
        (effect.kind, name): None
        for effect in scene.effects
        if effect.between is None
        for name in effect.carts
    }
    return list(found)


@dataclass(frozen=True, slots=True)
class Outside:
    """What acts on single carts while no push begins or ends."""

    carts: tuple[Cart, ...]
    forces: list[list[BodyForce]]
    grips: list[CoulombFriction | None]

    def limits(self, body: range) -> float:
        """N. What friction at rest could bear of these carts."""
        return math.fsum(grip.static for k in body if (grip := self.grips[k]))

    def slope(self, k: int, v: float, a: float) -> float:
        """N/s. How fast the forces that change with velocity grow on cart k."""
        return -a * math.fsum(f.linear + 2.0 * f.quadratic * abs(v) for f in self.forces[k])


def at(
    outside: Outside,
    states: list[tuple[float, float, float]],
    motion: list[Piece],
    between: dict[int, float],
    stuck: Collection[int],
) -> dict[tuple[str, str], float]:
    """N by name; `states` are x, v, a of each cart, `between` the forces of neighbours by gap,
    without those of `stuck` gaps, whose carts move as one."""
    carts, grips = outside.carts, outside.grips
    forces: dict[tuple[str, str], float] = {}
    resting_force: list[float] = []  # N, of m a: for friction at rest, and for what joins carts
    for k, (cart, (_, v, a)) in enumerate(zip(carts, states, strict=True)):
        total = between.get(k, 0.0) - between.get(k + 1, 0.0)
        for one in outside.forces[k]:
            force = one.at(v)
            key = (one.kind, cart.name)
            forces[key] = forces.get(key, 0.0) + force
            total += force
        resting_force.append(cart.mass * a - total)
    for body in bodies(len(states), stuck):
        on_wall = body[0] in stuck or body[-1] + 1 in stuck  # which bears all
        held = 0.0 if on_wall else math.fsum(resting_force[k] for k in body)
        limits = outside.limits(body)
        for k in body:
            if (grip := grips[k]) is None:
                continue
            side = 0 if on_wall else motion[k].sliding
            # No law says how a body shares it; so none bears more of its limit than another.
            share = grip.static / limits if limits else 1.0 / len(body)
            forces[FRICTION, carts[k].name] = -side * grip.kinetic if side else held * share
    return forces


def bodies(count: int, stuck: Collection[int]) -> Iterator[range]:
    """Carts that move as one, from left to right."""
    first = 0
    for k in range(1, count + 1):
        if k == count or k not in stuck:
            yield range(first, k)
            first = k
