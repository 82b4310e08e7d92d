"""Which worlds a lesson may name, and how its key `worlds` is read.

    worlds: [bigger-pushes-more, {reaction-comes-later: {delay: 0.2 s}}]

A world is named like the belief that would be true in it (`sim.lesson.beliefs`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from typing import Any, ClassVar, Literal

from sim.scene.fields import Field
from sim.scene.model import Scene
from sim.scene.problem import Path, Problem, did_you_mean
from sim.scene.said import said
from sim.scene.tables import mapping, number, unknown_keys

FOLDER = "sim.worlds.kinds"


@dataclass(frozen=True, slots=True, kw_only=True)
class WorldKind:
    """A kind of world. `belief` is the tag of what somebody believes who expects it.

    `says` ends the sentence “a world in which …”. `needs`: what a scene must have for anything to
    be different there: two carts that push each other for a time, or a wall. `moves`: its law names
    a velocity, so two observers who pass each other do not agree on it. `nothing`: what a reader
    is told where a scene comes out as it would in ours.
    """

    impossible: ClassVar[bool] = True
    name: str
    belief: str
    says: str
    nothing: str
    place: int
    fields: tuple[Field, ...] = ()
    needs: Literal["", "pair", "wall"] = ""
    moves: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class World:
    """One world that a scene names, with its numbers in SI."""

    kind: WorldKind
    numbers: Mapping[str, float]


@cache
def kinds() -> Mapping[str, WorldKind]:
    """Every kind by name, in the order of lists."""
    folder = import_module(FOLDER)
    found = [import_module(f"{FOLDER}.{one.name}").KIND for one in iter_modules(folder.__path__)]
    return {kind.name: kind for kind in sorted(found, key=lambda kind: kind.place)}


def read_worlds(listed: object, scene: Scene, problems: list[Problem]) -> tuple[World, ...]:
    """The worlds of a scene; what cannot be meant is a problem."""
    path: Path = ("worlds",)
    if scene.written:  # a world changes what a law of ours gives, and cannot follow another
        message = said("worlds and a law of your own cannot be run together")
        hint = said("remove worlds, or the law {name}", name=", ".join(scene.written))
        problems.append(Problem(path, "own-law", message, hint))
        return ()
    entries = listed if isinstance(listed, (list, tuple)) else [listed]
    found: list[World] = []
    for index, entry in enumerate(entries):
        world = _entry(entry, (*path, index), problems)
        if world is None:
            continue
        problem = _nothing_to_see(world.kind, scene, (*path, index))
        if problem is not None:
            problems.append(problem)
        elif any(one.kind is world.kind for one in found):
            message = said("{name} is there twice", name=world.kind.name)
            hint = said("name each world once")
            problems.append(Problem((*path, index), "twice", message, hint))
        else:
            found.append(world)
    return tuple(found)


def _entry(entry: object, path: Path, problems: list[Problem]) -> World | None:
    body: Any = {}
    name = entry
    if isinstance(entry, Mapping) and len(entry) == 1:
        name, body = next(iter(entry.items()))
    kind = kinds().get(name) if isinstance(name, str) else None
    if kind is None:
        hint = did_you_mean(name, kinds(), f"worlds: {', '.join(kinds())}")
        message = said("unknown world “{name}”", name=str(name)[:40])
        problems.append(Problem(path, "unknown-world", message, hint))
        return None
    path = (*path, kind.name)
    table = mapping({} if body is None else body, path, problems, f"{kind.name}: {{}}")
    if table is None:
        return None
    before = len(problems)
    unknown_keys(table, tuple(field.key for field in kind.fields), path, problems)
    values = {field.key: number(field, table, path, problems) for field in kind.fields}
    if len(problems) > before:
        return None
    numbers = {key: float(value) for key, value in values.items() if value is not None}
    return World(kind=kind, numbers=numbers)


def _nothing_to_see(kind: WorldKind, scene: Scene, path: Path) -> Problem | None:
    """A world in which this scene would run as it does in ours."""
    if kind.needs == "wall" and "wall" not in (scene.track.left, scene.track.right):
        hint = "track: {right: wall, length: 2 m}"
        message = said("{name} is about a wall, and there is none", name=kind.name)
        return Problem(path, "no-wall", message, hint)
    names = {cart.name for cart in scene.carts}
    held = [one.kind for one in scene.effects if one.between and not names.issuperset(one.between)]
    if kind.needs == "wall" and held:  # the world takes the wall away
        message = said(
            "{name} leaves no wall that {effect} could hold to", name=kind.name, effect=held[0]
        )
        hint = said("remove the world, or put {effect} between two carts", effect=held[0])
        return Problem(path, "needs-wall", message, hint)
    between = scene.contacts[1:-1]
    lasting = any(contact is not None and contact.stiffness is not None for contact in between)
    if kind.needs == "pair" and not lasting:
        message = said(
            "{name} is about two carts that push each other for a time; none do here",
            name=kind.name,
        )
        return Problem(path, "no-pair", message, "contact: {law: bumper, stiffness: 200 N/m}")
    return None
