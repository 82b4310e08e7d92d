"""push, described: a constant force on one cart for a time."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from sim.scene import quantity
from sim.scene.effects import Effect, EffectKind
from sim.scene.fields import Field
from sim.scene.problem import Problem


def _ends_after_it_begins(listed: Sequence[Effect]) -> Iterator[Problem]:
    for effect in listed:
        begins, ends = effect.numbers["from"], effect.numbers.get("until", math.inf)
        if ends <= begins:
            yield Problem(
                ("effects", effect.index, effect.kind, "until"),
                "out-of-range",
                f"the push ends at {ends:g} s, but begins at {begins:g} s",
                f"for example until: {begins + 1.0:g} s",
            )


KIND = EffectKind(
    name="push",
    says="a force on one cart for a time",
    place=40,
    fields=(
        Field("force", quantity.FORCE, None, "+ pushes to the right", label="force of the push"),
        Field(
            "from",
            quantity.TIME,
            "0",
            "the force begins",
            least="0",
            label="begin of the push",
        ),
        Field(
            "until",
            quantity.TIME,
            None,
            "the force ends; left out: at the end of the run",
            least="0",
            optional=True,
            label="end of the push",
        ),
    ),
    needs="cart",
    by="hand",
    gives=True,
    called="pushes from outside",
    switch="push",
    rule=_ends_after_it_begins,
)
