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
"""rad. A track that hangs over carries nothing."""


def _one_under_each(listed: Sequence[Effect]) -> Iterator[Problem]:
    """A cart stands on one plane: its weight along two of them would be counted twice."""
    under: set[str] = set()
    for effect in listed:
        both = [cart for cart in effect.carts if cart in under]
        if both:
            yield Problem(
                ("effects", effect.index, "incline"),
                "twice",
                said("there is already an incline under {cart}", cart=both[0]),
                said("one incline is enough: angle: 2 deg"),
            )
        under.update(effect.carts)


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
    everyday=("slope", "hill", "ramp", "tilt", "inclined", "downhill", "uphill"),
    called=said("a slope"),
    switch=said("slope"),
    agent=said("the Earth"),
    rule=_one_under_each,
)


def angle_under(cart: str, scene: Scene) -> float:
    """rad. Angle of the track under a cart: what presses it on the track is m g cos θ."""
    inclines = (e for e in scene.effects if e.kind == KIND.name and cart in e.carts)
    return next((one.numbers["angle"] for one in inclines), 0.0)
