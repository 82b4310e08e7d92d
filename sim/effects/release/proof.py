"""From rest: m v are equal and opposite, and ½ m v² together is E."""

from __future__ import annotations

import math

from sim.scene.model import Scene

SCENE = "release-explosion"


def end(scene: Scene) -> dict[str, tuple[float, float]]:
    """x [m] and v [m/s] of each cart at the end, by hand."""
    (a, b), n = scene.carts, scene.effects[0].numbers
    mu, left = a.mass * b.mass / (a.mass + b.mass), scene.until - n["at"]
    p = math.sqrt(2.0 * n["energy"] * mu)
    return {
        "A": (a.position - p / a.mass * left, -p / a.mass),
        "B": (b.position + p / b.mass * left, p / b.mass),
    }
