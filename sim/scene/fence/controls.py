"""The sliders that a lesson offers for a scene."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sim.scene.effects import Effect, kinds
from sim.scene.fence.effect_controls import effect_number, is_switch
from sim.scene.fields import CART, GRAVITY, RESTITUTION, STIFFNESS, TRACK_LENGTH, UNTIL, Field
from sim.scene.laws import law_kind
from sim.scene.model import Scene
from sim.scene.problem import Path, Problem
from sim.scene.quantity import QuantityError, read_quantity, unit_of
from sim.scene.said import said
from sim.scene.tables import mapping, unknown_keys


@dataclass(frozen=True, slots=True, kw_only=True)
class Control:
    """A slider with a number box. All numbers SI; `value` is the scene's own.

    `unit` is the one in which the author wrote the limits, and `per` its size in SI: a slider from
    0 to 0.5 mm/s counts in mm/s.
    """

    set: str
    low: float
    high: float
    step: float
    unit: str
    per: float
    label: str
    value: float

    def shown(self, number: float) -> float:
        """An SI number in the control's unit, without the rounding of the conversion."""
        return float(f"{number / self.per:.12g}")


@dataclass(frozen=True, slots=True, kw_only=True)
class Kind:
    """How sentences speak of what is read: an axis of a map is a control without steps.

    `limits`: what stands behind `set`. `order`: what from, to and step have to be, and what helps.
    """

    name: str
    limits: str
    order: str
    order_hint: Callable[[str], str]


CONTROL = Kind(
    name="control",
    limits="from: …, to: …, step: …",
    order="a control goes from a smaller to a larger number in positive steps",
    order_hint=lambda target: f"{{set: {target}, from: 1, to: 5, step: 0.5}}",
)


def read_controls(
    value: object, scene: Scene, problems: list[Problem], effects: Sequence[Effect] | None = None
) -> tuple[Control, ...]:
    """The sliders in the order listed, each with the scene's own value as its start.

    `effects`: all that the scene lists, where those that are switched off count too.
    """
    hint = "controls:\n  - {set: A.mass, from: 0.5 kg, to: 5 kg, step: 0.1 kg}"
    if not isinstance(value, (list, tuple)):
        problems.append(Problem(("controls",), "not-a-list", "controls is a list", hint))
        return ()
    controls = []
    for k, entry in enumerate(value):
        path = ("controls", k)
        if effects is not None and is_switch(entry):
            continue  # `read_switches` reads it
        table = mapping(entry, path, problems, hint)
        if table is None:
            continue
        unknown_keys(table, ("set", "from", "to", "step"), path, problems)
        control = read_control(table, path, scene, effects or scene.effects, problems, CONTROL)
        if control is not None:
            controls.append(control)
    return tuple(controls)


def read_control(
    table: Mapping[str, Any],
    path: Path,
    scene: Scene,
    effects: Sequence[Effect],
    problems: list[Problem],
    kind: Kind,
) -> Control | None:
    """One control, or what is read as one."""
    target = str(table.get("set"))
    found = number_of(target, scene, effects)
    if found is None:
        problems.append(_unknown(target, (*path, "set"), scene, effects, kind))
        return None
    field, label, value = found
    limits = _limits(table, path, target, field, kind)
    if isinstance(limits, Problem):
        problems.append(limits)
        return None
    low, high, step = limits
    if not low <= value <= high:
        told = f"the scene's own {target} is {value:g}, outside of this {kind.name}"
        hint = "widen from and to, or change the scene"
        problems.append(Problem(path, "out-of-range", told, hint))
        return None
    unit, per = _shown_unit(field, table)
    return Control(
        set=target, low=low, high=high, step=step, unit=unit, per=per, label=label, value=value
    )


def _unknown(
    target: str, path: Path, scene: Scene, effects: Sequence[Effect], kind: Kind
) -> Problem:
    """No control can set this."""
    names = [cart.name for cart in scene.carts]
    owner = target.partition(".")[0]
    known = (*names, "contact", "track", "until", "gravity", "effects", *kinds())
    cannot = f"no {kind.name} can set “{target}”"
    told = cannot if owner in known else f"there is no cart {owner}"
    return Problem(path, "unknown-path", told, _hint(owner, names, effects))


def _limits(
    table: Mapping[str, Any], path: Path, target: str, field: Field, kind: Kind
) -> tuple[float, float, float] | Problem:
    """From, to and step in SI."""
    numbers = {}
    for key in ("from", "to", "step"):
        if key not in table:
            hint = f"{{set: {target}, {kind.limits}}}"
            return Problem(path, "missing", f"{key} is missing", hint)
        try:
            numbers[key] = read_quantity(table[key], field.dimension)
        except QuantityError as error:
            return Problem((*path, key), error.code, error.message, error.hint)
    if bare := _bare(table, path, field):
        return bare
    if numbers["from"] >= numbers["to"] or numbers["step"] <= 0:
        return Problem(path, "out-of-range", kind.order, kind.order_hint(target))
    for key in ("from", "to"):
        bound = field.read(table[key], (*path, key))
        if isinstance(bound, Problem):
            return bound
    return float(numbers["from"]), float(numbers["to"]), float(numbers["step"])


def _bare(table: Mapping[str, Any], path: Path, field: Field) -> Problem | None:
    """A limit without a unit beside one in cm: 90 would be 90 m, unseen. 0 is the same in both.

    Beside 10 % a plain 1 is the whole, and is meant.
    """
    if not field.dimension.si:
        return None
    units = {key: unit_of(str(table[key])) for key in ("from", "to", "step")}
    unit = next(
        (unit for unit in units.values() if field.dimension.factor(unit) not in (None, 1)), ""
    )
    for key in units if unit else ():
        if not units[key] and read_quantity(table[key], field.dimension) != 0:
            told = f"{key} has no unit, and other numbers here are in {unit}"
            return Problem((*path, key), "wrong-unit", told, f"{key}: {table[key]} {unit}")
    return None


def _hint(owner: str, names: Sequence[str], effects: Sequence[Effect]) -> str:
    """What a control could set instead."""
    own = [
        f"effects.{effect.index}.{key}"
        for effect in effects
        if owner in ("effects", effect.kind)
        for key in effect.numbers
    ]
    of_carts = f"{names[0]}.mass, {names[-1]}.velocity"
    return ", ".join(own or (f"for example {of_carts}, contact.restitution, contact.stiffness",))


def number_of(
    target: str, scene: Scene, effects: Sequence[Effect]
) -> tuple[Field, str, float] | None:
    """The field behind a control's target, its label, and the scene's own value."""
    return _target(target, scene) or effect_number(target, effects)


def _target(target: str, scene: Scene) -> tuple[Field, str, float] | None:
    name, _, key = target.rpartition(".")
    for cart in scene.carts:
        if cart.name == name:
            for field in CART:
                if field.key == key:
                    quantity = said(key.replace("_", " "))
                    label = said("{quantity} of {cart}", quantity=quantity, cart=name)
                    return field, label, getattr(cart, key)
    contact = scene.common
    if target == "contact.restitution" and contact is not None and contact.restitution is not None:
        return RESTITUTION, said("bounciness e"), contact.restitution
    if target == "contact.stiffness" and contact is not None and contact.stiffness is not None:
        kind = law_kind(contact.law)
        field = (kind and kind.stiffness) or STIFFNESS
        return field, said("stiffness k"), contact.stiffness
    if target == "track.length" and scene.track.length is not None:
        return TRACK_LENGTH, said("length of the track"), scene.track.length
    if target == "until":
        return UNTIL, said("end of the run"), scene.until
    if target == "gravity":
        return GRAVITY, said("gravity"), scene.gravity
    return None


def _shown_unit(field: Field, table: Mapping[str, Any]) -> tuple[str, float]:
    """The unit that all limits with a unit share, and its size in SI; else the SI unit."""
    texts = [str(table[key]) for key in ("from", "to", "step")]
    units = {unit for text in texts if (unit := unit_of(text)) and field.dimension.factor(unit)}
    if len(units) != 1:
        return field.dimension.si, 1.0
    unit = units.pop()
    return unit, float(field.dimension.factor(unit) or 1)
