"""The figure of a map: geometry, numbers on its axes, the picture or the curve.

+---------------------------+
|  picture, or a curve      |   PLOT, in drawing units
+---------------------------+
  numbers, the first axis
[ bands with their numbers ]     for two axes
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from sim.pages.map.bake import MapRun
from sim.pages.map.palette import NONE, ZERO, edge
from sim.pages.map.png import data_url, png
from sim.pages.map.scale import Scale, pixels
from sim.pages.widget.numbers import decimals_for, fixed, px
from sim.pages.widget.scales import Axis, axis, span
from sim.scene.controls import Control
from sim.scene.map import Map

LEFT, TOP, RIGHT, BOTTOM = 58.0, 10.0, 388.0, 270.0
WIDTH, HEIGHT, HEIGHT_OF_CURVE = 400.0, 370.0, 312.0
BAR_TOP, BAR_HEIGHT = 322.0, 12.0
TICKS = 5
MOST_NUMBERS = 7  # at the bands; more would touch each other
SMALLER = 2  # decimals that small values may have more than the largest
BASELINE = 4.0  # from a tick to the foot of its number


def figure(described: Map, run: MapRun, scale: Scale) -> dict[str, Any]:
    """What the template draws."""
    across = described.over[0]
    flat = len(run.axes) == 1
    x = span(across.shown(across.low), across.shown(across.high), TICKS)
    y = value_axis(run) if flat else _shown_axis(described.over[1])
    made: dict[str, Any] = {
        "width": px(WIDTH),
        "height": px(HEIGHT_OF_CURVE if flat else HEIGHT),
        "left": px(LEFT),
        "top": px(TOP),
        "across": px(RIGHT - LEFT),
        "down": px(BOTTOM - TOP),
        "right": px(RIGHT),
        "bottom": px(BOTTOM),
        "x_ticks": [(px(x_at(t, x)), fixed(t, x.decimals)) for t in x.ticks()],
        "y_ticks": [
            (px(y_at(t, y)), px(y_at(t, y) + BASELINE), fixed(t, y.decimals)) for t in y.ticks()
        ],
        "x_label": _label(across),
        "y_label": f"{described.show.label} in {described.show.unit}"
        if flat
        else _label(described.over[1]),
        "middle_y": px((TOP + BOTTOM) / 2),
        "middle_x": px((LEFT + RIGHT) / 2),
    }
    if flat:
        xs = [across.shown(value) for value in run.axes[0]]
        return made | {"curve": curve(xs, run.values, x, y), "picture": "", "bar": []}
    palette = [*scale.colours, NONE, *map(edge, scale.colours), ZERO]
    image = png(pixels(run.values, len(run.axes[0]), scale), palette)
    return made | {"curve": "", "picture": data_url(image), "bar": bar(scale), **_bar_place(scale)}


def value_axis(run: MapRun) -> Axis:
    """Of a curve; it covers zero and all that the sliders reach."""
    return axis(run.low, run.high, TICKS)


def x_at(value: float, axis_: Axis) -> float:
    """Drawing coordinate of a value on the first axis, in its shown unit."""
    return LEFT + (value - axis_.low) * ((RIGHT - LEFT) / (axis_.high - axis_.low))


def y_at(value: float, axis_: Axis) -> float:
    """Drawing coordinate of a value on the second axis."""
    return BOTTOM - (value - axis_.low) * ((BOTTOM - TOP) / (axis_.high - axis_.low))


def curve(xs: Sequence[float], values: Sequence[float], x: Axis, y: Axis) -> str:
    """The SVG path; it breaks where there is no value. Its twin is in `map-figure.js`."""
    parts, pen = [], "M"
    for at, value in zip(xs, values, strict=True):
        if math.isnan(value):
            pen = "M"
            continue
        parts.append(f"{pen}{px(x_at(at, x))} {px(y_at(value, y))}")
        pen = "L"
    return "".join(parts)


def bar(scale: Scale) -> list[dict[str, str]]:
    """The bands of the scale from low to high, with the numbers between them."""
    width = (RIGHT - LEFT) / scale.count
    edges, every = scale.edges, -(-scale.count // MOST_NUMBERS)
    zero = next((k for k, edge_ in enumerate(edges) if abs(edge_) < 0.5 * scale.step), 0)
    return [
        {
            "x": px(LEFT + k * width, 2),
            "width": px(width, 2),
            "fill": "" if k == scale.count else "#{:02x}{:02x}{:02x}".format(*scale.colours[k]),
            "number": fixed(edges[k], scale.decimals) if (k - zero) % every == 0 else "",
        }
        for k in range(scale.count + 1)
    ]


def value_text(value: float, run: MapRun) -> str:
    """A value of the map with three figures; what is tiny beside the largest is nought."""
    if math.isnan(value):
        return "no value"
    most = most_decimals(run)
    text = fixed(value, min(decimals_for(value or 1.0), most))
    return text if any(digit in text for digit in "123456789") else fixed(0.0, most - SMALLER)


def most_decimals(run: MapRun) -> int:
    """Decimals of the smallest values of a map."""
    return decimals_for(max(abs(run.low), abs(run.high)) or 1.0) + SMALLER


def _bar_place(scale: Scale) -> dict[str, str]:
    return {
        "bar_top": px(BAR_TOP),
        "bar_height": px(BAR_HEIGHT),
        "bar_number": px(BAR_TOP + BAR_HEIGHT + 12.0),
        "bar_foot": px(BAR_TOP + BAR_HEIGHT + 26.0),
    }


def _shown_axis(control: Control) -> Axis:
    return span(control.shown(control.low), control.shown(control.high), TICKS)


def _label(control: Control) -> str:
    return f"{control.label} in {control.unit}" if control.unit else control.label
