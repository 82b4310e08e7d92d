"""push, described: a constant force on one cart for a time."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from sim.scene import quantity
from sim.scene.effects import Effect, EffectKind
from sim.scene.fields import Field
from sim.scene.problem import Problem
from sim.scene.said import said, template


def _ends_after_it_begins(listed: Sequence[Effect]) -> Iterator[Problem]:
    for effect in listed:
        begins, ends = effect.numbers["from"], effect.numbers.get("until", math.inf)
        if ends <= begins:
            yield Problem(
                ("effects", effect.index, effect.kind, "until"),
                "out-of-range",
                said(
                    "the push ends at {end}, but begins at {begin}",
                    end=f"{ends:g} s",
                    begin=f"{begins:g} s",
                ),
                said("for example {example}", example=f"until: {begins + 1.0:g} s"),
            )


KIND = EffectKind(
    name=template("push"),
    says="a force on one cart for a time",
    place=40,
    fields=(
        Field(
            "force",
            quantity.FORCE.such_as("0.3 N"),
            None,
            "+ pushes to the right",
            label=said("force of the push"),
        ),
        Field(
            "from",
            quantity.TIME.such_as("1 s"),
            "0",
            "the force begins",
            least="0",
            label=said("begin of the push"),
        ),
        Field(
            "until",
            quantity.TIME.such_as("2 s"),
            None,
            "the force ends; left out: at the end of the run",
            least="0",
            optional=True,
            label=said("end of the push"),
        ),
    ),
    needs="cart",
    by=said("hand"),
    gives=True,
    everyday=("engine", "motor", "force", "thrust", "pull", "hand", "kick", "hit"),
    called=said("pushes from outside"),
    switch=said("push"),
    rule=_ends_after_it_begins,
)
