"""Error against time on logarithmic axes, one line per method; the exact outcome in the corner.

error ^                       lower and further left is better: less error in less time
      |   o---o---o
      |        x-----x
      |                        below the lowest decade: "0", where rounding has no place
      +-----------------> time, as a multiple of the exact outcome's
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from sim.pages.widget.numbers import SUPERSCRIPT, px

WIDTH, HEIGHT = 520.0, 380.0
LEFT, TOP, RIGHT, BOTTOM = 62.0, 14.0, 506.0, 330.0
FLOOR = 1e-17
"""Errors below are drawn here: nought has no logarithm."""
LOW_X, HIGH_X = 0.5, 1e6
HIGH_Y = 1e1

METHODS = (
    "exact",
    "exact-run",
    "euler",
    "semi-implicit",
    "verlet",
    "rk4",
    "rk4-events",
    "rk45",
    "adaptive",
)
LABELS = {
    "exact": "exact, closed form",
    "exact-run": "exact, any scene",
    "euler": "Euler",
    "semi-implicit": "semi-implicit Euler",
    "verlet": "velocity Verlet",
    "rk4": "RK4",
    "rk4-events": "RK4 + located touches",
    "rk45": "adaptive RK45 + located touches",
    "adaptive": "adaptive DOP853 + located touches",
}
MARKS = {
    "exact": "M0-6L1.6-2 6-2 2.5 1 4 6 0 3-4 6-2.5 1-6-2-1.6-2Z",
    "exact-run": "M0-5L5 0 0 5-5 0Z",
    "euler": "M-4-4H4V4H-4Z",
    "semi-implicit": "M0-5L5 4H-5Z",
    "verlet": "M0 5L5-4H-5Z",
    "rk4": "M-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0Z",
    "rk4-events": "M-5-1.5H-1.5V-5H1.5V-1.5H5V1.5H1.5V5H-1.5V1.5H-5Z",
    "rk45": "M-5-3.5H5L0 0L5 3.5H-5L0 0Z",
    "adaptive": "M-5 0L-1.5-4H1.5L5 0 1.5 4H-1.5Z",
}
"""A shape per method, so that no line is told by its colour alone."""
COLOURS = (
    "#0072b2",
    "#0072b2",
    "#c04a00",
    "#00805d",
    "#a8457f",
    "#8a5f00",
    "#2779a7",
    "#6b3f7d",
    "#555",
)
"""The set of the widget, for a figure that stands alone."""


def x_at(ratio: float) -> float:
    """Drawing coordinate of a time ratio."""
    part = math.log(max(ratio, LOW_X) / LOW_X) / math.log(HIGH_X / LOW_X)
    return LEFT + min(1.0, part) * (RIGHT - LEFT)


def y_at(error: float) -> float:
    """Drawing coordinate of an error; at and below FLOOR the same."""
    part = math.log(min(HIGH_Y, max(error, FLOOR)) / FLOOR) / math.log(HIGH_Y / FLOOR)
    return BOTTOM - part * (BOTTOM - TOP)


def power(exponent: int) -> str:
    """10⁻³; 1 and 10 as they are."""
    if exponent in (0, 1):
        return "1" if exponent == 0 else "10"
    return f"10{str(exponent).translate(SUPERSCRIPT)}"


def figure(rows: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """What the template draws; `rows` as `carts cost --json` has them."""
    series = []
    for index, method in enumerate(METHODS):
        mine = [row for row in rows if row["method"] == method and row["error_v"] is not None]
        places = [(px(x_at(r["time_ratio"])), px(y_at(r["error_v"]))) for r in mine]
        series.append(
            {
                "method": method,
                "index": index,
                "label": LABELS[method],
                "mark": MARKS[method],
                "colour": COLOURS[index],
                "line": "".join(f"{'L' if k else 'M'}{x} {y}" for k, (x, y) in enumerate(places)),
                "points": places,
            }
        )
    return {
        "width": px(WIDTH),
        "height": px(HEIGHT),
        "left": px(LEFT),
        "top": px(TOP),
        "right": px(RIGHT),
        "bottom": px(BOTTOM),
        "x_ticks": [(px(x_at(10.0**k)), power(k)) for k in range(7)],
        "y_ticks": [(px(y_at(10.0**k)), power(k) if k > -17 else "0") for k in range(-17, 2, 2)],
        "series": series,
    }


def standalone(title: str, rows: Sequence[Mapping[str, Any]]) -> str:
    """The figure as an SVG file, with its legend."""
    from html import escape

    made = figure(rows)
    seen = [one for one in made["series"] if one["points"]]
    height = HEIGHT + 18 * ((len(seen) + 1) // 2) + 8
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {px(WIDTH)} {px(height)}"'
        f' width="{px(WIDTH)}" height="{px(height)}" font-family="sans-serif" font-size="12">',
        f"<title>{escape(title)}: error against time</title>",
        f'<rect width="100%" height="100%" fill="#fff"/><rect x="{px(LEFT)}" y="{px(TOP)}"'
        f' width="{px(RIGHT - LEFT)}" height="{px(BOTTOM - TOP)}" fill="none" stroke="#55585e"/>',
    ]
    for at, text in made["x_ticks"]:
        parts.append(f'<path d="M{at} {px(TOP)}V{px(BOTTOM)}" stroke="#e4e6e9"/>')
        parts.append(f'<text x="{at}" y="{px(BOTTOM + 16)}" text-anchor="middle">{text}</text>')
    for at, text in made["y_ticks"]:
        parts.append(f'<path d="M{px(LEFT)} {at}H{px(RIGHT)}" stroke="#e4e6e9"/>')
        parts.append(f'<text x="{px(LEFT - 7)}" y="{at}" dy="4" text-anchor="end">{text}</text>')
    parts.append(
        f'<text x="{px(RIGHT)}" y="{px(BOTTOM + 34)}" text-anchor="end">'
        "time, as a multiple of the exact outcome’s</text>"
        f'<text transform="translate(14 {px((TOP + BOTTOM) / 2)}) rotate(-90)"'
        ' text-anchor="middle">largest error of a velocity in m/s</text>'
    )
    for k, one in enumerate(seen):
        parts.append(f'<path d="{one["line"]}" fill="none" stroke="{one["colour"]}"/>')
        column, row = k % 2, k // 2
        legend = (px(LEFT + 240 * column), px(HEIGHT + 8 + 18 * row))
        for x, y in (*one["points"], legend):
            parts.append(
                f'<path transform="translate({x} {y})" d="{one["mark"]}" fill="{one["colour"]}"/>'
            )
        parts.append(f'<text x="{legend[0]}" y="{legend[1]}" dx="12" dy="4">{one["label"]}</text>')
    return "".join([*parts, "</svg>\n"])
