"""Logs of two carts that go at one velocity each, under heads of any kind; and what is read."""

from __future__ import annotations

from sim.measured.tracks import read_measured
from sim.measured.units import Units

TIMES = [0.05 * k for k in range(30)]
A = [0.2 + 0.3 * t for t in TIMES]
B = [0.9 - 0.1 * t for t in TIMES]
SLOW = [0.2 + 0.1 * t for t in TIMES]


def table(heads: str, *columns: list[float]) -> str:
    rows = [",".join(f"{value:.6f}" for value in row) for row in zip(*columns, strict=True)]
    return "\n".join([heads, *rows]) + "\n"


def places(text: str, run: str = "") -> dict[str, float]:
    """The first place of each cart, by its name."""
    return {one.name: one.value[0] for one in read_measured([text], Units(run=run)).tracks}
