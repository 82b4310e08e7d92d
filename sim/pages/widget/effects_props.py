"""What an effect looks like: coil, magnets, hand, exploder, rough track, tilt.

Twin: `sim/web/src/effects-props.js`. Pieces are elements of the picture: a key that names the piece
for the life of the page, a class, and either a path `d` or a text with its place.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

from sim.pages.language import tr
from sim.pages.widget.effects_forces import acts_at
from sim.pages.widget.effects_words import slope_text
from sim.pages.widget.layout import Layout
from sim.pages.widget.numbers import px
from sim.pages.widget.scale_of import body_width
from sim.pages.widget.shapes import PUSH

Face = Callable[[str, str], float]  # drawing coordinate of a side of a body
Piece = dict[str, str]

TURNS = 9  # of a coil
LEAD = 5.0  # units of straight wire at each end of a coil
COIL = 7.0  # half its height
TOOTH = 4.0  # units of the rough track
POLE = 12.0  # units, width of a pole of a magnet
POLES = (("N", "carts-north"), ("S", "carts-south"))  # the second only where there is room
STEEPEST = 22.0  # units, height of the wedge
WEDGE = {"wide": 120.0, "narrow": 90.0}  # units, length of the wedge


def props(
    header: Mapping[str, Any], layout: Layout, t: float, face: Face, centre: Callable[[str], float]
) -> list[Piece]:
    """The pieces of all effects that are on, at t (s)."""
    pieces: list[Piece] = []
    for effect in header["effects"]:
        if not effect["active"]:
            continue
        key, y = f"{effect['kind']} {effect['index']}", layout.track
        if effect["kind"] == "friction":
            pieces += _rough(effect, header, layout, key, face, centre)
        elif effect["kind"] == "incline":
            pieces += _tilt(effect, layout, key)
        elif effect["kind"] == "push" and acts_at(effect, t):
            pieces.append(_hand(effect, header, layout, key, centre))
        elif effect["kind"] == "spring":
            a, b = effect["between"]
            pieces += _coil(effect, layout, key, face(a, "right"), face(b, "left"))
        elif effect["kind"] == "magnets":
            a, b = effect["between"]
            poles = POLES if layout.kind == "wide" else POLES[:1]
            pieces += _magnet(f"{key} {a}", face(a, "right"), y, -1, poles)
            pieces += _magnet(f"{key} {b}", face(b, "left"), y, 1, poles)
        elif effect["kind"] == "release" and t < effect["numbers"].get("at", 0.0):
            a, b = effect["between"]
            pieces += _exploder(key, (face(a, "right") + face(b, "left")) / 2, y)
    return pieces


def coil(start: float, end: float, y: float, turns: int = TURNS, high: float = COIL) -> str:
    """Path of a coil: a wire of always the same turns, straight at its ends."""
    span = max(0.0, end - start)
    lead = min(LEAD, span / 4)
    step = (span - 2 * lead) / turns
    d = f"M{px(start)} {px(y)}L{px(start + lead)} {px(y)}"
    for k in range(turns):
        d += f"L{px(start + lead + (k + 0.5) * step)} {px(y - high if k % 2 == 0 else y + high)}"
    return d + f"L{px(start + span - lead)} {px(y)}L{px(start + span)} {px(y)}"


def _coil(
    effect: Mapping[str, Any], layout: Layout, key: str, start: float, end: float
) -> list[Piece]:
    """The coil, and a measure of its natural length above it: shorter or longer than the coil."""
    length = effect["numbers"]["length"] * layout.scale
    a, b = effect["between"]
    middle = (start + end) / 2
    low = start if a == "left" else end - length if b == "right" else middle - length / 2
    y = layout.track - PUSH - COIL - 5
    return [
        {"key": key, "cls": "carts-coil", "d": coil(start, end, layout.track - PUSH)},
        {
            "key": f"{key} natural",
            "cls": "carts-natural",
            "d": f"M{px(low)} {px(y - 3)}v6M{px(low)} {px(y)}h{px(length)}m0 -3v6",
        },
    ]


def _magnet(
    key: str, x: float, y: float, way: int, poles: tuple[tuple[str, str], ...]
) -> list[Piece]:
    """The poles on top of a bumper, north at the facing edge; `way`: into the body."""
    top = y - 40
    pieces = []
    for k, (pole, cls) in enumerate(poles):
        start = x + way * k * POLE
        middle = start + way * POLE / 2
        d = f"M{px(start)} {px(top)}h{px(way * POLE)}v16h{px(-way * POLE)}Z"
        pieces.append({"key": f"{key} {pole}", "cls": cls, "d": d})
        text = {"key": f"{key} {pole} letter", "cls": "carts-pole", "text": pole}
        pieces.append({**text, "x": px(middle), "y": px(top + 12), "anchor": "middle"})
    return pieces


def _hand(
    effect: Mapping[str, Any],
    header: Mapping[str, Any],
    layout: Layout,
    key: str,
    centre: Callable[[str], float],
) -> Piece:
    """A flat hand at the end of an arm, at the box that it pushes, above the bumper."""
    name, y = effect["carts"][0], layout.track
    way = 1 if effect["numbers"]["force"] >= 0 else -1
    body = next(body for body in header["bodies"] if body["name"] == name)
    x = centre(name) - way * (body_width(body) * layout.scale / 2 + 3)
    d = f"M{px(x)} {px(y - 38)}v14M{px(x)} {px(y - 31)}h{px(-way * 26)}"
    return {"key": key, "cls": "carts-hand", "d": d}


def _exploder(key: str, x: float, y: float) -> list[Piece]:
    """A coil squeezed between two plates, and the latch that holds them."""
    low = y - 28
    return [
        {"key": key, "cls": "carts-coil", "d": coil(x - 9, x + 9, low, 7, 4)},
        {
            "key": f"{key} latch",
            "cls": "carts-latch",
            "d": f"M{px(x - 10)} {px(low + 7)}v-15h20v15",
        },
    ]


def _rough(
    effect: Mapping[str, Any],
    header: Mapping[str, Any],
    layout: Layout,
    key: str,
    face: Face,
    centre: Callable[[str], float],
) -> list[Piece]:
    """Teeth in the track: all along it, or under the carts that friction acts on."""
    if len(effect["carts"]) < len(header["bodies"]):
        lengths = {body["name"]: body["length"] * layout.scale for body in header["bodies"]}
        return [
            {
                "key": f"{key} {name}",
                "cls": "carts-rough",
                "d": _teeth(centre(name) - lengths[name] / 2, lengths[name], layout.track),
            }
            for name in effect["carts"]
        ]
    track = header["track"]
    start = face("left", "right") if track["left"] == "wall" else -layout.width
    end = face("right", "left") if track["right"] == "wall" else 2 * layout.width
    first = max(start, -2 * TOOTH + (start % (2 * TOOTH)))  # moves with the track under a camera
    return [
        {
            "key": key,
            "cls": "carts-rough",
            "d": _teeth(first, min(end, layout.width) - first, layout.track),
        }
    ]


def _teeth(x: float, length: float, y: float) -> str:
    """Path of so many whole teeth as fit."""
    count = max(0, math.floor(length / (2 * TOOTH)))
    tooth = f"l{px(TOOTH)} {px(TOOTH)}l{px(TOOTH)} {px(-TOOTH)}"
    return f"M{px(x)} {px(y)}" + tooth * count


def _tilt(effect: Mapping[str, Any], layout: Layout, key: str) -> list[Piece]:
    """A wedge with the true angle, downhill as the track is, and the angle in words."""
    angle = effect["numbers"]["angle"]
    slope = abs(math.tan(angle))
    length = min(WEDGE[layout.kind], STEEPEST / slope) if slope else WEDGE[layout.kind]
    x, y, rise = 12.0, layout.tilt, length * slope
    tall, flat = (x, x + length) if angle > 0 else (x + length, x)
    arrow = {1: " →", -1: "← ", 0: ""}[(angle > 0) - (angle < 0)]
    words = tr("the track is level: 0°")
    if angle:
        words = tr("track tilted {slope}", slope=slope_text(angle))
    text = words + arrow if angle > 0 else arrow + words
    return [
        {
            "key": key,
            "cls": "carts-wedge",
            "d": f"M{px(tall)} {px(y)}V{px(y - rise)}L{px(flat)} {px(y)}Z",
        },
        {
            "key": f"{key} words",
            "cls": "carts-tilt",
            "text": text,
            "x": px(x + length + 10),
            "y": px(y),
            "anchor": "start",
        },
    ]
