"""Tables of values behind the graphs. Their twin is `sim/web/src/tables.js`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.pages.widget.numbers import fixed
from sim.pages.widget.run import value_at
from sim.pages.widget.scales import span
from sim.pages.widget.series import Series

ROWS = 10  # about so many round times, besides the events
MOST_EVENTS = 24


def table_times(until: float, events: Sequence[Mapping[str, Any]]) -> list[float]:
    """Round times and the times of the events, in order, each once."""
    times = {*span(0.0, until, ROWS).ticks(), until}
    times.update(event["t"] for event in events[:MOST_EVENTS])
    return sorted(times)


def table_rows(
    curves: Sequence[Series],
    run_times: Sequence[float],
    times: Sequence[float],
    decimals: Mapping[str, int],
    quantity: str,
    scale: float,
) -> list[list[str]]:
    """Cells as text: time, then one value per curve, equal decimals in a column."""
    rows = []
    for t in times:
        cells = [fixed(t, decimals["t"])]
        for curve in curves:
            value = value_at(run_times, curve.values, curve.slopes, t)
            cells.append(fixed(0.0 if abs(value) < 1e-9 * scale else value, decimals[quantity]))
        rows.append(cells)
    return rows
