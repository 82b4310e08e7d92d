"""drag: linear in the velocity where it has no quadratic part."""

from __future__ import annotations

from sim.effects.linear import Linear
from sim.scene.effects import Effect


def linear(effect: Effect) -> Linear | None:
    """b alone."""
    n = effect.numbers
    return None if n["quadratic"] else Linear(drag=n["linear"])
