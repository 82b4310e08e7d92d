"""reaction-comes-later: the one that runs into the other is pushed back only after a while.

    N on the one that is hit = N(t)        N on the one that hits = N(t − delay)

Until then there is momentum that came from nowhere. Which of the two hits is which of them is
faster when they touch.
"""

from __future__ import annotations

from sim.scene import quantity
from sim.scene.fields import Field
from sim.scene.said import said, template
from sim.worlds.describe import WorldKind
from sim.worlds.force import Impossible

KIND = WorldKind(
    name="reaction-comes-later",
    belief="reaction-comes-later",
    says=template("the second force comes later"),
    nothing=template(
        "With these values nothing breaks: the two never push each other. Change a velocity."
    ),
    place=50,
    fields=(
        Field(
            "delay",
            quantity.TIME,
            "0.3",
            "by how much later",
            least="0",
            above=True,
            label=said("delay of the second force"),
        ),
    ),
    needs="pair",
    moves=True,
)


class ReactionComesLater(Impossible):
    """One of the two forces is late."""

    @property
    def delay(self) -> float:
        """s."""
        return self.numbers["delay"]


act = ReactionComesLater
