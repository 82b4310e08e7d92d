"""What a world can change. A world overrides what it needs of `Impossible`.

shares       of a push, for the two bodies: (1, 1) in ours, whatever they are
delay        s, by which the force on the one that ran into the other comes later
resistance   kg/s, that holds each cart back in proportion to its velocity
scene        the scene itself, with another track
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module

from sim.scene.model import Scene
from sim.worlds.describe import FOLDER, World

Two = tuple[float, float]
EVEN: Two = (1.0, 1.0)


class Impossible:
    """A world as it changes one scene; this one changes nothing."""

    def __init__(self, numbers: Mapping[str, float]) -> None:
        self.numbers = numbers

    def scene(self, scene: Scene) -> Scene:
        """The scene that is run."""
        return scene

    def shares(self, masses: Two, v: Two, outside: Two) -> Two:
        """Factors of the push on the left and on the right cart, fixed when they touch; between a
        cart and a wall all is as in ours.

        `masses` [kg]; `v` [m/s] just before; `outside` [N]: all else that acts on each of the two.
        """
        return EVEN

    @property
    def delay(self) -> float:
        """s."""
        return 0.0

    def resistance(self, mass: float) -> float:
        """kg/s on a cart of that mass."""
        return 0.0


def parts(first: float, second: float) -> Two:
    """Factors in the ratio of two weights, 1 on average; even where neither has any."""
    both = abs(first) + abs(second)
    if both == 0.0:
        return EVEN
    return 2.0 * abs(first) / both, 2.0 * abs(second) / both


def at_work(world: World) -> Impossible:
    """The forces of a named world."""
    module = import_module(f"{FOLDER}.{world.kind.name.replace('-', '_')}")
    made: Impossible = module.act(world.numbers)
    return made
