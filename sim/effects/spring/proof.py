"""A swing with ω² = k/mu about the centre of mass, which goes on."""

from __future__ import annotations

import math

from sim.scene.model import Scene

SCENE = "spring-pair"


def end(scene: Scene) -> dict[str, tuple[float, float]]:
    """x [m] and v [m/s] of each cart at the end, by hand."""
    (a, b), n, t = scene.carts, scene.effects[0].numbers, scene.until
    total = a.mass + b.mass
    mu, centre = a.mass * b.mass / total, (a.mass * a.velocity + b.mass * b.velocity) / total
    w = math.sqrt(n["stiffness"] / mu)
    stretch, rate = scene.gaps[1] - n["length"], b.velocity - a.velocity
    now = stretch * math.cos(w * t) + rate / w * math.sin(w * t)
    speed = rate * math.cos(w * t) - stretch * w * math.sin(w * t)
    change = now - stretch
    return {
        "A": (a.position + centre * t - mu / a.mass * change, centre - mu / a.mass * speed),
        "B": (b.position + centre * t + mu / b.mass * change, centre + mu / b.mass * speed),
    }
