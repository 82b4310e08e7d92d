"""instant, described: an impulse without duration."""

from __future__ import annotations

from sim.scene.fields import RESTITUTION
from sim.scene.laws import LawKind

LAW = LawKind(
    name="instant",
    says="an impulse without duration",
    place=50,
    restitution=RESTITUTION,
    takes_no={"stiffness": "has no duration"},
)
