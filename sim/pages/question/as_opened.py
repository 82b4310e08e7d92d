"""What a reading is with the settings of the page as it opens: for the teacher's key.

A student reads off the run on the screen, whatever was set there, and is marked by that run. Who
marks by hand wants a number all the same. Between two samples a quantity is the cubic through
their values and slopes, as the page reads it.
"""

from __future__ import annotations

from array import array
from bisect import bisect_right
from collections.abc import Iterator, Mapping
from itertools import pairwise
from math import isfinite

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import trajectory
from sim.lesson.kinds.run import Reading
from sim.scene.model import Scene

NOUGHT = 1e-12
"""Of the greatest in the run: a cart that stops dead has rounding left."""

SLOPES = {"x": "v", "v": "a", "F": "dF"}


def as_opened(reading: Reading, scene: Scene) -> float | None:
    """The quantity in the reading's unit; None where the run has none of it (no such force)."""
    columns = trajectory(run(scene)).columns
    found = read_off(reading, columns, {cart.name: cart.mass for cart in scene.carts})
    return None if found is None else found / reading.per


def read_off(
    reading: Reading, columns: Mapping[tuple[str, ...], array[float]], mass: Mapping[str, float]
) -> float | None:
    """The quantity in SI, as the page reads it off: sim/web/src/question/marking/own-run.js."""
    what, _, whose = reading.quantity.partition(".")
    factor = mass[whose] if what == "p" else 1.0
    what = "v" if what == "p" else what
    values = columns.get((what, whose))
    if values is None:
        return None
    slopes, times = columns.get((SLOPES.get(what, ""), whose)), columns[("t",)]
    if reading.at == "largest":
        found = max((*values, *_turns(times, values, slopes)), key=abs)
    elif reading.at == "start":
        found = values[0]
    elif reading.at == "end":
        found = values[-1]
    else:
        found = _between(times, values, slopes, float(reading.at))
    if abs(found) <= NOUGHT * max(map(abs, values)):
        return 0.0
    return factor * found


def _turns(t: array[float], values: array[float], slopes: array[float] | None) -> Iterator[float]:
    """What it is where it turns between two samples, as on a slope within one flight."""
    for k, (before, after) in enumerate(pairwise(slopes or ())):
        if before * after < 0 and t[k + 1] > t[k]:
            turn = t[k] + (t[k + 1] - t[k]) * before / (before - after)
            yield _between(t, values, slopes, turn)


def _between(
    t: array[float], values: array[float], slopes: array[float] | None, at: float
) -> float:
    """At `at` s; after a jump, where there is one."""
    k = bisect_right(t, at) - 1
    if k + 1 >= len(t):
        return values[-1]
    span = t[k + 1] - t[k]
    s = (at - t[k]) / span
    straight = values[k] + s * (values[k + 1] - values[k])
    if slopes is None:
        return straight
    secant = (values[k + 1] - values[k]) / span
    bend = (1.0 - s) * (slopes[k] - secant) - s * (slopes[k + 1] - secant)
    found = straight + s * (1.0 - s) * span * bend
    return found if isfinite(found) else values[k]  # slopes beyond all numbers: a step
