"""incline, described: a tilted track."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sim.scene import quantity
from sim.scene.effects import Effect, EffectKind
from sim.scene.fields import Field
from sim.scene.model import Scene
from sim.scene.problem import Problem
from sim.scene.said import said, template

STEEPEST = 1.5
"""rad. All inclines under one cart together: a track that hangs over carries nothing."""


def _not_too_steep(listed: Sequence[Effect]) -> Iterator[Problem]:
    total: dict[str, float] = {}
    for effect in listed:
        for cart in effect.carts:
            total[cart] = total.get(cart, 0.0) + effect.numbers["angle"]
        if any(abs(total[cart]) > STEEPEST for cart in effect.carts):
            yield Problem(
                ("effects", effect.index, "incline", "angle"),
                "out-of-range",
                said(
                    "all inclines under one cart together are more than {steepest} rad",
                    steepest=str(STEEPEST),
                ),
                said("one incline is enough: angle: 2 deg"),
            )
            return


KIND = EffectKind(
    name=template("incline"),
    says="a tilted track: m g sin θ, + drives carts to the right",
    place=20,
    fields=(
        Field(
            "angle",
            quantity.ANGLE,
            None,
            "angle of the track",
            least=f"-{STEEPEST}",
            most=f"{STEEPEST}",
            label=said("angle of the track"),
        ),
    ),
    stores="place",
    called=said("a slope"),
    switch=said("slope"),
    agent=said("the Earth"),
    rule=_not_too_steep,
)


def angle_under(cart: str, scene: Scene) -> float:
    """rad. Angle of the track under a cart: what presses it on the track is m g cos θ."""
    return sum(
        effect.numbers["angle"]
        for effect in scene.effects
        if effect.kind == KIND.name and cart in effect.carts
    )
