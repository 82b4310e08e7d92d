"""The picture of what acts at the start: props and force arrows. Twin: `sim/web/src/effects.js`."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from sim.pages.language import tr
from sim.pages.widget.effects_forces import FEW, forces_at, labels
from sim.pages.widget.effects_props import Piece, props
from sim.pages.widget.layout import Layout
from sim.pages.widget.numbers import px
from sim.pages.widget.run import Run
from sim.pages.widget.shapes import block_arrow

PER_CHARACTER = 7.2  # units, of the bold names
SLIVER = 1.5  # units; a shorter arrow cannot be seen as one and is drawn as a dot
GAP = 8.0  # units between an arrow and its name
BEHIND = ("carts-rough", "carts-wedge", "carts-tilt", "carts-hand")  # the carts are in front of it


def effects_view(
    header: Mapping[str, Any], run: Run, layout: Layout, force: float, *, told: bool, forces: bool
) -> dict[str, list[Piece]]:
    """Pieces at t = 0, behind the carts and in front of them. `force` in N is the full scale."""
    bodies = {body["name"]: body for body in header["bodies"]}

    def face(name: str, side: str) -> float:
        if name not in bodies:
            return layout.at(0.0 if name == "left" else header["track"]["length"])
        half = bodies[name]["length"] / 2
        return layout.at(bodies[name]["position"] + (-half if side == "left" else half))

    def centre(name: str) -> float:
        return layout.at(float(bodies[name]["position"]))

    pieces = props(header, layout, 0.0, face, centre)
    if told and forces:
        pieces += arrows(header, run, layout, force, 0.0, centre)
    return {
        "behind": [piece for piece in pieces if piece["cls"] in BEHIND],
        "front": [piece for piece in pieces if piece["cls"] not in BEHIND],
    }


def arrows(
    header: Mapping[str, Any],
    run: Run,
    layout: Layout,
    full: float,
    t: float,
    centre: Callable[[str], float],
) -> list[Piece]:
    """An arrow for each force on one cart, in its row under the track, with its name and size."""
    style = {body["name"]: f"carts-b{i % 8}" for i, body in enumerate(header["bodies"])}
    named = len(header["bodies"]) <= FEW
    pieces: list[Piece] = []
    lowest: dict[str, float] = {}
    for force in forces_at(header, run, t):
        key = f"{force['kind']} {force['on']}"
        x, y = centre(force["on"]), layout.slots[key]
        length = force["value"] / full * layout.force if full else 0.0
        length = 0.0 if abs(length) < SLIVER else length
        cls = style[force["on"]]
        lowest[force["on"]] = max(y, lowest.get(force["on"], y))
        pieces.append(
            {
                "key": f"arrow {key}",
                "cls": f"carts-block-arrow carts-acts {cls}",
                "d": block_arrow(x, y, length),
            }
        )
        if named:
            text = next(
                (t for t in labels(force) if fits(x, length, t, layout.width)), labels(force)[-1]
            )
            at, anchor = beside(x, length, len(text) * PER_CHARACTER, layout.width)
            name = {"key": f"name {key}", "cls": f"carts-acts-name {cls}", "text": text}
            pieces.append({**name, "x": px(at), "y": px(y + 4), "anchor": anchor})
        elif not any(piece["key"] == f"row {force['kind']}" for piece in pieces):
            row = {"key": f"row {force['kind']}", "cls": "carts-acts-row", "x": "6"}
            pieces.append(
                {**row, "text": tr("by {by}", by=force["by"]), "y": px(y + 4), "anchor": "start"}
            )
    leaders = [
        {
            "key": f"leader {name}",
            "cls": f"carts-leader carts-acts {style[name]}",
            "d": f"M{px(centre(name))} {px(layout.track)}V{px(y)}",
        }
        for name, y in lowest.items()
    ]
    return leaders + pieces


def fits(x: float, length: float, text: str, picture: float) -> bool:
    """Whether a name has room on one side of its arrow."""
    needed = len(text) * PER_CHARACTER + GAP + 4
    return min(x, x + length) >= needed or max(x, x + length) <= picture - needed


def beside(x: float, length: float, width: float, picture: float) -> tuple[float, str]:
    """Where the name of an arrow from x stands: behind its tail, else beyond its head."""
    left, right = min(x, x + length) - GAP, max(x, x + length) + GAP
    to_left, to_right = left - width >= 4, right + width <= picture - 4
    if to_left and (length >= 0 or not to_right):
        return left, "end"
    if to_right:
        return right, "start"
    return (4.0, "start") if left > picture - right else (picture - 4, "end")
