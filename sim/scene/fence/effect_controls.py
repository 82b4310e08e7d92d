"""What a lesson lets a reader change about effects: their numbers, and whether they act.

    controls:
      - {set: friction.coefficient, from: 0, to: 0.1, step: 0.01}
      - {switch: friction}

An effect is named by its kind where the scene lists it once, else by its place: ``effects.1``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sim.scene.effects import Effect, kinds
from sim.scene.fields import Field
from sim.scene.problem import Path, Problem, did_you_mean
from sim.scene.said import said


@dataclass(frozen=True, slots=True, kw_only=True)
class Switch:
    """A box to tick: whether an effect acts. `set` is the path that a change names."""

    set: str
    label: str
    value: bool  # as the scene says


def effect_of(target: str, effects: Sequence[Effect]) -> Effect | None:
    """The effect that ``friction`` or ``effects.1`` names; None where there is none, or several."""
    head, _, index = target.partition(".")
    if head == "effects":
        return next((effect for effect in effects if str(effect.index) == index), None)
    found = [effect for effect in effects if effect.kind == target]
    return found[0] if len(found) == 1 else None


def effect_number(target: str, effects: Sequence[Effect]) -> tuple[Field, str, float] | None:
    """The field behind a slider's target, its label, and the scene's own value."""
    owner, _, key = target.rpartition(".")
    effect = effect_of(owner, effects) or _with_kind(owner, effects)
    if effect is None or key not in effect.numbers:
        return None
    kind = kinds()[effect.kind]
    field = next(field for field in kind.fields if field.key == key)
    return field, _whose(kind.label_of(field), effect, effects), effect.numbers[key]


def is_switch(entry: object) -> bool:
    """Whether an entry of `controls` is a switch."""
    return isinstance(entry, Mapping) and "switch" in entry


def read_switches(
    value: object, effects: Sequence[Effect], problems: list[Problem]
) -> tuple[Switch, ...]:
    """The switches among the controls, in the order listed."""
    switches = []
    for k, entry in enumerate(value if isinstance(value, (list, tuple)) else ()):
        if not is_switch(entry):
            continue
        path: Path = ("controls", k)
        for key in entry:
            if key != "switch":
                problems.append(
                    Problem(
                        (*path, key),
                        "unknown-key",
                        f"a switch takes no “{key}”",
                        "{switch: friction}",
                    )
                )
        target = str(entry["switch"])
        effect = effect_of(target, effects)
        if effect is None:
            problems.append(_unknown((*path, "switch"), target, effects))
            continue
        label = _whose(kinds()[effect.kind].label, effect, effects)
        switches.append(Switch(set=f"{target}.active", label=label, value=effect.active))
    return tuple(switches)


def _unknown(path: Path, target: str, effects: Sequence[Effect]) -> Problem:
    same = [effect for effect in effects if effect.kind == target]
    if same:
        places = " or ".join(f"switch: effects.{effect.index}" for effect in same)
        return Problem(path, "unknown-path", f"the scene lists {target} {len(same)} times", places)
    if target in kinds():
        number = kinds()[target].fields[0]
        hint = (
            f"effects:\n  - {target}: {{{number.key}: {number.dimension.example}, active: false}}"
        )
        return Problem(path, "unknown-path", f"the scene does not list {target}", hint)
    listed = [effect.kind for effect in effects]
    hint = did_you_mean(target, listed, f"effects of this scene: {', '.join(listed)}")
    if not listed:
        hint = "a switch turns an effect of the scene on and off: list it under effects"
    return Problem(path, "unknown-path", f"no effect is called “{target[:40]}”", hint)


def _with_kind(owner: str, effects: Sequence[Effect]) -> Effect | None:
    """The effect that ``effects.1.friction`` names."""
    place, _, kind = owner.rpartition(".")
    effect = effect_of(place, effects) if place.startswith("effects.") else None
    return effect if effect is not None and effect.kind == kind else None


def _whose(label: str, effect: Effect, effects: Sequence[Effect]) -> str:
    """The label, with who pushes whom, or with the place among several of one kind."""
    if effect.by is not None:
        return said(
            "{label} on {cart} by {agent}", label=label, cart=effect.carts[0], agent=effect.by
        )
    same = [other.index for other in effects if other.kind == effect.kind]
    if len(same) < 2:
        return label
    return said("{label} ({number})", label=label, number=str(same.index(effect.index) + 1))
