"""Where an effect between two bodies acts."""

from __future__ import annotations

from sim.scene.effects import Effect
from sim.scene.model import Scene


def gap_of(effect: Effect, scene: Scene) -> int:
    """Index of the gap between the two neighbours that an effect names."""
    assert effect.between is not None
    count = len(scene.carts)
    return next(k for k in range(count + 1) if scene.names_at(k) == effect.between)
