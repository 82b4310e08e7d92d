"""Changes to plain scene values by path: what a slider, a link or `el.set` asks for.

A path is dotted: ``A.mass`` (a cart's key), ``contact.restitution``, ``contact.pairs.A-B.law``,
``track.length``, ``until``, ``effects.0.coefficient`` (a number of the first effect),
``friction.coefficient`` (where there is one friction), ``friction.active`` (whether it acts).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sim.scene.effects import kinds
from sim.scene.fields import CART
from sim.scene.problem import Path, Problem, SceneError, did_you_mean
from sim.scene.track import KEYS as TRACK_KEYS

SCALARS = ("until", "gravity")
TABLES = ("contact", "track")


def apply_changes(plain: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """A copy of `plain` with every change made; raises SceneError for a path that leads nowhere.

    Values are not checked here: `read_scene` does that for the result.
    """
    if not isinstance(plain, Mapping) or not isinstance(changes, Mapping):
        hint = "for example carts: {A: {mass: 1 kg, position: 0.4 m}}"
        raise SceneError([Problem((), "not-a-table", "a scene is a table of keys", hint)])
    changed = dict(plain)
    problems = []
    for target, value in changes.items():
        path = resolve(plain, str(target))
        if path is None:
            example = "for example A.mass or contact.restitution"
            hint = did_you_mean(target, targets(plain), example)
            problems.append(
                Problem(
                    ("set", str(target)),
                    "unknown-path",
                    f"nothing here is called “{str(target)[:60]}”",
                    hint,
                )
            )
        else:
            changed = _with(changed, path, value)
    if problems:
        raise SceneError(problems)
    return changed


def resolve(plain: Mapping[str, Any], target: str) -> Path | None:
    """The key path in a scene that a dotted target names, or None."""
    head, _, rest = target.partition(".")
    carts = plain.get("carts")
    if isinstance(carts, Mapping) and head in carts and rest in {f.key for f in CART}:
        return ("carts", head, rest)
    if target in SCALARS:
        return (target,)
    if head == "contact" and rest in ("law", "restitution", "stiffness"):
        return ("contact", rest)
    if head == "contact" and rest.startswith("pairs."):
        pair, _, key = rest[len("pairs.") :].rpartition(".")
        if pair and key in ("law", "restitution", "stiffness"):
            return ("contact", "pairs", pair, key)
    if head == "track" and rest in TRACK_KEYS:
        return ("track", rest)
    if head == "effects":
        return _effect_path(plain.get("effects"), rest)
    if head in kinds():
        return _effect_by_kind(plain.get("effects"), head, rest)
    return None


def _effect_path(effects: object, rest: str) -> Path | None:
    index, _, key = rest.partition(".")
    if not isinstance(effects, (list, tuple)) or not index.isdecimal() or not key:
        return None
    if int(index) >= len(effects) or not isinstance(effects[int(index)], Mapping):
        return None
    kind = str(next(iter(effects[int(index)]), ""))
    key = key.removeprefix(f"{kind}.")
    return ("effects", int(index), kind, key) if key in _effect_keys(kind) else None


def _effect_by_kind(effects: object, kind: str, key: str) -> Path | None:
    """The path for a kind that is listed once."""
    if not isinstance(effects, (list, tuple)) or key not in _effect_keys(kind):
        return None
    listed = [k for k, entry in enumerate(effects) if isinstance(entry, Mapping) and kind in entry]
    return ("effects", listed[0], kind, key) if len(listed) == 1 else None


def _effect_keys(kind: str) -> tuple[str, ...]:
    """What can be changed of an effect: its numbers, and whether it acts."""
    row = kinds().get(kind)
    return () if row is None else (*(field.key for field in row.fields), "active")


def targets(plain: Mapping[str, Any]) -> list[str]:
    """Common targets of a scene, for hints."""
    carts = plain.get("carts")
    names = list(carts)[:12] if isinstance(carts, Mapping) else []
    own = [f"{name}.{field.key}" for name in names for field in CART]
    effects = plain.get("effects")
    listed = effects[:12] if isinstance(effects, (list, tuple)) else []
    own += [
        f"{kind}.{key}"
        for entry in listed
        if isinstance(entry, Mapping)
        for kind in entry
        for key in _effect_keys(str(kind))
    ]
    return [
        *own,
        "contact.restitution",
        "contact.stiffness",
        "contact.law",
        "track.length",
        *SCALARS,
    ]


def _with(node: Any, path: Path, value: Any) -> Any:
    """A copy of `node` with `value` at `path`; missing tables are made."""
    if not path:
        return value
    head, rest = path[0], path[1:]
    if isinstance(node, (list, tuple)):
        items = list(node)
        items[int(head)] = _with(items[int(head)], rest, value)
        return items
    table = dict(node) if isinstance(node, Mapping) else {}
    table[str(head)] = _with(table.get(str(head)), rest, value)
    return table
