"""A finished run as it came over the wire, and its values at any instant.

Its twin is `sim/web/src/trajectory.js`. Rows are sorted by time; at a jump two rows share one
time (before, after). Between rows every quantity is a cubic Hermite with the given slopes.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

Columns = Mapping[str, Sequence[float]]


@dataclass(frozen=True, slots=True)
class Run:
    """Times in s; x, v, a per cart in SI; F (N, positive pushes) and its rate per pair."""

    t: Sequence[float]
    x: Columns
    v: Columns
    a: Columns
    F: Columns
    rate: Columns  # dF/dt, called dF on the wire

    def as_dict(self, digits: int) -> dict[str, Any]:
        """The numbers for the page, rounded to so many significant digits."""

        def short(values: Sequence[float]) -> list[float | int]:
            rounded = [float(f"{value:.{digits}g}") for value in values]
            return [int(v) if v == int(v) and abs(v) < 1e15 else v for v in rounded]

        table: dict[str, Any] = {"t": short(self.t)}
        parts = {"x": self.x, "v": self.v, "a": self.a, "F": self.F, "dF": self.rate}
        for name, columns in parts.items():
            table[name] = {key: short(column) for key, column in columns.items()}
        return table

    def start(self) -> Run:
        """Places and velocities of the first row: what a page may know before the lock."""
        x, v = ({key: column[:1] for key, column in part.items()} for part in (self.x, self.v))
        return Run(self.t[:1], x, v, {}, {}, {})


def from_wire(header: Mapping[str, Any], numbers: Sequence[float]) -> Run:
    """The run of a header and its numbers, column after column."""
    rows = int(header["rows"])
    parts: dict[str, Any] = {"x": {}, "v": {}, "a": {}, "F": {}, "dF": {}, "t": []}
    for k, (quantity, *key) in enumerate(header["columns"]):
        column = list(numbers[k * rows : (k + 1) * rows])
        if key:
            parts.setdefault(quantity, {})[" ".join(key)] = column
        else:
            parts[quantity] = column
    return Run(parts["t"], parts["x"], parts["v"], parts["a"], parts["F"], parts["dF"])


def value_at(
    times: Sequence[float], values: Sequence[float], slopes: Sequence[float] | None, t: float
) -> float:
    """The value at time t; at a jump the one after it. Without slopes: straight lines."""
    k = bisect_right(times, t) - 1
    if k < 0:
        return values[0]
    if k >= len(times) - 1:
        return values[-1]
    h = times[k + 1] - times[k]
    s = (t - times[k]) / h
    if slopes is None:
        return values[k] + (values[k + 1] - values[k]) * s
    r = 1 - s
    return (
        values[k] * (1 + 2 * s) * r * r
        + slopes[k] * h * s * r * r
        + values[k + 1] * (1 + 2 * r) * s * s
        - slopes[k + 1] * h * r * s * s
    )
