"""magnets, described: repelling ends of two neighbours."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from sim.scene import quantity
from sim.scene.effects import Effect, EffectKind
from sim.scene.fields import Field
from sim.scene.problem import Problem
from sim.scene.said import said, template


def _apart(effect: Effect, gap: Fraction | None) -> Iterator[Problem]:
    """At no distance their force has no limit."""
    if gap is not None and gap <= 0 and effect.between is not None:
        a, b = effect.between
        yield Problem(
            ("effects", effect.index, "magnets", "between"),
            "overlap",
            said("magnets need room between them, but {a} and {b} touch at the start", a=a, b=b),
            said("move them apart"),
        )


KIND = EffectKind(
    name=template("magnets"),
    says="repelling ends: F = C / r^n, r edge to edge",
    place=60,
    fields=(
        Field(
            "strength",
            quantity.STRENGTH,
            None,
            "C, in N m^n",
            least="0",
            above=True,
            label=said("strength of the magnets"),
        ),
        Field(
            "power",
            quantity.STRENGTH.such_as("3"),
            "3",
            "n",
            least="1",
            most="12",
            label=said("power of the distance"),
        ),
    ),
    needs="between",
    walls=True,
    stores="gap",
    apart=True,
    everyday=("magnet", "magnetic", "repulsion"),
    called=said("magnets"),
    room_rule=_apart,
)
