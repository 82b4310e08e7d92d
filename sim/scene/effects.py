"""What may act on carts besides contacts. Nothing acts that a scene does not list.

Each kind is described in a folder of its own under `sim/effects`, found when first asked for: its
numbers with units, which carts it names, its rules and its names. This module knows none of them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from importlib import import_module
from typing import Literal

from sim.scene.fields import Field
from sim.scene.problem import Problem
from sim.scene.said import said

FOLDER = "sim.effects"


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


Rule = Callable[[Sequence[Effect]], Iterator[Problem]]
"""Told effects of its kind that act together; says what cannot be meant."""

RoomRule = Callable[[Effect, Fraction | None], Iterator[Problem]]
"""Told one effect and the gap [m] between its two bodies at the start."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EffectKind:
    """A kind of effect: name, what it does, its numbers, and the other keys it takes.

    `needs` are keys that must be there beside the numbers: ``cart`` or ``between``. `one_of`:
    at least one of these numbers must be given. `stores`: its work is a change of energy that is
    stored, in the place of each cart or in the gap between two; `gives`: it is energy that comes
    into the scene, but where the number `stored_with` is given: then it is stored in the gap. What
    is neither, and what drag and dampers take, is warm.
    """

    name: str
    says: str
    fields: tuple[Field, ...]
    place: int = 1000  # in lists of all kinds, from small to large
    needs: Literal["", "cart", "between"] = ""
    walls: bool = False  # `between` may name a wall
    overlap: bool = False  # its two may overlap at the start
    one_of: tuple[str, ...] = ()
    by: str | None = None  # default agent of a force
    stores: Literal["", "place", "gap"] = ""
    gives: bool = False
    stored_with: str = ""
    apart: bool = False  # its two never touch, however fast they come
    called: str = ""  # in sentences: “Not simulated: a slope”; left out: the name
    switch: str = ""  # on its switch; left out: as it is called
    agent: str = ""  # who pushes, in “force on A by the air”; empty: `by`, or the other of the two
    everyday: tuple[str, ...] = ()  # what authors write for its name
    rule: Rule | None = None
    room_rule: RoomRule | None = None

    def keeps(self, effect: Effect) -> Literal["", "place", "gap"]:
        """Where an effect of this kind stores what it gives, if it does."""
        return "gap" if self.stored_with in effect.numbers else self.stores

    @property
    def example(self) -> str:
        """An entry of the list, with what it cannot do without."""
        first = next((one for one in self.fields if one.key in self.one_of), self.fields[0])
        given = {one.key: one for one in (first, *self.fields)
                 if one is first or (one.default is None and not one.optional)}  # fmt: skip
        numbers = [f"{key}: {one.dimension.example}" for key, one in given.items()]
        whom = {"cart": ["cart: A"], "between": ["between: [A, B]"]}.get(self.needs, [])
        return f"- {self.name}: {{{', '.join([*numbers, *whom])}}}"

    @property
    def label(self) -> str:
        """What its switch is called."""
        return self.switch or self.called or said(self.name)

    def label_of(self, field: Field) -> str:
        """What the slider of one of its numbers is called."""
        named = said("{effect}: {what}", effect=self.called or self.name, what=field.says)
        return field.label or named


class BrokenFolderError(ImportError):
    """A folder under `sim/effects` or `sim/laws` that does not describe what it is named for."""


@cache
def kinds() -> Mapping[str, EffectKind]:
    """Every kind by name, in the order of lists. Reads the descriptions, and nothing else."""
    import pkgutil

    found: list[EffectKind] = []
    for folder in pkgutil.iter_modules(import_module(FOLDER).__path__):
        if not folder.ispkg:
            continue
        kind = getattr(import_module(f"{FOLDER}.{folder.name}"), "KIND", None)
        if not isinstance(kind, EffectKind) or kind.name != folder.name:
            raise BrokenFolderError(f"{FOLDER}.{folder.name} describes no KIND of that name")
        found.append(kind)
    return {kind.name: kind for kind in sorted(found, key=lambda kind: (kind.place, kind.name))}
