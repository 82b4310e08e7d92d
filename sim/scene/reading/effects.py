"""The list of effects: each entry is one kind with its numbers and the carts that it names."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from sim.scene.effects import Effect, EffectKind, kinds
from sim.scene.model import Scene, Track
from sim.scene.problem import Path, Problem, nearest
from sim.scene.said import said
from sim.scene.tables import mapping, number, unknown_keys

MOST_EFFECTS = 2000
"""Every event looks at all of them: more would make a run too slow."""


def read_effects(
    value: object, names: list[str], track: Track, problems: list[Problem]
) -> tuple[Effect, ...]:
    """The effects that act, in the order listed. Carts and walls they name must exist."""
    listed = _listed(value, names, track, problems)
    problems.extend(broken_rules(listed))
    return tuple(effect for effect in listed if effect.active)


def read_estimates(
    value: object, names: list[str], track: Track, problems: list[Problem]
) -> tuple[Effect, ...]:
    """Sizes of effects that do not act, for the estimate of what they would change."""
    listed = _listed(value, names, track, problems, key="estimate")
    for one in broken_rules(listed):
        problems.append(replace(one, path=("estimate", *one.path[1:])))
    return listed


def all_effects(plain: Mapping[str, Any], scene: Scene) -> tuple[Effect, ...]:
    """Of a scene that was read from `plain`: those that are switched off too."""
    names = [cart.name for cart in scene.carts]
    return _listed(plain.get("effects", []), names, scene.track, [])


def _listed(
    value: object,
    names: list[str],
    track: Track,
    problems: list[Problem],
    *,
    key: str = "effects",
) -> tuple[Effect, ...]:
    """Every effect that makes sense, those that are switched off too. `key`: of the list."""
    path: Path = (key,)
    if not isinstance(value, (list, tuple)):
        hint = f"{key}:\n  - friction: {{coefficient: 0.02}}"
        problems.append(Problem(path, "not-a-list", f"{key} is a list", hint))
        return ()
    if len(value) > MOST_EFFECTS:
        message = f"{len(value)} effects; at most {MOST_EFFECTS} can act"
        problems.append(Problem(path, "wrong-count", message, "remove some of them"))
        return ()
    effects = []
    for k, entry in enumerate(value):
        effect = _entry(entry, (*path, k), k, names, track, problems)
        if effect is not None:
            effects.append(effect)
    return tuple(effects)


def _entry(
    entry: object, path: Path, index: int, names: list[str], track: Track, problems: list[Problem]
) -> Effect | None:
    if not isinstance(entry, Mapping) or len(entry) != 1:
        problems.append(
            Problem(
                path,
                "not-an-effect",
                "one entry is one effect with its numbers",
                "- friction: {coefficient: 0.02}",
            )
        )
        return None
    name, body = next(iter(entry.items()))
    kind = kinds().get(name)
    if kind is None:
        hint = _effect_meant(str(name), names)
        problems.append(Problem((*path, name), "unknown-effect", f"unknown effect “{name}”", hint))
        return None
    path = (*path, kind.name)
    table = mapping(body, path, problems, f"{name}: {{{kind.fields[0].key}: …}}")
    if table is None:
        return None
    before = len(problems)
    keys = tuple(f.key for f in kind.fields) + ((kind.needs,) if kind.needs else ("carts",))
    keys = (*keys, "by", "active") if kind.by else (*keys, "active")
    unknown_keys(table, keys, path, problems)
    numbers = _numbers(kind, table, path, problems)
    acting = _bodies(kind, table, path, names, track)
    if isinstance(acting, Problem):
        problems.append(acting)
    carts, between = ((), None) if isinstance(acting, Problem) else acting
    by = table.get("by", kind.by)
    if by is not None and not isinstance(by, str):
        problems.append(Problem((*path, "by"), "not-text", "by names who pushes", "by: hand"))
    active = table.get("active", True)
    if not isinstance(active, bool):
        problems.append(
            Problem(
                (*path, "active"), "not-a-choice", "active must be true or false", "active: false"
            )
        )
    if len(problems) > before or not names:
        return None
    return Effect(
        kind=kind.name,
        numbers=numbers,
        carts=carts,
        between=between,
        by=by,
        index=index,
        active=active,
    )


def _effect_meant(name: str, names: list[str]) -> str:
    """The kind that was meant by an everyday word or by a word spelt nearly so; else all of them.
    An example line is there for each, with carts of this scene."""
    by_word = {word: kind.name for kind in kinds().values() for word in (kind.name, *kind.everyday)}
    close = by_word.get(name.casefold()) or nearest(name, kinds())
    if close is None:
        first = next(iter(kinds().values()))
        return f"effects: {', '.join(kinds())}; for example {first.example}"
    own = dict(zip("AB", names, strict=False))
    example = re.sub(r"\b[AB]\b", lambda one: own.get(one[0], one[0]), kinds()[close].example)
    return said("did you mean {name}? For example {example}", name=f"“{close}”", example=example)


def _numbers(
    kind: EffectKind, table: Mapping[str, Any], path: Path, problems: list[Problem]
) -> dict[str, float]:
    numbers = {}
    for field in kind.fields:
        value = number(field, table, path, problems)
        if value is not None:
            numbers[field.key] = float(value)
    if kind.one_of and not any(key in table for key in kind.one_of):
        problems.append(
            Problem(
                path,
                "missing",
                f"{kind.name} needs {' or '.join(kind.one_of)}",
                f"for example {kind.one_of[0]}: {kind.fields[0].dimension.example}",
            )
        )
    return numbers


Acting = tuple[tuple[str, ...], tuple[str, str] | None]
"""Carts acted on, and the pair for an effect between two bodies."""


def _bodies(
    kind: EffectKind, table: Mapping[str, Any], path: Path, names: list[str], track: Track
) -> Acting | Problem:
    if not names:  # no cart can be used, and that is told where the carts stand
        return (), None
    if kind.needs == "between":
        return _between(kind, table.get("between"), (*path, "between"), names, track)
    if kind.needs == "cart":
        cart = table.get("cart")
        if cart in names:
            return (str(cart),), None
        told = f"cart names one of {', '.join(names[:12])}"
        return Problem((*path, "cart"), "unknown-body", told, f"cart: {names[0]}")
    carts = table.get("carts", names)
    if not isinstance(carts, (list, tuple)) or not carts or any(c not in names for c in carts):
        told = f"carts is a list of {', '.join(names[:12])}"
        return Problem((*path, "carts"), "unknown-body", told, f"carts: [{names[0]}]")
    return tuple(name for name in names if name in carts), None


def _between(
    kind: EffectKind, between: object, path: Path, names: list[str], track: Track
) -> Acting | Problem:
    """Two neighbours; walls where the effect can act on them."""
    order = [
        *(["left"] if track.left == "wall" else []),
        *names,
        *(["right"] if track.right == "wall" else []),
    ]
    known = order if kind.walls else names
    if (
        not isinstance(between, (list, tuple))
        or len(between) != 2
        or between[0] == between[1]
        or any(body not in known for body in between)
    ):
        told = f"between names two of {', '.join(known[:12])}"
        return Problem(path, "unknown-body", told, "between: [A, B]")
    a, b = sorted(between, key=order.index)
    if order.index(b) - order.index(a) != 1:
        told = f"{a} and {b} are not neighbours"
        return Problem(path, "not-neighbours", told, "between: [A, B]")
    return tuple(n for n in (a, b) if n in names), (a, b)


def broken_rules(listed: Sequence[Effect]) -> Iterator[Problem]:
    """One problem for each effect that cannot be meant, those that are switched off too.

    What acts is looked at together. What is switched off may take the place of what acts, so that
    each of those is looked at by itself.
    """
    for kind in kinds().values():
        if kind.rule is not None:
            own = [effect for effect in listed if effect.kind == kind.name]
            yield from kind.rule([effect for effect in own if effect.active])
            for effect in own:
                if not effect.active:
                    yield from kind.rule([effect])


def check_room(
    effects: Sequence[Effect],
    gaps: Sequence[Fraction | None],
    names: list[str],
    problems: list[Problem],
) -> None:
    """What effects ask of the gaps [m] in which they act at the start."""
    row = ["left", *names, "right"]
    for effect in effects:
        rule = kinds()[effect.kind].room_rule
        if rule is not None and effect.between is not None:
            problems.extend(rule(effect, gaps[row.index(effect.between[0])]))
