"""Contact laws as a scene names them. Each is described in a folder of its own under `sim/laws`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import import_module

from sim.scene.effects import BrokenFolderError
from sim.scene.fields import Field

FOLDER = "sim.laws"


@dataclass(frozen=True, slots=True, kw_only=True)
class LawKind:
    """A law: its name, and the numbers that it takes.

    `takes_no` says why for a number that it does not take. A law without `stiffness` has no
    duration, one without `restitution` too holds the carts together. `no_zero`: why a restitution
    of 0 is refused.
    """

    name: str
    says: str
    place: int = 1000  # in lists of all laws, from small to large
    stiffness: Field | None = None
    restitution: Field | None = None
    takes_no: Mapping[str, str] = field(default_factory=dict)
    no_zero: str = ""


@cache
def laws() -> Mapping[str, LawKind]:
    """Every law by name, in the order of lists. Reads the descriptions, and nothing else."""
    import pkgutil

    found: list[LawKind] = []
    for folder in pkgutil.iter_modules(import_module(FOLDER).__path__):
        if not folder.ispkg:
            continue
        law = getattr(import_module(f"{FOLDER}.{folder.name}"), "LAW", None)
        if not isinstance(law, LawKind) or folder_of(law.name) != folder.name:
            raise BrokenFolderError(f"{FOLDER}.{folder.name} describes no LAW of that name")
        found.append(law)
    return {law.name: law for law in sorted(found, key=lambda law: (law.place, law.name))}


def folder_of(name: str) -> str:
    """The folder of a law: push-only stands in push_only."""
    return name.replace("-", "_")
