"""Packages of ours that few pages load, beside the one that every live page has."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

from .ours import (
    CLASSROOM,
    MEASURED,
    OWN_LAW,
    PROOF,
    TEACHER,
    WORLDS,
    Ours,
    read_classroom,
    read_measured,
    read_own_law,
    read_proof,
    read_worlds,
)
from .teacher import read_teacher

EXTRAS = {
    CLASSROOM: read_classroom,
    TEACHER: read_teacher,
    MEASURED: read_measured,
    WORLDS: read_worlds,
    OWN_LAW: read_own_law,
    PROOF: read_proof,
}


def read_extras(names: Collection[str], package: Path, version: str) -> list[Ours]:
    """Return those of `names` that are ours; `package` is the folder of `sim`."""
    return [read(package, version) for name, read in EXTRAS.items() if name in names]
