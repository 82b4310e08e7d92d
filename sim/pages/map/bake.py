"""The values of a map, computed when the site is built, and the range that its sliders reach."""

from __future__ import annotations

import itertools
import math
from array import array
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sim.pages.blocks.bake import bake, problems_of
from sim.scene import Problem, SceneError, apply_changes
from sim.scene.fence.map import Map
from sim.scene.said import from_wire

ROUGH = 9
"""Points per axis for the range that the sliders reach: extremes lie at the ends of an axis, as a
rule; what lies outside after all is painted as the last band."""

PLACES = {1: 9, 2: 5}
"""Of each slider, by how many there are: an extreme may lie between its ends, as the speed that a
cart in the middle hands on does."""


@dataclass(frozen=True, slots=True)
class MapRun:
    """Values row after row, NaN where there is none; `low` and `high`: of all the sliders' runs."""

    axes: list[list[float]]
    values: array[float]
    low: float
    high: float
    why: str
    packages: tuple[str, ...] = ("numpy",)  # that the page needs to compute it anew

    @property
    def rows(self) -> int:
        """Of the grid; one where there is one axis."""
        return len(self.axes[1]) if len(self.axes) == 2 else 1


def bake_map(described: Map, plain: Mapping[str, Any]) -> MapRun | list[Problem]:
    """The map of `plain` (the block's values, its scene's included), or why there is none."""
    whole = _computed(plain, {})
    if isinstance(whole, list):
        return whole
    header, values = whole
    seen = [value for value in values if not math.isnan(value)]
    if not seen:
        message = "no point of this map has a value: the scene makes no sense at any of them"
        return [Problem(("over",), "no-value", message, "look at the scene, or change from and to")]
    for chosen in _places(described):
        rough = _computed({**plain, "points": ROUGH}, chosen)
        if not isinstance(rough, list):
            seen += [value for value in rough[1] if not math.isnan(value)]
    return MapRun(
        header["axes"], values, min(seen), max(seen), from_wire(header["why"]), _packages(described)
    )


def _places(described: Map) -> list[dict[str, float]]:
    """What the sliders may be set to, evenly spread; nothing where a map has none."""
    count = PLACES.get(len(described.controls), 0)
    every = [
        [(c.set, c.low + (c.high - c.low) * k / (count - 1)) for k in range(count)]
        for c in described.controls
    ]
    return [dict(chosen) for chosen in itertools.product(*every)] if every else []


def _packages(described: Map) -> tuple[str, ...]:
    """numpy, and what the runs at the corners of the map need."""
    found = {"numpy"}
    ends = [((axis.set, axis.low), (axis.set, axis.high)) for axis in described.over]
    for corner in ({}, *map(dict, itertools.product(*ends))):
        try:
            plain = apply_changes(described.plain, corner)
        except SceneError:
            continue
        run = bake(plain)
        if not isinstance(run, list):
            found |= run.packages
    return tuple(sorted(found))


def _computed(
    plain: Mapping[str, Any], changes: Mapping[str, float]
) -> tuple[dict[str, Any], array[float]] | list[Problem]:
    """Header and values of a whole map, slice after slice."""
    from sim.bridge.protocol import answer  # pulls the numerics: only when something is computed

    request = {"id": 0, "kind": "map", "map": plain, "set": changes}
    header, values = answer(request)
    if not header["ok"]:
        return problems_of(header)
    while header["done"] < header["runs"]:
        header, found = answer({**request, "from": header["done"]})
        half = len(found) // 2
        for place, value in zip(found[:half], found[half:], strict=True):
            values[int(place)] = value
    return header, values
