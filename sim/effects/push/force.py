"""push: a constant force on one cart for a time, by a hand or whatever `by` names.

    F = force      for from <= t < until      (until left out: to the end of the run)

+ pushes to the right. F is external: it gives the cart the impulse F × (until − from), and its
work F × (distance meanwhile) is the only energy it brings. Source: Newton's second law.
"""

from __future__ import annotations

import math

from sim.effects.forces import Acting, BodyForce
from sim.effects.where import carts_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


class Push(Acting):
    """A constant force between two switches."""

    kind = "push"

    def __init__(self, effect: Effect, scene: Scene) -> None:
        (self._cart,) = carts_of(effect, scene)
        self._force = BodyForce("push", steady=effect.numbers["force"])
        self._from = effect.numbers["from"]
        self._until = effect.numbers.get("until", math.inf)

    def body_force(self, cart: int, t: float) -> BodyForce | None:
        """The force while it lasts."""
        return self._force if cart == self._cart and self._from <= t < self._until else None

    def switches(self) -> tuple[float, ...]:
        """Its beginning and its end."""
        return (self._from, self._until)


act = Push
