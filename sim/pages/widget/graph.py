"""A graph against time as SVG attributes. Its twin is `sim/web/src/graph.js`.

Curves are cubic between rows, drawn exactly as Bézier curves where they bend; rows closer than
the eye can see are left out, jumps never.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sim.pages.widget.numbers import fixed, px
from sim.pages.widget.reach import Reach
from sim.pages.widget.scales import Axis, axis, span
from sim.pages.widget.series import Series

WIDTH, HEIGHT = 360.0, 172.0
LEFT, RIGHT, TOP, BOTTOM = 46.0, 350.0, 8.0, 142.0
BELOW_LINE = 4.0  # units, from a grid line to the foot of its number
ONLY_THE_RUN = Reach(0.0, 0.0, 1.0, 0.0)
NEAR = 0.7  # units; rows nearer than this to the last drawn one are left out
STRAIGHT = 0.05  # units; a curve that bends less is drawn as a line


@dataclass(frozen=True, slots=True)
class Plane:
    """From time and value to drawing coordinates."""

    time: Axis
    value: Axis

    def x(self, t: float) -> float:
        """Drawing coordinate of a time in s."""
        return LEFT + (t - self.time.low) * ((RIGHT - LEFT) / (self.time.high - self.time.low))

    def y(self, value: float) -> float:
        """Drawing coordinate of a value."""
        return BOTTOM - (value - self.value.low) * (
            (BOTTOM - TOP) / (self.value.high - self.value.low)
        )


def plane_for(curves: Sequence[Series], until: float, reach: Reach = ONLY_THE_RUN) -> Plane:
    """Axes that cover zero, every curve and what the sliders may make of it."""
    least = min((min(c.values) for c in curves), default=0.0)
    most = max((max(c.values) for c in curves), default=0.0)
    low, high = min(least * reach.factor, reach.low), max(most * reach.factor, reach.high)
    room = reach.room * max(-least, most)
    if room > 0:
        low, high = max(low, -room), min(high, room)
    return Plane(span(0.0, until, 6), axis(low, high, 5))


def path(curve: Series, times: Sequence[float], plane: Plane) -> str:
    """The SVG path of a curve."""
    values, slopes = curve.values, curve.slopes
    kx = (RIGHT - LEFT) / (plane.time.high - plane.time.low)
    ky = (BOTTOM - TOP) / (plane.value.high - plane.value.low)
    drawn, x0, y0 = 0, plane.x(times[0]), plane.y(values[0])
    parts = [f"M{px(x0)} {px(y0)}"]
    last = len(times) - 1
    for k in range(1, last + 1):
        x, y = plane.x(times[k]), plane.y(values[k])
        if k < last and abs(x - x0) < NEAR and abs(y - y0) < NEAR:
            continue
        third = (times[k] - times[k - 1]) / 3
        if slopes is not None and drawn == k - 1 and third > 0:
            x1, x2 = x0 + third * kx, x - third * kx
            y1, y2 = y0 - slopes[k - 1] * third * ky, y + slopes[k] * third * ky
            if abs(y1 - (2 * y0 + y) / 3) > STRAIGHT or abs(y2 - (y0 + 2 * y) / 3) > STRAIGHT:
                parts.append(f"C{px(x1)} {px(y1)} {px(x2)} {px(y2)} {px(x)} {px(y)}")
                drawn, x0, y0 = k, x, y
                continue
        parts.append(f"L{px(x)} {px(y)}")
        drawn, x0, y0 = k, x, y
    return "".join(parts)


def time_marks(plane: Plane) -> list[dict[str, Any]]:
    """Vertical grid lines with their labels."""
    return [
        {"at": px(plane.x(t)), "label": fixed(t, plane.time.decimals)} for t in plane.time.ticks()
    ]


def value_marks(plane: Plane) -> list[dict[str, Any]]:
    """Horizontal grid lines with their labels; `zero` marks the one at 0."""
    return [
        {
            "at": px(plane.y(v)),
            "text_y": px(plane.y(v) + BELOW_LINE),
            "label": fixed(v, plane.value.decimals),
            "zero": v == 0,
        }
        for v in plane.value.ticks()
    ]
