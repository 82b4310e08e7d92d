"""spring, described: a spring between two neighbours, edge to edge."""

from __future__ import annotations

from sim.scene import quantity
from sim.scene.effects import EffectKind
from sim.scene.fields import Field
from sim.scene.said import said, template

KIND = EffectKind(
    name=template("spring"),
    says="a spring between two carts or to a wall, edge to edge",
    place=50,
    fields=(
        Field(
            "stiffness",
            quantity.STIFFNESS,
            None,
            "stiffness",
            least="0",
            above=True,
            label=said("stiffness of the spring"),
        ),
        Field(
            "length",
            quantity.LENGTH,
            None,
            "natural length, edge to edge",
            least="0",
            label=said("natural length of the spring"),
        ),
        Field(
            "damping",
            quantity.DAMPING,
            "0",
            "force per relative speed",
            least="0",
            label=said("damping of the spring"),
        ),
    ),
    needs="between",
    walls=True,
    stores="gap",
    everyday=("elastic", "rubber", "bungee"),
    called=said("springs between the carts"),
    switch=said("spring"),
)
