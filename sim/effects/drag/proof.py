"""v falls by a factor e in each m/b."""

from __future__ import annotations

import math

from sim.scene.model import Scene

SCENE = "drag-linear"


def end(scene: Scene) -> dict[str, tuple[float, float]]:
    """x [m] and v [m/s] of each cart at the end, by hand."""
    (a,), n, t = scene.carts, scene.effects[0].numbers, scene.until
    left = math.exp(-n["linear"] * t / a.mass)
    return {"A": (a.position + a.mass * a.velocity / n["linear"] * (1.0 - left), a.velocity * left)}
