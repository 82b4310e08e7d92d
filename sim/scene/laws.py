"""Contact laws as a scene names them. Each is described in a folder of its own under `sim/laws`."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import import_module

from sim.scene.effects import BrokenFolderError
from sim.scene.fields import RESTITUTION, STIFFNESS, Field
from sim.scene.said import template

FOLDER = "sim.laws"


@dataclass(frozen=True, slots=True, kw_only=True)
class LawKind:
    """A law: its name, and the numbers that it takes.

    `takes_no` says why for a number that it does not take. A law without `stiffness` has no
    duration, one without `restitution` too holds the carts together. `power`: of the overlap, to
    which its spring grows; only a linear one has closed forms and series throughout, any other is
    integrated beside a third body. `no_zero`: why a restitution of 0 is refused.
    """

    name: str
    says: str
    place: int = 1000  # in lists of all laws, from small to large
    stiffness: Field | None = None
    restitution: Field | None = None
    power: float = 1.0
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


WRITTEN = LawKind(
    name="mine.py",
    says=template("a law of your own, written in Python"),
    stiffness=STIFFNESS,
    restitution=RESTITUTION,
)
"""A law that is a function in a file (`sim.mine`). What its two numbers mean, the function says."""

FILE = re.compile(r"[A-Za-z][A-Za-z0-9_-]{0,40}\.py", re.ASCII)


def is_written(name: object) -> bool:
    """Is this the name of a file with a law, `mine.py`?"""
    return isinstance(name, str) and FILE.fullmatch(name) is not None


def power_of(name: object) -> float:
    """Of the overlap, to which the spring of this law grows; 1 for what is no law."""
    kind = law_kind(name)
    return 1.0 if kind is None else kind.power


def has_formulas(name: object) -> bool:
    """Whether a run with this law never calls for an integrator, and for what one is made of."""
    return power_of(name) == 1.0


def law_kind(name: object) -> LawKind | None:
    """The description of a law, also of one in a file; None for what is none."""
    if is_written(name):
        return WRITTEN
    return laws().get(name) if isinstance(name, str) else None
