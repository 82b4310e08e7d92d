"""What may act on carts besides contacts. Nothing acts that a scene does not list.

Each kind is one row of the table: its parameters with units, and which carts it names. The
numerics of each live in `sim.dynamics`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from sim.scene import quantity
from sim.scene.fields import Field


@dataclass(frozen=True, slots=True)
class EffectKind:
    """A kind of effect: name, what it does, its numbers, and the other keys it takes.

    `needs` are keys that must be there beside the numbers: ``cart`` or ``between``. `one_of`:
    at least one of these numbers must be given.
    """

    name: str
    says: str
    fields: tuple[Field, ...]
    needs: Literal["", "cart", "between"] = ""
    walls: bool = False  # `between` may name a wall
    one_of: tuple[str, ...] = ()
    by: str | None = None  # default agent of a force


@dataclass(frozen=True, slots=True, kw_only=True)
class Effect:
    """One listed effect. `numbers` are SI floats; `carts` the carts it acts on.

    `index` is its place in the list of the scene. One that is not `active` is described, so that a
    switch can turn it on, and is no part of a run.
    """

    kind: str
    numbers: Mapping[str, float]
    carts: tuple[str, ...]
    between: tuple[str, str] | None = None
    by: str | None = None
    index: int = 0
    active: bool = True


_FROM = Field("from", quantity.TIME, "0", "the force begins", least="0")
_UNTIL = Field(
    "until",
    quantity.TIME,
    None,
    "the force ends; left out: at the end of the run",
    least="0",
    optional=True,
)

KINDS = {
    kind.name: kind
    for kind in (
        EffectKind(
            "friction",
            "Coulomb friction: μ m g against the motion, with stopping and staying",
            (
                Field("coefficient", quantity.RATIO, None, "coefficient of friction", least="0"),
                Field(
                    "static",
                    quantity.RATIO,
                    None,
                    "coefficient at rest; left out: the same",
                    least="0",
                    optional=True,
                ),
            ),
        ),
        EffectKind(
            "incline",
            "a tilted track: m g sin θ, + drives carts to the right",
            (Field("angle", quantity.ANGLE, None, "angle of the track", least="-1.5", most="1.5"),),
        ),
        EffectKind(
            "drag",
            "air resistance against the motion",
            (
                Field("linear", quantity.LINEAR_DRAG, "0", "force per speed", least="0"),
                Field(
                    "quadratic", quantity.QUADRATIC_DRAG, "0", "force per speed squared", least="0"
                ),
            ),
            one_of=("linear", "quadratic"),
        ),
        EffectKind(
            "push",
            "a force on one cart for a time",
            (Field("force", quantity.FORCE, None, "+ pushes to the right"), _FROM, _UNTIL),
            needs="cart",
            by="hand",
        ),
        EffectKind(
            "spring",
            "a spring between two carts or to a wall, edge to edge",
            (
                Field("stiffness", quantity.STIFFNESS, None, "stiffness", least="0", above=True),
                Field("length", quantity.LENGTH, None, "natural length, edge to edge", least="0"),
                Field("damping", quantity.DAMPING, "0", "force per relative speed", least="0"),
            ),
            needs="between",
            walls=True,
        ),
        EffectKind(
            "magnets",
            "repelling ends: F = C / r^n, r edge to edge",
            (
                Field("strength", quantity.STRENGTH, None, "C, in N m^n", least="0", above=True),
                Field("power", quantity.STRENGTH, "3", "n", least="1", most="12"),
            ),
            needs="between",
            walls=True,
        ),
        EffectKind(
            "release",
            "an exploder between two touching carts: exactly this energy, at one time",
            (
                Field("energy", quantity.ENERGY, None, "energy released", least="0", above=True),
                Field("at", quantity.TIME, "0", "time of the release", least="0"),
            ),
            needs="between",
        ),
    )
}
