"""One cart, one sensor or one phone over time, in SI."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from sim.measured.units import Kind

Content = Literal["length", "force", "acceleration"]
"""What a track holds: m, N or m/s²."""

FEWEST = 8
"""Readings of one cart. The model has eight unknowns for two."""


@dataclass(frozen=True, slots=True)
class Track:
    """One cart, or one force sensor: SI, times rising."""

    name: str
    t: tuple[float, ...]  # s
    value: tuple[float, ...]  # m, N or m/s²
    lines: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Reading:
    """What one file holds. `own`: each sensor may have its own zero and direction. `run`: the one
    that was read, of all `runs` that stand in it, where there are several. `assumed`: the kinds of
    quantity whose columns name no unit: they were read in the one that was asked for. `unnamed`:
    nothing says whose the only track is."""

    kind: Content
    tracks: tuple[Track, ...]
    notes: tuple[str, ...]
    own: bool = False
    run: str = ""
    runs: tuple[str, ...] = ()
    assumed: frozenset[Kind] = frozenset()
    unnamed: bool = False
