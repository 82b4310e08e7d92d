"""A stepped run as it is drawn: what the method itself does between the ends of its steps.

Within a step the velocity changes evenly, so each step has two samples, with the same slope of v
and of F at both; the acceleration is a staircase. Nothing is smoothed over. Where a run blows up,
it is drawn as far as there is something to see.
"""

from __future__ import annotations

import itertools
import math
from array import array
from dataclasses import dataclass

from sim.dynamics.result.finished import Run
from sim.dynamics.result.trajectory import MOST_NUMBERS, Trajectory, trajectory
from sim.dynamics.stepping.recorded import SteppedRun

FAR = 20.0
"""Times the greatest speed of the exact run. What is faster has blown up."""

SLOWEST = 1e-3
"""m/s that count as the greatest speed of a scene in which nothing moves."""

Columns = dict[tuple[str, ...], "array[float]"]


@dataclass(frozen=True, slots=True)
class Drawn:
    """Samples, and the time [s] from which the run is not drawn, if there is one."""

    samples: Trajectory
    blown: float | None


def drawn(result: SteppedRun, solved: Run) -> Drawn:
    """The samples of a stepped run; `solved` is the exact one."""
    given = result.samples.columns
    rows, blown = _seen(given, solved)
    most = max(2, MOST_NUMBERS // (2 * len(given)))
    every = max(1, math.ceil(rows / most))
    places = [*range(0, rows - 1, every), rows - 1]
    return Drawn(Trajectory(_staircase(given, places)), blown)


def _seen(given: Columns, solved: Run) -> tuple[int, float | None]:
    """How many rows can be drawn, and when that ends if not at the end."""
    speeds = [values for name, values in given.items() if name[0] == "v"]
    exact = trajectory(solved, 2).columns
    fastest = max(abs(v) for name, values in exact.items() if name[0] == "v" for v in values)
    limit = FAR * max(fastest, SLOWEST)
    for k, row in enumerate(zip(*speeds, strict=True)):
        if not all(abs(v) <= limit for v in row):  # NaN is no number that is less
            return max(1, k), given[("t",)][k]
    return len(given[("t",)]), None


def _staircase(given: Columns, places: list[int]) -> Columns:
    """Two rows per step: at both the slope of the straight line through its ends."""
    times = given[("t",)]
    made: Columns = {}
    for name, values in given.items():
        if name[0] == "a":
            continue  # it comes from the velocities
        doubled = array("d")
        for a, b in itertools.pairwise(places):
            doubled.extend((values[a], values[b]))
        made[name] = doubled or array("d", [values[0]])
        if name[0] in ("v", "F"):
            slopes = array("d")
            for a, b in itertools.pairwise(places):
                span = times[b] - times[a]
                slope = (values[b] - values[a]) / span if span > 0.0 else 0.0
                slopes.extend((slope, slope))
            made["a" if name[0] == "v" else "dF", *name[1:]] = slopes or array("d", [0.0])
    return made
