"""friction: dry (Coulomb) friction between a cart and the track.

    sliding    F = −μ N sign(v)                      N = m g cos θ, the force of the track
    at rest    F = −(all other forces), while their sum is at most μ_s N; beyond that it slides

μ is `coefficient`, μ_s `static` (the same unless given), θ the angle of the `incline` if the scene
has one. F is external: it takes momentum to the Earth. Its work, −μ N × distance, warms track and
wheels. Alone it is a parabola up to the stop:

    v = v0 − μ g t      x_stop = v0² / (2 μ g)      t_stop = v0 / (μ g)

Source: C. A. de Coulomb, Théorie des machines simples (1785); any textbook.
"""

from __future__ import annotations

import math

from sim.dynamics.effects.base import Acting, Grip
from sim.scene.effects import Effect
from sim.scene.model import Scene


class Friction(Acting):
    """A grip on each listed cart."""

    kind = "friction"

    def __init__(self, effect: Effect, scene: Scene) -> None:
        kinetic = effect.numbers["coefficient"]
        static = max(kinetic, effect.numbers.get("static", kinetic))
        self._grips = {}
        for k, cart in enumerate(scene.carts):
            if cart.name in effect.carts:
                support = cart.mass * scene.gravity * math.cos(angle_under(cart.name, scene))
                self._grips[k] = Grip(kinetic * support, static * support)

    def grip(self, cart: int) -> Grip | None:
        """μ N and μ_s N."""
        return self._grips.get(cart)


def angle_under(cart: str, scene: Scene) -> float:
    """rad. Angle of the track under a cart."""
    return sum(
        other.numbers["angle"]
        for other in scene.effects
        if other.kind == "incline" and cart in other.carts
    )


act = Friction
