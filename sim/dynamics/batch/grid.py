"""A map: one outcome of a scene over one or two parameters.

    grid = solve(plain, axes, show)           the closed form wherever it is proven to hold
    run_points(plain, grid, show, 0, 0.2 s)   the points that are left, each a run of its own

Points are numbered row by row, point = row * columns + column; the first axis runs along a row.
Where too many points would have to be run, the grid is made coarser, so that a map never costs
more than MOST_RUNS runs. Nothing is interpolated and nothing is guessed.
"""

from __future__ import annotations

import math
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from sim.dynamics.batch.one_contact import Outcomes, outcomes
from sim.dynamics.batch.parameters import Axis, Parameters, parameters
from sim.dynamics.loop.run import run
from sim.dynamics.result.finished import Run
from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.result.trajectory import trajectory
from sim.scene import Scene, SceneError, apply_changes, read_scene

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]

MOST_RUNS = 1_600
MOST_WITH_EFFECTS = 400
"""Runs of one map: 40 × 40, and 20 × 20 with effects. A run of two carts takes about a tenth of a
millisecond here, with effects ten milliseconds, and five times that in a page."""

MOST_EVENTS = 200
"""Of one run on a map; more than that has no value on it."""

Axes = tuple[tuple[str, tuple[float, ...]], ...]
"""One or two: a path such as A.mass, and its values in SI."""

Show = tuple[str, str]
"""What is shown: ("v", cart) in m/s, ("F", "A-B") in N, the greatest, or ("warmed", "") in J."""


@dataclass(frozen=True, slots=True)
class Grid:
    """Values in SI, a row for each value of the second axis, a column for each of the first.

    NaN marks the points that are `left` to be run. `closed` says whether any point had a closed
    form, `coarser` whether the grid has fewer points than were asked for.
    """

    axes: Axes
    values: Values
    left: tuple[int, ...]
    closed: bool
    coarser: bool


def solve(plain: Mapping[str, Any], axes: Axes, show: Show) -> Grid:
    """Everything that has a closed form, in one go."""
    grid = _solved(plain, axes, show)
    runs = MOST_WITH_EFFECTS if plain.get("effects") else MOST_RUNS
    side = max(len(values) for _, values in axes)
    while len(grid.left) > runs and side > 2:
        most = runs * grid.values.size / len(grid.left)
        # The share of points that are left may grow as the grid is thinned: each time by one more.
        side = min(side - 1, math.isqrt(int(most)) if len(axes) == 2 else int(most))
        fewer = tuple((target, _thinned(values, side)) for target, values in axes)
        grid = replace(_solved(plain, fewer, show), coarser=True)
    return grid


def run_points(
    plain: Mapping[str, Any], grid: Grid, show: Show, start: int, seconds: float = math.inf
) -> list[float]:
    """The values of grid.left[start:], as many as fit into this time, at least one.

    NaN where a point has none: a scene that makes no sense there, or a run that did not end.
    """
    found: list[float] = []
    stop = time.perf_counter() + seconds
    for point in grid.left[start:]:
        found.append(_run_one(plain, changes_at(grid.axes, point), show))
        if time.perf_counter() >= stop:
            break
    return found


def changes_at(axes: Axes, point: int) -> dict[str, float]:
    """What is set at one point of the grid."""
    columns = len(axes[0][1])
    places = (point % columns, point // columns)
    return {target: values[k] for (target, values), k in zip(axes, places, strict=False)}


def _solved(plain: Mapping[str, Any], axes: Axes, show: Show) -> Grid:
    import numpy as np

    rows = [np.asarray(values, dtype=float) for _, values in axes]
    shaped = [rows[0][None, :], *(row[:, None] for row in rows[1:])]
    shape = (len(rows[1]) if len(rows) == 2 else 1, len(rows[0]))
    found = parameters(
        plain, [Axis(target, values) for (target, _), values in zip(axes, shaped, strict=True)]
    )
    if found is None:
        points = shape[0] * shape[1]
        return Grid(axes, np.full(shape, math.nan), tuple(range(points)), False, False)
    out = outcomes(found, shape)
    values = np.where(out.proven, _shown(found, out, show), math.nan)
    left = tuple(np.flatnonzero(~out.proven).tolist())
    return Grid(axes, values, left, bool(out.proven.any()), False)


def _shown(p: Parameters, out: Outcomes, show: Show) -> Values:
    what, of = show
    if what == "v":
        return out.v[p.carts.index(of)]
    return out.warmed if what == "warmed" else out.force[p.pairs.index(of)]


def _run_one(plain: Mapping[str, Any], changes: Mapping[str, float], show: Show) -> float:
    try:
        scene = read_scene(apply_changes(plain, changes))
        linked = show[0] == "F" and any(effect.between for effect in scene.effects)
        done = run(scene, max_events=MOST_EVENTS, keep_events=show[0] == "F", keep_motion=linked)
    except (SceneError, UnsolvedError):
        return math.nan
    if done.outcome.kind in ("too-many-events", "refused"):
        return math.nan
    if show[0] == "v":
        return done.v[_place(scene, show[1])]
    if show[0] == "warmed":
        return done.ledger.warmed
    return _greatest(done, show[1], linked=linked)


def _greatest(done: Run, pair: str, *, linked: bool) -> float:
    """N. As events tell it; of what no event tells, a spring, by the curve of the run."""
    told = [
        event.force or 0.0
        for event in done.record.events
        if event.kind in ("peak", "release") and "-".join(event.bodies) == pair
    ]
    grown = done.record.growing.items()
    told += [force for gap, force in grown if "-".join(done.scene.names_at(gap)) == pair]
    if linked:
        told.append(trajectory(done).greatest(pair))
    return max(told, default=0.0)


def _place(scene: Scene, name: str) -> int:
    return [cart.name for cart in scene.carts].index(name)


def _thinned(values: Sequence[float], most: int) -> tuple[float, ...]:
    """At most so many of the values, evenly spread, both ends among them."""
    count = max(2, min(most, len(values)))
    last = len(values) - 1
    return tuple(values[round(k * last / (count - 1))] for k in range(count))
