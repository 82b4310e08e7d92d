"""An impulse F × time, and what is left of the run at that velocity."""

from __future__ import annotations

from sim.scene.model import Scene

SCENE = "push-then-coast"


def end(scene: Scene) -> dict[str, tuple[float, float]]:
    """x [m] and v [m/s] of each cart at the end, by hand."""
    (a,), n, t = scene.carts, scene.effects[0].numbers, scene.until
    pushed = n["until"] - n["from"]
    v = a.velocity + n["force"] / a.mass * pushed
    way = a.velocity * n["until"] + 0.5 * n["force"] / a.mass * pushed**2
    return {"A": (a.position + way + v * (t - n["until"]), v)}
