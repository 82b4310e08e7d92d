"""bumper, described: the default of student lessons."""

from __future__ import annotations

from sim.scene.fields import RESTITUTION, STIFFNESS
from sim.scene.laws import LawKind

LAW = LawKind(
    name="bumper",
    says="presses in along one line and springs back along a steeper one; never pulls",
    place=10,
    stiffness=STIFFNESS,
    restitution=RESTITUTION,
)
