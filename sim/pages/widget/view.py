"""Everything the scene template writes, gathered as plain text and numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.pages.bake import packages_of
from sim.pages.language import heard, tr
from sim.pages.widget import graph as g
from sim.pages.widget.contacts import touches
from sim.pages.widget.effects_controls import effect_cards
from sim.pages.widget.effects_links import linked_pushes
from sim.pages.widget.effects_view import effects_view
from sim.pages.widget.effects_words import acting_sentences, push_marks, size_name
from sim.pages.widget.exits import exits
from sim.pages.widget.layout import Layout
from sim.pages.widget.markers import MARKERS
from sim.pages.widget.numbers import fixed, px, short, speed_unit
from sim.pages.widget.panel import cards, plain
from sim.pages.widget.run import Run
from sim.pages.widget.scale_of import Scales
from sim.pages.widget.scales import nice_above, span
from sim.pages.widget.series import series_of
from sim.pages.widget.stage import stage_view
from sim.pages.widget.tables import table_rows, table_times
from sim.pages.widget.views import views_view
from sim.pages.widget.words import (
    QUANTITIES,
    body,
    brief,
    event_sentence,
    exit_sentence,
    force_on,
    graph_note,
    laws_of,
    model_sentences,
    motion,
)

FORCE_QUANTITIES = ("F", "a")  # left out where the lesson lets students find the force
LONG = 60.0  # s; a longer run opens faster
MOST_EVENTS = 60  # in the list; a run with more says how many more


def scene_view(
    fence: Any,
    header: Mapping[str, Any],
    run: Run,
    scales: Scales,
    layouts: Sequence[Layout],
    *,
    told: bool,
) -> dict[str, Any]:
    """The template's variables. `told` False: a prediction comes first."""
    camera, forces = fence.view_speed, fence.forces == "shown"
    until = float(header["until"])
    contacts = touches(header["events"], until)
    shown = [q for q in fence.show if forces or q not in FORCE_QUANTITIES]
    stages = []
    for layout in layouts:
        stage = stage_view(header, scales, layout, camera=camera, forces=forces)
        if told:
            stage["pushes"] = linked_pushes(stage["pushes"], header, run, layout, scales)
        acting = effects_view(header, run, layout, scales.force, told=told, forces=forces)
        stages.append({**stage, "effects": acting})
    return {
        "id": fence.id,
        "title": header.get("title") or tr("Carts on an air track"),
        "packages": " ".join(sorted({*fence.packages, *packages_of(header)})),
        "warnings": [heard(warning["message"]) for warning in header["warnings"]],
        "stages": stages,
        "torn": stages[0]["torn"],
        "may_tear": scales.may_tear,
        "camera_text": _camera_text(camera),
        "acting": acting_sentences(header, numbers=told and forces),
        "description": _description(header, scales, camera),
        "time": _timeline(header, contacts, until, told=told),
        "speed": _opening_speed(until),
        "slow": fence.slow != "never" and any(c["stiffness"] for c in header["contacts"]),
        "predict_view": _predict_view(fence, header, scales),
        "cards": cards(
            header, fence.controls, scales, run, camera=camera, forces=forces, told=told
        ),
        "effect_cards": effect_cards(fence, header),
        "has_controls": bool(fence.controls or fence.switches),
        "presets": list(fence.presets),
        "windows": [
            tr(
                "{names} at {time} s",
                names=f"{brief(w.bodies[0])}–{brief(w.bodies[1])}",
                time=fixed(w.start, 2),
            )
            for w in contacts
        ],
        "graphs": [graph_view(q, header, run, scales, camera, told=told) for q in shown],
        "views_view": views_view(header, scales, fence.opened, forces=forces, told=told),
        "events": _story(header, run, scales, layouts[0], camera, forces) if told else [],
        "model": model_sentences(header, told=told),
    }


def graph_view(
    quantity: str,
    header: Mapping[str, Any],
    run: Run,
    scales: Scales,
    camera: float,
    *,
    told: bool,
) -> dict[str, Any]:
    """One graph with its cursor at t = 0 and its table; empty axes before a prediction."""
    title, symbol, unit = QUANTITIES[quantity]
    until = float(header["until"])
    per, speed = speed_unit(scales.velocity)
    unit = speed if quantity == "v" else unit
    seen = tr("seen from the camera, ") if camera and quantity in ("x", "v") else ""
    curves = series_of(quantity, header, run, camera, per=per) if told else []
    plane = g.plane_for(curves, until, scales.reach[quantity])
    scale = max((abs(v) for curve in curves for v in curve.values), default=1.0)
    times = table_times(until, header["events"]) if told else []
    return {
        "quantity": quantity,
        "title": tr(title) if quantity != "F" else size_name(header),
        "seen": seen,
        "symbol": symbol if quantity != "F" else "|F|",
        "unit": unit,
        "width": int(g.WIDTH),
        "height": int(g.HEIGHT),
        "left": int(g.LEFT),
        "right": int(g.RIGHT),
        "top": int(g.TOP),
        "bottom": int(g.BOTTOM),
        "times": g.time_marks(plane) if told else [],
        "marks": g.value_marks(plane) if told else [],
        "cursor": px(plane.x(0.0)),
        "curves": [
            {
                "label": curve.label,
                "style": curve.style,
                "over": curve.over,
                "marker": MARKERS[curve.style],
                "path": g.path(curve, run.t, plane),
                "dot": px(plane.y(curve.values[0])),
            }
            for curve in curves
        ],
        "note": graph_note(quantity, header["events"], len(curves)) if told else "",
        "rows": table_rows(curves, run.t, times, scales.decimals, quantity, scale),
    }


def _timeline(
    header: Mapping[str, Any], contacts: Sequence[Any], until: float, *, told: bool
) -> dict[str, Any]:
    axis = span(0.0, until, 6)
    pushes = push_marks(header, forces=False) if told else []
    return {
        "until": plain(until),
        "contacts": [
            {"x": px(100 * w.start / until, 3), "width": px(100 * (w.end - w.start) / until, 3)}
            for w in contacts
        ],
        "events": [
            {"x": px(100 * e["t"] / until, 3), "kind": e["kind"]}
            for e in header["events"][:MOST_EVENTS]
            if e["kind"] != "end"
        ]
        + [{"x": px(100 * t / until, 3), "kind": "push"} for t, _ in pushes],
        "numbers": [
            {"x": px(100 * t / until, 3), "label": fixed(t, axis.decimals)} for t in axis.ticks()
        ],
    }


def _opening_speed(until: float) -> int:
    """The speed at which a long run is seen in 6 to 60 s; at most a hundredfold."""
    if until <= LONG:
        return 1
    return 100 if until >= 10 * LONG else 10


def _story(
    header: Mapping[str, Any],
    run: Run,
    scales: Scales,
    layout: Layout,
    camera: float,
    forces: bool,
) -> list[dict[str, str]]:
    """What happens, in order: the events of the run, and carts that leave the picture."""
    decimals, scale, laws = scales.decimals, scales.velocity, laws_of(header["contacts"])
    told = [
        (
            float(event["t"]),
            event_sentence(
                event, decimals=decimals, scale=scale, camera=camera, forces=forces, laws=laws
            ),
        )
        for event in header["events"]
    ]
    told += [
        (gone.t, exit_sentence(gone.name, gone.side, gone.velocity, decimals["v"], scale))
        for gone in exits(header, run, layout.low, layout.high, camera)
    ]
    told = push_marks(header, forces=forces) + told
    told.sort(key=lambda entry: entry[0])
    return [
        {"t": plain(t), "time": fixed(t, decimals["t"]), "sentence": sentence}
        for t, sentence in told[:MOST_EVENTS]
    ]


def _description(header: Mapping[str, Any], scales: Scales, camera: float) -> str:
    parts = []
    for b in header["bodies"]:
        told = {"cart": b["name"], "mass": short(b["mass"]), "place": fixed(b["position"], 2)}
        if b["velocity"] == camera:
            parts.append(tr("{cart}, {mass} kg, is at {place} m and is at rest.", **told))
            continue
        seen = motion(b["velocity"] - camera, scales.decimals["v"], scales.velocity)
        sentence = tr(
            "{cart}, {mass} kg, is at {place} m and moves at {velocity}.", **told, velocity=seen
        )
        parts.append(sentence)
    return tr("At the start: {carts}", carts=" ".join(parts))


def _camera_text(camera: float) -> str:
    if not camera:
        return ""
    return tr(
        "Seen from a camera that moves at {velocity} along the track. "
        "Positions and velocities are measured from the camera.",
        velocity=motion(camera, 2, abs(camera)),
    )


def _predict_view(fence: Any, header: Mapping[str, Any], scales: Scales) -> dict[str, Any] | None:
    predict = fence.predict
    if predict is None:
        return None
    index = {b["name"]: i for i, b in enumerate(header["bodies"])}
    full = scales.force or 10.0
    arrows = [
        {
            "pair": f"{left}-{right}",
            "on": on,
            "force": force_on(body(on), body(by)),
            "style": f"b{index[on] % 8}" if on in index else "wall",
        }
        for left, right in predict.pairs
        for on, by in ((left, right), (right, left))
    ]
    return {
        "kind": predict.kind,
        "ask": heard(predict.ask),
        "talk": predict.talk,
        "arrows": arrows,
        "full": plain(full),
        "step": plain(nice_above(full / 100)),
        "style": f"b{index[predict.cart] % 8}" if predict.cart in index else "b0",
        "options": predict.options,
    }
