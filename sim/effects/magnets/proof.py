"""With n = 3 from rest r² = r0² + (2 E/mu) t², E = C/(2 r0²)."""

from __future__ import annotations

import math

from sim.scene.model import Scene

SCENE = "magnets-repel"


def end(scene: Scene) -> dict[str, tuple[float, float]]:
    """x [m] and v [m/s] of each cart at the end, by hand."""
    (a, b), n, t = scene.carts, scene.effects[0].numbers, scene.until
    mu, start = a.mass * b.mass / (a.mass + b.mass), scene.gaps[1]
    twice = 2.0 * (n["strength"] / (2.0 * start * start)) / mu
    gap = math.sqrt(start * start + twice * t * t)
    grown, rate = gap - start, twice * t / gap
    return {
        "A": (a.position - mu / a.mass * grown, -mu / a.mass * rate),
        "B": (b.position + mu / b.mass * grown, mu / b.mass * rate),
    }
