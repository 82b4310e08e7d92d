"""velcro, described: what touches stays together."""

from __future__ import annotations

from sim.scene.laws import LawKind

LAW = LawKind(
    name="velcro",
    says="what touches stays together",
    place=60,
    takes_no={"stiffness": "has no duration", "restitution": "holds the carts together"},
)
