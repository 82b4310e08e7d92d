"""What `carts fit` prints beside the sentences of a report."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sim.measured.events.stretch import Segment
from sim.scene.notation import number


def ladder(rungs: Mapping[str, Any] | None) -> list[str]:
    """The `rungs` of a report as text: the line stands where readings can no longer show it."""
    if not rungs:
        return []
    shown = [row["sentence"] for row in rungs["rows"] if row["verdict"] != "not-shown"]
    hidden = [row["sentence"] for row in rungs["rows"] if row["verdict"] == "not-shown"]
    rows = [f"  {sentence}" for sentence in (*shown, rungs["line"], *hidden, rungs["taken"])]
    return ["What do these readings call for? Each effect alone, largest first:", *rows]


def strip(segments: tuple[Segment, ...], names: tuple[str, str]) -> list[str]:
    """A line for each cart: rest 0.00–0.78 s, hand …; −1.00 to 0.12 s where times are negative."""
    lines = []
    for cart, name in enumerate(names):
        parts = [f"{one.kind} {_span(one)} s" for one in segments if one.cart == cart]
        if parts:
            lines.append(f"{name}: {', '.join(parts)}")
    return lines


def _span(segment: Segment) -> str:
    begin, end = number(segment.begin, 2), number(segment.end, 2)
    return f"{begin} to {end}" if "−" in begin + end else f"{begin}–{end}"
