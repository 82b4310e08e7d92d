"""incline: a tilted track.

    F = m g sin θ      along the track; θ > 0 drives carts to the right (downhill is right)

θ [rad] is the angle of the track, g [m/s²] the scene's gravity. The track carries the rest of the
weight, m g cos θ, at right angles to the motion: that part does no work. x is measured along the
track. The work of F is a change of gravitational energy: E = −m g sin θ (x − x(0)), nought where
each cart starts. Source: Newton's second law, any textbook.
"""

from __future__ import annotations

import math

from sim.effects.forces import Acting, BodyForce
from sim.effects.where import carts_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


class Incline(Acting):
    """A constant force on each listed cart."""

    kind = "incline"

    def __init__(self, effect: Effect, scene: Scene) -> None:
        slope = scene.gravity * math.sin(effect.numbers["angle"])
        self._forces = {
            k: BodyForce("incline", steady=scene.carts[k].mass * slope)
            for k in carts_of(effect, scene)
        }

    def body_force(self, cart: int, t: float) -> BodyForce | None:
        """m g sin θ."""
        return self._forces.get(cart)


act = Incline
