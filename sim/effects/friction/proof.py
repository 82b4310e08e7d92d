"""It stops after v²/(2 μ g) and stays there."""

from __future__ import annotations

import math

from sim.scene.model import Scene

SCENE = "friction-stop"


def end(scene: Scene) -> dict[str, tuple[float, float]]:
    """x [m] and v [m/s] of each cart at the end, by hand."""
    (a,), n = scene.carts, scene.effects[0].numbers
    way = a.velocity**2 / (2.0 * n["coefficient"] * scene.gravity)
    return {"A": (a.position + math.copysign(way, a.velocity), 0.0)}
