"""spring: linear in gap and rate."""

from __future__ import annotations

from sim.effects.linear import Linear
from sim.scene.effects import Effect


def linear(effect: Effect) -> Linear:
    """Its stiffness, length and damping."""
    n = effect.numbers
    return Linear(spring=(n["stiffness"], n["length"], n["damping"]))
