"""g sin θ all the time, also at the top."""

from __future__ import annotations

import math

from sim.scene.model import Scene

SCENE = "incline-up-and-down"


def end(scene: Scene) -> dict[str, tuple[float, float]]:
    """x [m] and v [m/s] of each cart at the end, by hand."""
    (a,), n, t = scene.carts, scene.effects[0].numbers, scene.until
    down = scene.gravity * math.sin(n["angle"])
    return {"A": (a.position + a.velocity * t + 0.5 * down * t * t, a.velocity + down * t)}
