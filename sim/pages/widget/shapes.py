"""Shapes of the world view as SVG attributes. Its twin is `sim/web/src/shapes.js`.

A force arrow is a filled block, a velocity arrow a thin line with an open head. Both are exactly
as long as the scale says; zero is a dot.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sim.pages.widget.layout import ABOVE, LANE, Layout
from sim.pages.widget.numbers import px, short
from sim.pages.widget.scale_of import REFERENCE_HEIGHT, TALLEST, Scales, body_width

DOT = 2.5  # radius of a zero force
RING = 1.0  # radius of a zero velocity, drawn as a line
SHORTEST = 0.5  # units; a shorter arrow is zero to the eye and is drawn as a dot
FASTEST = 2.2  # full lengths; a longer velocity arrow is cut here, and its text says so
EDGE = 5.0  # units that a velocity arrow keeps from the edges of the picture
LINE = 12.0  # height of the text above a box
NAMED = 34.0  # units; a box at least this tall carries its name
SPRING = (2.0, 10.0)  # heights of the spring above the track
PUSH = 15.5  # height of the force arrow above the track
FACE = 22.0  # height of a bumper face


@dataclass(frozen=True, slots=True)
class Box:
    """A cart's box relative to its centre on the track."""

    x: float
    width: float
    height: float
    cut: bool  # taller than the picture can show
    name_y: float | None
    label: str
    label_y: float


def box(body: Mapping[str, Any], scales: Scales, layout: Layout, lift: float) -> Box:
    """The box with an area proportional to the mass, up to four reference heights; or all alike."""
    width = body_width(body)
    height = REFERENCE_HEIGHT
    if not scales.alike:
        height *= body["mass"] / width / scales.per_height
    cut = height > TALLEST * REFERENCE_HEIGHT * (1 + 1e-9)
    height = min(height, TALLEST * REFERENCE_HEIGHT)
    named = height >= NAMED
    mass = f"{short(body['mass'])} kg"
    return Box(
        x=-width * layout.scale / 2,
        width=width * layout.scale,
        height=height,
        cut=cut,
        name_y=-(height + FACE) / 2 + 4.5 if named else None,
        label=mass if named else f"{body['name']}: {mass}",
        label_y=-height - 5 - lift if named else -max(height, FACE) - 5 - lift,
    )


def lane(i: int, tallest: float, layout: Layout) -> float:
    """Height of the velocity arrow of cart i above carts of which the tallest box is `tallest`."""
    above = max(tallest, FACE) + layout.stagger * (layout.ranks - 1) + ABOVE
    return layout.track - above - LANE * (layout.lanes - 1 - i % layout.lanes)


def spring(start: float, end: float) -> str:
    """Path of a spring from the box to the bumper face, both relative to the cart's centre."""
    low, high = SPRING
    turns = 4
    step = (end - start) / turns
    points = [f"M{px(start)} {px(-(low + high) / 2)}"]
    for k in range(turns):
        y = -high if k % 2 == 0 else -low
        points.append(f"L{px(start + (k + 0.5) * step)} {px(y)}")
    points.append(f"L{px(end)} {px(-(low + high) / 2)}")
    return "".join(points)


def block_arrow(x: float, y: float, length: float) -> str:
    """Path of a force arrow: tail at (x, y), pointing along the sign of `length`."""
    if abs(length) < SHORTEST:
        return dot(x, y)
    way = 1 if length > 0 else -1
    tip = x + length
    head = way * min(9.0, abs(length))
    neck = tip - head
    return (
        f"M{px(x)} {px(y - 3)}L{px(neck)} {px(y - 3)}L{px(neck)} {px(y - 6.5)}L{px(tip)} {px(y)}"
        f"L{px(neck)} {px(y + 6.5)}L{px(neck)} {px(y + 3)}L{px(x)} {px(y + 3)}Z"
    )


def line_arrow(x: float, y: float, length: float) -> str:
    """Path of a velocity arrow: a line with an open head."""
    if abs(length) < SHORTEST:
        return dot(x, y, RING)
    way = 1 if length > 0 else -1
    tip = x + length
    back = tip - way * min(7.0, abs(length))
    return (
        f"M{px(x)} {px(y)}L{px(tip)} {px(y)}M{px(back)} {px(y - 4.5)}L{px(tip)} {px(y)}"
        f"L{px(back)} {px(y + 4.5)}"
    )


def dot(x: float, y: float, radius: float = DOT) -> str:
    """Path of a zero arrow."""
    r, d = px(radius), px(2 * radius)
    return f"M{px(x - radius)} {px(y)}a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0 -{d} 0Z"


def arrow_length(value: float, full: float, length: float) -> float:
    """Length of an arrow for `value` on a scale; cut where it would leave the picture."""
    exact = value / full * length if full else 0.0
    return max(-FASTEST * length, min(FASTEST * length, exact))


def kept_inside(x: float, length: float, width: float) -> float:
    """Length of an arrow from x whose head stays in the picture; from outside it is as it was."""
    if EDGE < x < width - EDGE:
        if x + length > width - EDGE:
            return width - EDGE - x
        if x + length < EDGE:
            return EDGE - x
    return length


def label_top(box: Box) -> float:
    """Top of the text above a box, relative to the track."""
    return box.label_y - LINE
