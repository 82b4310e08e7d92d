"""incline: its pull along the track is constant."""

from __future__ import annotations

from sim.effects.constant import Constant
from sim.scene.effects import Effect


def constant(effect: Effect) -> Constant:
    """The angle of the track."""
    return Constant(angle=effect.numbers["angle"])
