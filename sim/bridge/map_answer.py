"""A map as the wire delivers it: all values that have a formula at once, the others in slices.

    {"id": 8, "kind": "map", "map": {...plain map...}, "set": {"B.mass": 2}, "from": 0}

The first answer holds the whole grid, row after row; NaN marks what has no value. Where points have
to be run one by one, it holds as many of them as SLICE seconds allow, `done` of `runs`; asked again
with `"from": done`, an answer holds the next ones: their places in the grid, then their values.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Mapping
from typing import Any

from sim.dynamics.batch.grid import Axes, Grid, run_points, solve
from sim.scene import apply_changes
from sim.scene.fence.map import read_map
from sim.scene.read import SCENE_KEYS
from sim.scene.said import joined, said, wire

SLICE = 0.15
"""s. How long a page waits for a slice of runs: it can be drawn, and dropped, in between."""


def map_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """Header and numbers; raises SceneError for what an author or a reader typed."""
    described = read_map(changed(request.get("map") or {}, request.get("set") or {}))
    names = [control.set for control in described.over]
    axes: Axes = tuple(zip(names, described.values, strict=True))
    show = (described.show.kind, described.show.of)
    grid = solve(described.plain, axes, show)
    start = request.get("from")
    start = start if isinstance(start, int) and start > 0 else 0
    found = run_points(described.plain, grid, show, start, SLICE) if grid.left else []
    done = start + len(found)
    header = {
        "axes": [list(values) for _, values in grid.axes],
        "rows": grid.values.shape[0],
        "columns": grid.values.shape[1],
        "runs": len(grid.left),
        "done": done,
        "coarser": grid.coarser,
        "why": wire(_why(grid, bool(described.scene.effects))),
    }
    if start:
        return header, array("d", [*map(float, grid.left[start:done]), *found])
    flat = grid.values.ravel()
    flat[list(grid.left[:done])] = found
    return header, array("d", flat.tobytes())


def changed(plain: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """The map with other numbers in its scene."""
    scene = {key: value for key, value in plain.items() if key in SCENE_KEYS}
    return {**plain, **apply_changes(scene, changes)}


def _why(grid: Grid, effects: bool) -> str:
    """How the values were found, in words."""
    points = _many(math.prod(len(values) for _, values in grid.axes))
    if not grid.left:
        return said(
            "At each of the {points} points there is at most one contact before the run ends: "
            "all of them were computed together from the closed form, exact.",
            points=points,
        )
    if grid.closed:
        how = said(
            "{left} of {points} points have more than one contact, or one that the end cuts off. "
            "Each of these is a run of its own, exact as that of a scene; the others come from "
            "the closed form.",
            left=_many(len(grid.left)),
            points=points,
        )
    elif effects:
        how = said(
            "Effects act in this scene: each of the {points} points is a run of its own, exact as "
            "that of a scene.",
            points=points,
        )
    else:
        how = said(
            "No formula gives all points at once here: each of the {points} points is a run of its "
            "own, exact as that of a scene.",
            points=points,
        )
    fewer = said("The grid is coarser because runs take time.") if grid.coarser else ""
    return joined(how, fewer)


def _many(number: int) -> str:
    """36 381, with a narrow space that does not break."""
    return f"{number:,}".replace(",", "\u202f")
