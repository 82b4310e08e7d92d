"""drag: air resistance, linear and quadratic in the velocity.

    F = −b v − c v |v|           b [kg/s] is `linear`, c [kg/m] is `quadratic`; the air is at rest

    b alone   v = v0 e^(−b t/m)            x = x0 + (m v0/b) (1 − e^(−b t/m))
    c alone   v = v0 / (1 + c |v0| t/m)    x = x0 ± (m/c) ln(1 + c |v0| t/m)

F is external: it takes momentum to the air. Its work warms the air. Source: Stokes for b, Newton
for c; any textbook.
"""

from __future__ import annotations

from sim.effects.forces import Acting, BodyForce
from sim.effects.where import carts_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


class Drag(Acting):
    """The same b and c on each listed cart."""

    kind = "drag"

    def __init__(self, effect: Effect, scene: Scene) -> None:
        self._carts = carts_of(effect, scene)
        self._force = BodyForce(
            "drag",
            linear=effect.numbers["linear"],
            quadratic=effect.numbers["quadratic"],
        )

    def body_force(self, cart: int, t: float) -> BodyForce | None:
        """−b v − c v |v|."""
        return self._force if cart in self._carts else None


act = Drag
