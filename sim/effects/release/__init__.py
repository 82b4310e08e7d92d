"""release, described: an exploder between two touching carts."""

from __future__ import annotations

from sim.scene import quantity
from sim.scene.effects import EffectKind
from sim.scene.fields import Field
from sim.scene.said import said, template

KIND = EffectKind(
    name=template("release"),
    says="an exploder between two touching carts: exactly this energy, at one time",
    place=70,
    fields=(
        Field(
            "energy",
            quantity.ENERGY,
            None,
            "energy released",
            least="0",
            above=True,
            label=said("energy of the exploder"),
        ),
        Field(
            "at",
            quantity.TIME,
            "0",
            "time of the release",
            least="0",
            label=said("time of the release"),
        ),
    ),
    needs="between",
    overlap=True,
    gives=True,
    called=said("a release between the carts"),
    switch=said("exploder"),
)
