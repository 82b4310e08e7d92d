"""From a fence and its run to the complete `<carts-scene>` element."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from jinja2 import Template
from markupsafe import Markup

from sim.pages.language import heard
from sim.pages.templates import script_json, templates
from sim.pages.widget.layout import lay_out
from sim.pages.widget.run import Run, from_wire
from sim.pages.widget.scale_of import read_scales
from sim.pages.widget.view import scene_view

# Significant digits of the baked numbers: far below what can be seen, and few enough for 60 kB
# of HTML per scene. Long runs get fewer.
DIGITS, FEWER_DIGITS, LONG = 11, 7, 1500
# Parts of a header that tell of the run; a page without a prediction may know them at once.
TELLING = ("final", "energy", "momentum", "work", "evaluations", "outcome")


def render(fence: Any, header: Mapping[str, Any], numbers: Sequence[float]) -> str:
    """HTML of the element: still picture, panel, graphs, tables and the baked run as JSON.

    `header` and `numbers` are a good answer of `sim.bridge.protocol.answer`. Where the fence asks
    for a prediction, nothing of the run but its start state gets into the HTML. Where it hides the
    forces, a second inside that shows them waits in a template until the reader has found one.
    """
    view, baked = _view(fence, header, numbers)
    view |= {"baked": script_json(baked), "shown": None, "found": False}
    view["find"] = fence.forces == "hidden" and any(c["stiffness"] for c in header["contacts"])
    if view["find"]:
        open_fence = replace(fence, forces="shown", show=(*fence.show, "F"))
        inside, all_baked = _view(open_fence, header, numbers)
        differs = {key: value for key, value in all_baked.items() if baked.get(key) != value}
        html = _template("inside").render(inside | {"find": False, "found": True})
        view["shown"] = {"inside": Markup(html), "baked": str(script_json(differs))}
    return str(_template("scene").render(view))


def _view(
    fence: Any, header: Mapping[str, Any], numbers: Sequence[float]
) -> tuple[dict[str, Any], dict[str, Any]]:
    """What the template writes out, and what the page's scripts get to know."""
    told = fence.predict is None
    camera = fence.view_speed
    digits = DIGITS if len(numbers) <= LONG else FEWER_DIGITS
    run = _rounded(from_wire(header, numbers), digits)
    if not told:
        run, header = run.start(), _untold(header)
    scales = read_scales(header, fence.controls, run if told else None, camera)
    scales = replace(scales, alike=fence.boxes == "alike")
    forces = fence.forces == "shown"
    layouts = [
        lay_out(header, scales, kind=kind, camera=camera, forces=forces)
        for kind in ("wide", "narrow")
    ]
    baked = {
        **header,
        "numbers": run.as_dict(digits),
        "fence": _fence_facts(fence),
        "view": {
            "perHeight": scales.per_height,
            "alike": scales.alike,
            "tallest": scales.tallest,
            "force": scales.force,
            "velocity": scales.velocity,
            "decimals": scales.decimals,
            "reach": {q: reach.as_list() for q, reach in scales.reach.items()},
            "layouts": [layout.as_dict() for layout in layouts],
        },
    }
    return scene_view(fence, header, run, scales, layouts, told=told), baked


def _template(name: str) -> Template:
    return templates("sim.pages.widget").get_template(f"{name}.html.j2")


def _untold(header: Mapping[str, Any]) -> dict[str, Any]:
    """The header of a scene that asks first: its set-up, and nothing that happened."""
    kept = {key: value for key, value in header.items() if key not in TELLING}
    return {**kept, "rows": 1, "events": [], "plan": [], "warnings": []}


def _rounded(run: Run, digits: int) -> Run:
    """The run with the digits that the page gets, so that Python and the page draw the same."""
    table = run.as_dict(digits)
    return Run(*(table[name] for name in ("t", "x", "v", "a", "F", "dF", "E")))


def _fence_facts(fence: Any) -> dict[str, Any]:
    """What the page needs to know about the fence."""
    predict = fence.predict
    return {
        "id": fence.id,
        "scene": dict(fence.plain),
        "show": list(fence.show),
        "forces": fence.forces,
        "slow": fence.slow,
        "boxes": fence.boxes,
        "camera": fence.view_speed,
        "packages": sorted(fence.packages),
        "controls": [
            {
                "set": c.set,
                "label": heard(c.label),
                "unit": c.unit,
                "per": c.per,
                "low": c.shown(c.low),
                "high": c.shown(c.high),
                "step": c.shown(c.step),
                "value": c.shown(c.value),
            }
            for c in fence.controls
        ],
        "switches": [{"set": s.set, "value": s.value} for s in fence.switches],
        "presets": {name: dict(changes) for name, changes in fence.presets.items()},
        "predict": None
        if predict is None
        else {
            "kind": predict.kind,
            "ask": heard(predict.ask),
            "talk": predict.talk,
            "pairs": [list(pair) for pair in predict.pairs],
            "cart": predict.cart,
            "options": list(predict.options),
        },
    }
