"""What a page knows of a scene: its run, the lesson's wishes, and scales fixed for its life.

Hidden here, before anything is drawn: a scene that asks for a prediction knows its start only.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from sim.pages.language import told
from sim.pages.widget.layout import lay_out
from sim.pages.widget.reach import with_longest_track
from sim.pages.widget.run import Run, from_wire
from sim.pages.widget.scale_of import Scales, read_scales
from sim.scene.fence.presets import numbers_of
from sim.scene.said import Said

# Significant digits of the baked numbers: far below what can be seen, and few enough for 60 kB
# of HTML per scene. Long runs get fewer.
DIGITS, FEWER_DIGITS, LONG = 11, 7, 1500
# Parts of a header that tell of the run; a page without a prediction may know them at once.
TELLING = ("final", "energy", "momentum", "work", "evaluations", "outcome")


def baked_values(fence: Any, header: Mapping[str, Any], numbers: Sequence[float]) -> dict[str, Any]:
    """Plain values for the page: the header of the run, `numbers`, `fence` and `view`."""
    told = fence.predict is None
    digits = DIGITS if len(numbers) <= LONG else FEWER_DIGITS
    run = _rounded(from_wire(header, numbers), digits)
    if not told:
        run, header = run.start(), _untold(header)
    roomy = with_longest_track(header, fence.controls)
    presets = [numbers_of(fence.plain, changes) for changes in fence.presets.values()]
    known = run if told else None
    scales = read_scales(roomy, fence.controls, known, fence.view_speed, presets)
    scales = replace(scales, alike=fence.boxes == "alike")
    return {
        **header,
        "numbers": run.as_dict(digits),
        "fence": _fence_facts(fence),
        "view": _view(fence, roomy, scales),
    }


def _untold(header: Mapping[str, Any]) -> dict[str, Any]:
    """The header of a scene that asks first: its set-up, and nothing that happened."""
    kept = {key: value for key, value in header.items() if key not in TELLING}
    return {**kept, "rows": 1, "events": [], "plan": [], "warnings": []}


def _rounded(run: Run, digits: int) -> Run:
    """The run with the digits that the page gets, so that scales fit what is drawn."""
    table = run.as_dict(digits)
    return Run(*(table[name] for name in ("t", "x", "v", "a", "F", "dF", "E")))


def _view(fence: Any, header: Mapping[str, Any], scales: Scales) -> dict[str, Any]:
    forces = fence.forces == "shown"
    layouts = [
        lay_out(
            header,
            scales,
            kind=kind,
            camera=fence.view_speed,
            forces=forces,
            tape="ruler" in fence.opened,
        )
        for kind in ("wide", "narrow")
    ]
    return {
        "perHeight": scales.per_height,
        "alike": scales.alike,
        "tallest": scales.tallest,
        "mayTear": scales.may_tear,
        "gives": scales.gives,
        "force": scales.force,
        "velocity": scales.velocity,
        "decimals": scales.decimals,
        "reach": {q: reach.as_list() for q, reach in scales.reach.items()},
        "layouts": [layout.as_dict() for layout in layouts],
    }


def _fence_facts(fence: Any) -> dict[str, Any]:
    """What the page needs to know about the fence."""
    return {
        "skins": dict(fence.skins),
        "id": fence.id,
        "scene": dict(fence.plain),
        "show": list(fence.show),
        "opened": list(fence.opened),
        "forces": fence.forces,
        "slow": fence.slow,
        "watch": "first" if fence.watched_first else "free",
        "boxes": fence.boxes,
        "camera": fence.view_speed,
        "packages": sorted(fence.packages),
        "controls": [_control(control) for control in fence.controls],
        "switches": [
            {"set": s.set, "label": told(s.label), "value": s.value} for s in fence.switches
        ],
        "presets": {name: dict(changes) for name, changes in fence.presets.items()},
        "presetNumbers": {
            name: numbers_of(fence.plain, changes) for name, changes in fence.presets.items()
        },
        "predict": None if fence.predict is None else _prediction(fence.predict),
    }


def _control(control: Any) -> dict[str, Any]:
    """A slider, in its own unit; `short`: its label on the card of its cart, which names it."""
    return {
        "set": control.set,
        "label": told(control.label),
        "short": told(_on_its_card(control.label)),
        "unit": control.unit,
        "per": control.per,
        "low": control.shown(control.low),
        "high": control.shown(control.high),
        "step": control.shown(control.step),
        "value": control.shown(control.value),
    }


def _on_its_card(label: str) -> str:
    """The name of the quantity alone: the card is that of the cart."""
    return label.values.get("quantity", label) if isinstance(label, Said) else label


def _prediction(predict: Any) -> dict[str, Any]:
    return {
        "kind": predict.kind,
        "ask": told(predict.ask),
        "talk": predict.talk,
        "scale": predict.scale,
        "quantity": predict.quantity,
        "sure": predict.sure,
        "pairs": [list(pair) for pair in predict.pairs],
        "cart": predict.cart,
        "options": list(predict.options),
    }
