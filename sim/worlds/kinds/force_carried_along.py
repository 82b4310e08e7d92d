"""force-carried-along: a push is carried along by the thing, and is used up.

    v = q/c        q [N] is what is left of the push, q' = −q/τ without a new one

So the velocity fades by a factor e in each τ, and nothing takes the momentum: F = −(m/τ) v from
nowhere. The law names a velocity: on a train everything would run to the train's back.
"""

from __future__ import annotations

from sim.scene import quantity
from sim.scene.fields import Field
from sim.scene.said import said, template
from sim.worlds.describe import WorldKind
from sim.worlds.force import Impossible

KIND = WorldKind(
    name="force-carried-along",
    belief="force-carried-along",
    says=template("a push is carried along and used up"),
    nothing=template(
        "With these values nothing breaks that could be seen. Give a cart a velocity, "
        "or let a push last less long."
    ),
    place=60,
    fields=(
        Field(
            "lasts",
            quantity.TIME,
            "1",
            "until a third of a push is left",
            least="0.001",
            label=said("how long a push lasts"),
        ),
    ),
    moves=True,
)


class ForceCarriedAlong(Impossible):
    """What moves comes to rest by itself."""

    def resistance(self, mass: float) -> float:
        """m/τ."""
        return mass / self.numbers["lasts"]


act = ForceCarriedAlong
