"""push-only, described: a spring beside a damper that may only push."""

from __future__ import annotations

from sim.scene.fields import RESTITUTION, STIFFNESS
from sim.scene.laws import LawKind

NO_ZERO = "the force may only push, so the carts always fly apart"

LAW = LawKind(
    name="push-only",
    says="a spring beside a damper until its force is zero",
    place=30,
    stiffness=STIFFNESS,
    restitution=RESTITUTION,
    no_zero=NO_ZERO,
)
