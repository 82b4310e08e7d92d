"""hertz, described: two elastic spheres, for the hard cases."""

from __future__ import annotations

from sim.scene.fields import HERTZ_STIFFNESS, RESTITUTION
from sim.scene.laws import LawKind

LAW = LawKind(
    name="hertz",
    says="two elastic spheres: the force grows with the overlap to the power 3/2",
    place=70,
    stiffness=HERTZ_STIFFNESS,
    restitution=RESTITUTION,
    power=1.5,
)
