"""passive-cannot-push: a wall is only in the way; it pushes nobody.

Then nothing stops what runs into it: the run is that of a track with open ends.
"""

from __future__ import annotations

import math
from dataclasses import replace

from sim.scene.model import Scene
from sim.scene.said import template
from sim.worlds.describe import WorldKind
from sim.worlds.force import Impossible

KIND = WorldKind(
    name="passive-cannot-push",
    belief="passive-cannot-push",
    says=template("a wall cannot push"),
    nothing=template("What runs into it goes on as if nothing were there."),
    place=40,
    needs="wall",
)


class PassiveCannotPush(Impossible):
    """Walls that do nothing."""

    def scene(self, scene: Scene) -> Scene:
        """The same carts without the walls."""
        return replace(
            scene,
            track=replace(scene.track, left="open", right="open"),
            contacts=(None, *scene.contacts[1:-1], None),
            gaps=(math.inf, *scene.gaps[1:-1], math.inf),
            approaches=(0.0, *scene.approaches[1:-1], 0.0),
        )


act = PassiveCannotPush
