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

from sim.effects.forces import Acting, CoulombFriction
from sim.effects.incline import angle_under
from sim.effects.where import carts_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


class Friction(Acting):
    """Friction on each listed cart."""

    kind = "friction"

    def __init__(self, effect: Effect, scene: Scene) -> None:
        kinetic = effect.numbers["coefficient"]
        static = effect.numbers.get("static", kinetic)
        self._on: dict[int, CoulombFriction] = {}
        for k in carts_of(effect, scene):
            support = support_of(k, scene)
            self._on[k] = CoulombFriction(kinetic * support, static * support)

    def friction(self, cart: int) -> CoulombFriction | None:
        """μ N and μ_s N."""
        return self._on.get(cart)


def support_of(cart: int, scene: Scene) -> float:
    """N. m g cos θ, the force with which the track carries a cart."""
    one = scene.carts[cart]
    return one.mass * scene.gravity * math.cos(angle_under(one.name, scene))


act = Friction
