"""Effects: what acts on carts besides contacts. Each is a file with its formula on top.

Nothing acts that a scene does not list: `acting` imports the modules of the listed kinds and no
others. A new effect is a row in `sim.scene.effects` and a module here with a function `act`.
"""

from __future__ import annotations

from importlib import import_module

from sim.dynamics.effects.base import Acting, Grip, Link, Pull
from sim.scene.model import Scene

__all__ = ["Acting", "Grip", "Link", "Pull", "acting"]


def acting(scene: Scene) -> tuple[Acting, ...]:
    """The numerics of the listed effects, in the order listed."""
    return tuple(
        import_module(f"sim.dynamics.effects.{effect.kind}").act(effect, scene)
        for effect in scene.effects
    )
