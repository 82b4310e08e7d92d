"""push-only-uncorrected, described: as push-only, with the damping of the printed formula."""

from __future__ import annotations

from sim.laws.push_only import NO_ZERO
from sim.scene.fields import RESTITUTION, STIFFNESS
from sim.scene.laws import LawKind

LAW = LawKind(
    name="push-only-uncorrected",
    says="as push-only, but with the damping of the printed formula: it delivers more",
    place=40,
    stiffness=STIFFNESS,
    restitution=RESTITUTION,
    no_zero=NO_ZERO,
)
