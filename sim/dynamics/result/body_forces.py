"""The forces of effects on single carts, named, along a trajectory: for free-body drawings.

Columns are called ("E", kind, cart), in N, + to the right. A force between two neighbours (contact,
spring, magnets) is in the column of their gap. What static friction does is what is left over in
m a = sum of all forces, because it has no formula of its own.
"""

from __future__ import annotations

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
    t: float,
) -> dict[tuple[str, str], float]:
    """N by name; `states` are x, v, a of each cart, `between` the forces of neighbours by gap.

    `t` [s] lies inside the interval whose formulas hold: a push that begins there counts already.
    """
    assert run.forces is not None
    forces: dict[tuple[str, str], float] = {}
    for k, (cart, (_, v, a)) in enumerate(zip(run.scene.carts, states, strict=True)):
        total = between.get(k, 0.0) - between.get(k + 1, 0.0)
        for one in run.forces.on_cart(k, t):
            force = one.at(v)
            key = (one.kind, cart.name)
            forces[key] = forces.get(key, 0.0) + force
            total += force
        grip = run.forces.friction_on(k)
        if grip is not None:
            sliding = motion[k].sliding
            force = -sliding * grip if sliding else cart.mass * a - total
            forces[FRICTION, cart.name] = force
    return forces
