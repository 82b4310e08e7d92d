"""paper, described: the spring and damper of the paper's equation (3)."""

from __future__ import annotations

from sim.scene.fields import RESTITUTION, STIFFNESS
from sim.scene.laws import LawKind

LAW = LawKind(
    name="paper",
    says="a spring beside a damper until the overlap is zero; it pulls at the end",
    place=20,
    stiffness=STIFFNESS,
    restitution=RESTITUTION,
)
