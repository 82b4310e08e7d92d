"""drag, described: air resistance."""

from __future__ import annotations

from sim.scene import quantity
from sim.scene.effects import EffectKind
from sim.scene.fields import Field
from sim.scene.said import said, template

KIND = EffectKind(
    name=template("drag"),
    says="air resistance against the motion",
    place=30,
    fields=(
        Field(
            "linear",
            quantity.LINEAR_DRAG,
            "0",
            "force per speed",
            least="0",
            label=said("drag, force per speed"),
        ),
        Field(
            "quadratic",
            quantity.QUADRATIC_DRAG,
            "0",
            "force per speed squared",
            least="0",
            label=said("drag, force per speed squared"),
        ),
    ),
    one_of=("linear", "quadratic"),
    everyday=("air", "wind", "resistance", "air-resistance", "water"),
    called=said("air resistance"),
    agent=said("the air"),
)
