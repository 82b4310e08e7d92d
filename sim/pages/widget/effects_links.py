"""Forces of springs and magnets at the start: bodies push or pull each other without touching.

Afterwards `sim/web/src/pushes.js` moves the arrows and names; this is its twin at t = 0.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.pages.widget.effects_forces import linked_pairs, rows_of
from sim.pages.widget.layout import Layout
from sim.pages.widget.numbers import fixed, px
from sim.pages.widget.run import Run
from sim.pages.widget.scale_of import Scales
from sim.pages.widget.shapes import PUSH, block_arrow
from sim.pages.widget.words import brief

PER_CHARACTER = 7.8  # units, of the bold names on the beam in a wide font
ROW = 19.0  # units between two rows of names
GAP = 8.0  # units between a name and the place of the force or a wall
EDGE = 6.0  # units that names keep from the edges of the picture
SMALLEST = 1e-9  # of the full scale; less is no force


def link_kind(header: Mapping[str, Any], pair: str) -> str:
    """“spring” or “magnets” where one acts between a pair that does not touch, else “”."""
    for effect in header["effects"]:
        between = effect["between"]
        if not effect["active"] or not between or effect["kind"] not in ("spring", "magnets"):
            continue
        if "-".join(between) == pair:
            return str(effect["kind"])
    return ""


def linked_pushes(
    pushes: Sequence[Mapping[str, Any]],
    header: Mapping[str, Any],
    run: Run,
    layout: Layout,
    scales: Scales,
) -> list[dict[str, Any]]:
    """The contact forces of the picture, those of linked pairs with their arrow and name."""
    shown = [dict(push) for push in pushes]
    forces = {pair: _force(pair, header, run, scales) for pair in linked_pairs(header)}
    told = [pair for pair, force in forces.items() if force]
    for k, contact in enumerate(header["contacts"]):
        pair, bodies = contact["pair"], contact["bodies"]
        if pair not in told:
            continue
        faces = [
            _edge(bodies[0], "right", header, layout),
            _edge(bodies[1], "left", header, layout),
        ]
        texts = {}
        if len(told) == 1:
            size = f"{fixed(abs(forces[pair]), scales.decimals['F'])} N"
            for through in (f" ({link_kind(header, pair)})", ""):
                labels = [
                    f"on {brief(on)} by {brief(by)}{through}: {size}"
                    for on, by in (bodies, reversed(bodies))
                ]
                places = _places(labels, bodies, layout.rows[k], sum(faces) / 2, header, layout)
                if places:
                    break
            texts = {
                side: {"label": labels[side], "x": px(x), "y": px(y), "anchor": anchor}
                for side, (x, y, anchor) in enumerate(places)
            }
        for push in (push for push in shown if push["pair"] == pair):
            side = bodies.index(push["on"])
            length = (1 if side else -1) * forces[pair] / scales.force * layout.force
            push["path"] = block_arrow(faces[side], layout.track - PUSH, length)
            push.update(texts.get(side, {}))
    return shown


def _force(pair: str, header: Mapping[str, Any], run: Run, scales: Scales) -> float:
    """N at the start, pushes the two apart; 0 where nothing acts or it cannot be drawn."""
    force = run.F.get(pair, (0.0,))[0]
    small = abs(force) < SMALLEST * scales.force
    return 0.0 if small or not scales.force or not link_kind(header, pair) else force


def _places(
    labels: Sequence[str],
    bodies: Sequence[str],
    row: float,
    x: float,
    header: Mapping[str, Any],
    layout: Layout,
) -> list[tuple[float, float, str]]:
    """Both names beside the place of the force, or one above the other; none without room."""
    left, right = (len(label) * PER_CHARACTER for label in labels)
    track = header["track"]
    low = max(EDGE, layout.origin + GAP) if track["left"] == "wall" else EDGE
    high = layout.width - EDGE
    if track["right"] == "wall":
        high = min(high, layout.at(track["length"]) - GAP)
    walled = bodies[0] == "left" or bodies[1] == "right"
    if high - low >= left + right + 2 * GAP and not walled:
        begin = min(max(x + GAP, low + left + 2 * GAP), high - right)
        end = max(low + left, min(x - GAP, begin - 2 * GAP))
        return [(end, row, "end"), (begin, row, "start")]
    longest = max(left, right)
    if layout.beam < (2 + rows_of(layout.slots)) * ROW or high - low < longest:
        return []
    way = 0.0 if bodies[0] == "left" else 1.0 if bodies[1] == "right" else 0.5
    start = min(max(x - way * longest, low), high - longest)
    return [(start, min(layout.rows) + side * ROW, "start") for side in (0, 1)]


def _edge(name: str, side: str, header: Mapping[str, Any], layout: Layout) -> float:
    for body in header["bodies"]:
        if body["name"] == name:
            half = body["length"] / 2
            return layout.at(body["position"] + (half if side == "right" else -half))
    return layout.at(0.0 if name == "left" else header["track"]["length"])
