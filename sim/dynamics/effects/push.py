"""push: a constant force on one cart for a time, by a hand or whatever `by` names.

    F = force      for from <= t < until      (until left out: to the end of the run)

+ pushes to the right. F is external: it gives the cart the impulse F × (until − from), and its
work F × (distance meanwhile) is the only energy it brings. Source: Newton's second law.
"""

from __future__ import annotations

import math

from sim.dynamics.effects.base import Acting, Pull
from sim.scene.effects import Effect
from sim.scene.model import Scene


class Push(Acting):
    """A constant pull between two switches."""

    kind = "push"

    def __init__(self, effect: Effect, scene: Scene) -> None:
        names = [cart.name for cart in scene.carts]
        self._cart = names.index(effect.carts[0])
        self._pull = Pull("push", steady=effect.numbers["force"])
        self._from = effect.numbers.get("from", 0.0)
        self._until = effect.numbers.get("until", math.inf)

    def pull(self, cart: int, t: float) -> Pull | None:
        """The force while it lasts."""
        return self._pull if cart == self._cart and self._from <= t < self._until else None

    def switches(self) -> tuple[float, ...]:
        """Its beginning and its end."""
        return (self._from, self._until)


act = Push
