"""A finished run as it came over the wire.

Rows are sorted by time; at a jump two rows share one
time (before, after). Between rows every quantity is a cubic Hermite with the given slopes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

Columns = Mapping[str, Sequence[float]]


@dataclass(frozen=True, slots=True)
class Run:
    """Times in s; x, v, a per cart in SI; F (N, positive pushes) and its rate per pair.

    `effects`: forces of effects on one cart (N, + right), by “kind cart”; called E on the wire.
    """

    t: Sequence[float]
    x: Columns
    v: Columns
    a: Columns
    F: Columns
    rate: Columns  # dF/dt, called dF on the wire
    effects: Columns = field(default_factory=dict)

    def as_dict(self, digits: int) -> dict[str, Any]:
        """The numbers for the page, rounded to so many significant digits."""

        def short(values: Sequence[float]) -> list[float | int]:
            rounded = [float(f"{value:.{digits}g}") for value in values]
            return [int(v) if v == int(v) and abs(v) < 1e15 else v for v in rounded]

        table: dict[str, Any] = {"t": short(self.t)}
        parts = {"x": self.x, "v": self.v, "a": self.a, "F": self.F, "dF": self.rate}
        parts["E"] = self.effects
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
    parts: dict[str, Any] = {"x": {}, "v": {}, "a": {}, "F": {}, "dF": {}, "E": {}, "t": []}
    for k, (quantity, *key) in enumerate(header["columns"]):
        column = list(numbers[k * rows : (k + 1) * rows])
        if key:
            parts.setdefault(quantity, {})[" ".join(key)] = column
        else:
            parts[quantity] = column
    return Run(*(parts[name] for name in ("t", "x", "v", "a", "F", "dF", "E")))
