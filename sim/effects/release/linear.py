"""release: linear in the room while its spring pushes; without one it acts at one instant."""

from __future__ import annotations

from sim.effects.linear import Linear
from sim.scene.effects import Effect


def linear(effect: Effect) -> Linear:
    """Energy, time, and the stiffness of its spring."""
    n = effect.numbers
    return Linear(release=(n["energy"], n["at"], n.get("stiffness")))
