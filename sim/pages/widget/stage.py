"""The world view at t = 0: everything the stage template writes, as text.

What moves has its twin in `sim/web/src/stage.js`, which takes over the same elements.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sim.pages.language import tr
from sim.pages.widget import shapes
from sim.pages.widget.effects_forces import linked_pairs
from sim.pages.widget.layout import Layout
from sim.pages.widget.numbers import fixed, px, short, speed_unit
from sim.pages.widget.scale_of import Scales
from sim.pages.widget.scales import Axis, nice_above
from sim.pages.widget.words import brief

LABEL_ROOM = {"wide": 46.0, "narrow": 40.0}  # units between two numbers on the ruler
BREAK = "M-14 -56l7 -6l7 6l7 -6l7 6M-14 -49l7 -6l7 6l7 -6l7 6"  # across a box too tall to draw
MOST_NUMBERS = 150  # on the ruler of a long moving-camera run


def stage_view(
    header: Mapping[str, Any],
    scales: Scales,
    layout: Layout,
    *,
    camera: float,
    forces: bool,
) -> dict[str, Any]:
    """The picture at the start."""
    boxes = [
        shapes.box(body, scales, layout, layout.stagger * (i % layout.ranks))
        for i, body in enumerate(header["bodies"])
    ]
    tallest = max(box.height for box in boxes)
    return {
        "layout": layout,
        "px": {name: px(getattr(layout, name)) for name in ("width", "height", "track", "beam")},
        "ground": _ground(header, layout, camera),
        "wall_y": px(layout.track - max(scales.tallest, 64.0)),
        "wall_height": px(max(scales.tallest, 64.0) + layout.beam),
        "rule_y": px(layout.track + layout.beam),
        "number_y": px(layout.track + layout.beam + 21),
        "break_path": BREAK,
        "carts": [
            _cart(body, i, box, shapes.lane(i, tallest, layout), scales, layout, camera)
            for i, (body, box) in enumerate(zip(header["bodies"], boxes, strict=True))
        ],
        "torn": any(box.cut for box in boxes),
        "pushes": _pushes(header, layout) if forces else [],
        "legend": _legend(scales, layout, camera, forces),
    }


def _cart(
    body: Mapping[str, Any],
    i: int,
    box: shapes.Box,
    y: float,
    scales: Scales,
    layout: Layout,
    camera: float,
) -> dict[str, Any]:
    x = layout.at(body["position"])
    half = body["length"] * layout.scale / 2
    edge = -box.x
    seen = body["velocity"] - camera
    exact = shapes.arrow_length(seen, scales.velocity, layout.velocity)
    length = shapes.kept_inside(x, exact, layout.width)
    cut = "" if length == exact else tr(", arrow cut")
    per, unit = speed_unit(scales.velocity)
    text_x, anchor = velocity_text(x, length, layout.width)
    return {
        "name": body["name"],
        "style": f"b{i % 8}",
        "transform": f"translate({px(x)} {px(layout.track)})",
        "box": {
            "x": px(box.x),
            "y": px(-box.height),
            "width": px(box.width),
            "height": px(box.height),
        },
        "cut": box.cut,
        "name_y": px(0.0 if box.name_y is None else box.name_y),
        "named": box.name_y is not None,
        "label": box.label,
        "label_y": px(box.label_y),
        "springs": [shapes.spring(-edge, -half), shapes.spring(edge, half)],
        "faces": [px(-half), px(half)],
        "velocity": {
            "path": shapes.line_arrow(x, y, length),
            "leader": f"M{px(x)} {px(y)}V{px(layout.track + shapes.label_top(box))}",
            "text": f"{fixed(seen / per, scales.decimals['v'])} {unit}{cut}",
            "x": px(text_x),
            "y": px(y + 4),
            "anchor": anchor,
        },
    }


def velocity_text(x: float, length: float, width: float) -> tuple[float, str]:
    """Where the velocity is written: behind the arrow's tail, or beyond its head at an edge."""
    room = 62.0
    if length >= 0:
        if x > room:
            return x - 8, "end"
        return x + length + 8, "start"
    if x < width - room:
        return x + 8, "start"
    return x + length - 8, "end"


def _pushes(header: Mapping[str, Any], layout: Layout) -> list[dict[str, Any]]:
    """One entry per contact force: at t = 0 a dot on the bumper face of the body it acts on."""
    index = {body["name"]: i for i, body in enumerate(header["bodies"])}
    faces = {
        body["name"]: (
            layout.at(body["position"] - body["length"] / 2),
            layout.at(body["position"] + body["length"] / 2),
        )
        for body in header["bodies"]
    }
    length = header["track"]["length"] or 0.0
    faces["left"] = (0.0, layout.at(0.0))
    faces["right"] = (layout.at(length), 0.0)
    pushes = []
    linked = linked_pairs(header)
    for contact in header["contacts"]:
        if not contact["stiffness"] and contact["pair"] not in linked:
            continue
        left, right = contact["bodies"]
        for on, by, face in ((left, right, faces[left][1]), (right, left, faces[right][0])):
            pushes.append(
                {
                    "pair": contact["pair"],
                    "on": on,
                    "style": f"b{index[on] % 8}" if on in index else "wall",
                    "label": tr("on {on} by {by}", on=brief(on), by=brief(by)),
                    "path": shapes.dot(face, layout.track - shapes.PUSH),
                }
            )
    return pushes


def _ground(header: Mapping[str, Any], layout: Layout, camera: float) -> dict[str, Any]:
    """Track, walls and ruler; they move to the left under a camera that moves to the right."""
    travel = camera * header["until"]
    low, high = layout.low + min(0.0, travel), layout.high + max(0.0, travel)
    track = header["track"]
    left_wall, right_wall = track["left"] == "wall", track["right"] == "wall"
    step = nice_above(LABEL_ROOM[layout.kind] / layout.scale)
    while (high - low) / step > MOST_NUMBERS:
        step = nice_above(step * 1.5)
    first = 0.0 if left_wall else low
    last = track["length"] if right_wall else high
    numbers = Axis(first, last, step)
    fine = Axis(first, last, step / (4 if short(step).strip("0.")[:1] == "2" else 5))
    return {
        "start": px(layout.at(first) if left_wall else layout.at(low) - 60),
        "end": px(layout.at(last) if right_wall else layout.at(high) + 60),
        "width": px(
            (layout.at(last) if right_wall else layout.at(high) + 60)
            - (layout.at(first) if left_wall else layout.at(low) - 60)
        ),
        "left_wall": px(layout.at(0.0)) if left_wall else None,
        "right_wall": px(layout.at(track["length"])) if right_wall else None,
        "numbers": [
            {"x": px(layout.at(x)), "label": fixed(x, numbers.decimals)} for x in numbers.ticks()
        ],
        "fine": "".join(
            f"M{px(layout.at(x))} {px(layout.track + layout.beam)}v4" for x in fine.ticks()
        ),
        "moving": bool(camera),
    }


def _legend(scales: Scales, layout: Layout, camera: float, forces: bool) -> dict[str, Any]:
    """The length of a force and of a velocity arrow, written out."""
    y = layout.height - 10
    x = 12.0
    legend: dict[str, Any] = {"y": px(y + 4)}
    if forces and scales.force:
        legend["force"] = shapes.block_arrow(x, y, layout.force)
        legend["force_x"] = px(x + layout.force + 6)
        legend["force_text"] = f"{short(scales.force)} N"
        x += layout.force + 6 + 44
    per, unit = speed_unit(scales.velocity)
    legend["velocity"] = shapes.line_arrow(x, y, layout.velocity)
    legend["velocity_x"] = px(x + layout.velocity + 6)
    legend["velocity_text"] = f"{short(scales.velocity / per)} {unit}"
    if layout.kind == "wide":  # on a phone it stands below the picture
        legend["torn_x"] = px(x + layout.velocity + 6 + 60)
    legend["right_x"] = px(layout.width - 12)
    if camera:
        legend["right_text"] = tr("position on the track in m")
    elif layout.kind == "wide":
        legend["right_text"] = tr("position x in m, + is to the right")
    else:
        legend["right_text"] = tr("x in m, + right")
    return legend
