"""The optional modules of an effect's folder, imported only where somebody asks for one."""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from types import ModuleType


def part_of(kind: str, part: str) -> ModuleType | None:
    """`sim/effects/<kind>/<part>.py`; None where the folder has no such module."""
    name = f"sim.effects.{kind}.{part}"
    return None if find_spec(name) is None else import_module(name)
