"""When bodies touch: the intervals that the timeline shades. Twin: `sim/web/src/windows.js`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

ENDS = ("separate", "stick")


@dataclass(frozen=True, slots=True)
class Touch:
    """Bodies in contact from `start` to `end`, in s."""

    bodies: tuple[str, ...]
    start: float
    end: float


def touches(events: Sequence[Mapping[str, Any]], until: float) -> list[Touch]:
    """Contacts that last, in order of their start. One that does not end lasts until its peak."""
    open_since: dict[tuple[str, ...], float] = {}
    last_peak: dict[tuple[str, ...], float] = {}
    found = []
    for event in events:
        bodies, t, kind = tuple(event["bodies"]), float(event["t"]), event["kind"]
        if kind == "contact" and not event.get("impulse"):
            open_since[bodies] = t
        elif kind == "peak":
            last_peak[bodies] = t
        elif kind in ENDS and bodies in open_since:
            found.append(Touch(bodies, open_since.pop(bodies), t))
    for bodies, start in open_since.items():
        end = last_peak.get(bodies, until)
        found.append(Touch(bodies, start, end if end > start else until))
    return sorted((touch for touch in found if touch.end > touch.start), key=lambda w: w.start)
