"""From a `measured` block to the complete `<carts-measured>` element.

Before Python starts, and without a script, the readings stand there: as points over time and as a
table. What they tell is not told: that is the student's work. Twin of the figure:
`sim/web/src/measured/figure.js`.
"""

from __future__ import annotations

from typing import Any

from sim.measured.tracks import Measured, Track
from sim.measured.units import OFFERED
from sim.pages.measured.block import MeasuredBlock
from sim.pages.templates import script_json, templates
from sim.pages.widget.numbers import fixed, px
from sim.pages.widget.scales import Axis, span

LEFT, RIGHT, TOP, BOTTOM = 58, 630, 10, 250
ROOM = 0.06
"""Of the values, above and below the points."""

MOST_ROWS = 60
"""Rows of the table without a script; the page's script fills in all."""


def render_measured(block: MeasuredBlock) -> str:
    """HTML of the element."""
    view = {
        "id": block.id,
        "title": block.title,
        "name": block.name,
        "law": block.law,
        "units": block.units,
        "offered": OFFERED,
        "figure": figure(block.measured) if block.measured else None,
        "head": head(block.measured),
        "rows": rows(block.measured),
        "left_out": max(0, _count(block.measured) - MOST_ROWS),
        "said": "; ".join(block.measured.notes) if block.measured else "",
        "baked": script_json(
            {
                "id": block.id,
                "name": block.name,
                "text": block.text,
                "units": _units(block),
                "law": block.law,
                "read": _read(block.measured),
            }
        ),
    }
    return str(templates("sim.pages.measured").get_template("measured.html.j2").render(view))


def _units(block: MeasuredBlock) -> dict[str, str] | None:
    if block.units is None:
        return None
    return {"length": block.units.length, "time": block.units.time, "force": block.units.force}


def _read(measured: Measured | None) -> dict[str, Any] | None:
    """The readings as the bridge would answer."""
    if measured is None:
        return None
    return {
        "kind": measured.kind,
        "names": list(measured.names),
        "read": list(measured.notes),
        "tracks": [{"t": list(t.t), "value": list(t.value)} for t in measured.tracks],
    }


def figure(measured: Measured) -> dict[str, Any]:
    """Points of both tracks over time, with axes."""
    times = [t for track in measured.tracks for t in track.t]
    values = [value for track in measured.tracks for value in track.value]
    low, high = min(values), max(values)
    room = ROOM * (high - low) or 1.0
    t, x = span(min(times), max(times), 8), span(low - room, high + room, 8)
    return {
        "points": [points(track, t, x) for track in measured.tracks],
        "t_ticks": [(px(_across(t, tick)), fixed(tick, t.decimals)) for tick in t.ticks()],
        "x_ticks": [(px(_up(x, tick)), fixed(tick, x.decimals)) for tick in x.ticks()],
        "unit": "x in m" if measured.kind == "length" else "F in N",
    }


def points(track: Track, t: Axis, x: Axis) -> str:
    """One path of dots: a stroke of no length with round ends."""
    places = zip(track.t, track.value, strict=True)
    return "".join(f"M{px(_across(t, time))} {px(_up(x, value))}h0" for time, value in places)


def _across(axis: Axis, t: float) -> float:
    return LEFT + (t - axis.low) / (axis.high - axis.low) * (RIGHT - LEFT)


def _up(axis: Axis, value: float) -> float:
    return BOTTOM - (value - axis.low) / (axis.high - axis.low) * (BOTTOM - TOP)


def head(measured: Measured | None) -> list[str]:
    """Heads of the table."""
    if measured is None:
        return []
    letter, unit = ("x", "m") if measured.kind == "length" else ("F", "N")
    return ["t in s", *(f"{letter} of {name} in {unit}" for name in measured.names)]


def _count(measured: Measured | None) -> int:
    return len({t for track in measured.tracks for t in track.t}) if measured else 0


def rows(measured: Measured | None) -> list[list[str]]:
    """The first readings as text."""
    if measured is None:
        return []
    tables = [dict(zip(track.t, track.value, strict=True)) for track in measured.tracks]
    times = sorted({t for track in measured.tracks for t in track.t})[:MOST_ROWS]
    return [
        [fixed(t, 4), *(fixed(table[t], 4) if t in table else "" for table in tables)]
        for t in times
    ]
