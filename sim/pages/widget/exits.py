"""When carts leave the picture at an open end. Twin: `sim/web/src/exits.js`.

Not an event of the run: the cart keeps its motion. But a reader must not think that it stopped.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sim.pages.widget.run import Run, value_at

HALVINGS = 40  # of a row's duration: far below what is printed


@dataclass(frozen=True, slots=True)
class Exit:
    """Cart `name` is out of the picture from `t` (s) on, with `velocity` as the camera sees it."""

    t: float
    name: str
    side: str
    velocity: float


def exits(
    header: Mapping[str, Any], run: Run, low: float, high: float, camera: float
) -> list[Exit]:
    """First time that each cart is wholly outside low to high (m, as the camera sees it)."""
    found = []
    for body in header["bodies"]:
        name, half = body["name"], body["length"] / 2

        def beyond(t: float, name: str = name, half: float = half) -> float:
            x = value_at(run.t, run.x[name], run.v[name], t) - camera * t
            return max(x - half - high, low - x - half)

        row = next((k for k, t in enumerate(run.t) if beyond(t) > 0), 0)
        if not row:
            continue
        before, after = run.t[row - 1], run.t[row]
        for _ in range(HALVINGS):
            middle = (before + after) / 2
            if beyond(middle) > 0:
                after = middle
            else:
                before = middle
        x = value_at(run.t, run.x[name], run.v[name], after) - camera * after
        velocity = value_at(run.t, run.v[name], run.a[name], after) - camera
        found.append(Exit(after, name, "right" if x > high else "left", velocity))
    return found
