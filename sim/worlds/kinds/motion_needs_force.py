"""motion-needs-force: a thing moves only while it is pushed, and as fast as it is pushed.

    v = (τ/m) F        reached within some τ: m v' = F − (m/τ) v

Without a push everything stands within some τ. The law names a velocity: whose?
"""

from __future__ import annotations

from sim.scene import quantity
from sim.scene.fields import Field
from sim.scene.said import said, template
from sim.worlds.describe import WorldKind
from sim.worlds.force import Impossible

KIND = WorldKind(
    name="motion-needs-force",
    belief="motion-needs-force",
    says=template("things move only while they are pushed"),
    nothing=template(
        "With these values nothing breaks that could be seen. Give a cart a velocity, "
        "or let things stop sooner."
    ),
    place=70,
    fields=(
        Field(
            "stops",
            quantity.TIME,
            "0.1",
            "in which a thing stops that nobody pushes",
            least="0.001",
            label=said("how soon a thing stops"),
        ),
    ),
    moves=True,
)


class MotionNeedsForce(Impossible):
    """What nobody pushes stands still at once."""

    def resistance(self, mass: float) -> float:
        """m/τ."""
        return mass / self.numbers["stops"]


act = MotionNeedsForce
