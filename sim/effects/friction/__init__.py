"""friction, described: dry (Coulomb) friction between a cart and the track."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sim.scene import quantity
from sim.scene.effects import Effect, EffectKind
from sim.scene.fields import Field
from sim.scene.problem import Problem
from sim.scene.said import said, template


def _static_is_the_greater(listed: Sequence[Effect]) -> Iterator[Problem]:
    for effect in listed:
        moving = effect.numbers["coefficient"]
        if effect.numbers.get("static", moving) < moving:
            yield Problem(
                ("effects", effect.index, effect.kind, "static"),
                "out-of-range",
                said(
                    "static friction is never less than that of a moving cart, {least}",
                    least=f"{moving:g}",
                ),
                said("static: {least} or more, or remove it", least=f"{moving:g}"),
            )


KIND = EffectKind(
    name=template("friction"),
    says="Coulomb friction: μ m g against the motion, with stopping and staying",
    place=10,
    fields=(
        Field(
            "coefficient",
            quantity.RATIO.such_as("0.02"),
            None,
            "coefficient of friction",
            least="0",
            label=said("friction coefficient μ"),
        ),
        Field(
            "static",
            quantity.RATIO.such_as("0.03"),
            None,
            "coefficient at rest; left out: the same",
            least="0",
            optional=True,
            label=said("friction coefficient at rest"),
        ),
    ),
    everyday=("brake", "brakes", "braking", "rubbing", "rolling", "grip"),
    called=said("friction"),
    agent=said("the track"),
    rule=_static_is_the_greater,
)
