"""What a student set in a scene, in words: `A.mass 2 kg, B.velocity 0.5 m/s`.

A number without a unit is in SI units. The stiffness of a contact has its unit from the law of its
scene, which an answer does not tell: it stays without.
"""

from __future__ import annotations

from collections.abc import Mapping

from sim.scene.effects import kinds
from sim.scene.fields import CART, GRAVITY, TRACK_LENGTH, UNTIL, Field

_OF_SCENE = {"until": UNTIL, "gravity": GRAVITY, "track.length": TRACK_LENGTH}


def told_settings(values: Mapping[str, object]) -> str:
    """All of them, by name."""
    return ", ".join(f"{name} {_told(name, value)}" for name, value in sorted(values.items()))


def _told(name: str, value: object) -> str:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return str(value)
    field = _field(name)
    return f"{value:g} {field.dimension.si if field else ''}".strip()


def _field(name: str) -> Field | None:
    """The number that a name means, as in `sim.scene.changes`."""
    if name in _OF_SCENE:
        return _OF_SCENE[name]
    head, _, key = name.partition(".")
    if head in ("contact", "effects", "track"):
        return None
    effect = kinds().get(head)
    fields = effect.fields if effect else CART
    return next((field for field in fields if field.key == key), None)
