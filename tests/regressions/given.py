"""Plain values that scenes of these tests are made of."""

from __future__ import annotations


def cart(position: float, velocity: float = 0.0, mass: float = 1.0) -> dict[str, float]:
    return {"mass": mass, "position": position, "velocity": velocity}
