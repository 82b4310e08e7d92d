"""Cards of readouts and sliders, as the panel template writes them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.pages.language import heard, tr
from sim.pages.widget.markers import MARKERS
from sim.pages.widget.numbers import decimals_of, fixed, short, speed_unit
from sim.pages.widget.run import Run
from sim.pages.widget.scale_of import Scales
from sim.scene.effects import kinds

UNTOLD = "–"  # stands for a number until the prediction is locked


def cards(
    header: Mapping[str, Any],
    controls: Sequence[Any],
    scales: Scales,
    start: Run,
    *,
    camera: float,
    forces: bool,
    told: bool,
) -> list[dict[str, Any]]:
    """One card per cart with its readouts at t = 0, then the contact, then the scene.

    `told` False: a prediction comes first, so force and acceleration are left open.
    """
    names = [body["name"] for body in header["bodies"]]
    made = []
    for i, body in enumerate(header["bodies"]):
        own = [c for c in controls if c.set.partition(".")[0] == body["name"]]
        made.append(
            {
                "title": tr("Cart {name}", name=body["name"]),
                "body": body["name"],
                "style": f"b{i % 8}",
                "marker": MARKERS[f"b{i % 8}"],
                "readouts": _readouts(body, scales, start, camera, forces=forces, told=told),
                "controls": [control_view(c, f" of {body['name']}") for c in own],
            }
        )
    contact = [c for c in controls if c.set.startswith("contact.")]
    elsewhere = (*names, "effects", *kinds())
    rest = [c for c in controls if c not in contact and c.set.partition(".")[0] not in elsewhere]
    for title, own in ((tr("Contact"), contact), (tr("Scene"), rest)):
        if own:
            made.append(
                {
                    "title": title,
                    "body": "",
                    "style": "",
                    "readouts": [],
                    "controls": [control_view(c, "") for c in own],
                }
            )
    return made


def _readouts(
    body: Mapping[str, Any],
    scales: Scales,
    start: Run,
    camera: float,
    *,
    forces: bool,
    told: bool,
) -> list[dict[str, str]]:
    name, decimals = body["name"], scales.decimals
    per, unit = speed_unit(scales.velocity)
    rows = [
        (tr("mass"), "m", "mass", short(body["mass"]), "kg"),
        (
            tr("position seen from the camera") if camera else tr("position"),
            "x",
            "x",
            fixed(body["position"], decimals["x"]),
            "m",
        ),
        (
            tr("velocity seen from the camera") if camera else tr("velocity"),
            "v",
            "v",
            fixed((body["velocity"] - camera) / per, decimals["v"]),
            unit,
        ),
    ]
    if forces:
        force = acceleration = UNTOLD
        if told:
            force = fixed(body["mass"] * start.a[name][0], decimals["F"])
            acceleration = fixed(start.a[name][0], decimals["a"])
        rows.append((tr("resultant force"), "F", "F", force, "N"))
        rows.append((tr("acceleration"), "a", "a", acceleration, "m/s²"))
    keys = ("name", "symbol", "quantity", "text", "unit")
    return [dict(zip(keys, row, strict=True)) for row in rows]


def control_view(control: Any, suffix: str) -> dict[str, Any]:
    """A slider as the template writes it; `suffix` of its label is told by the card already."""
    low, high, step, value = map(
        control.shown, (control.low, control.high, control.step, control.value)
    )
    decimals = max(decimals_of(step), decimals_of(low), decimals_of(value))
    label = str(control.label)
    return {
        "set": control.set,
        "key": control.set.replace(".", "-"),
        "label": heard(label),
        "short": heard(label.removesuffix(suffix) if suffix else label),
        "unit": control.unit,
        "low": plain(low),
        "high": plain(high),
        "step": plain(step),
        "value": plain(value),
        "text": fixed(value, decimals).replace("−", "-"),
    }


def plain(value: float) -> str:
    """A number for an HTML attribute: shortest form, no exponent for whole numbers."""
    return str(int(value)) if value == int(value) and abs(value) < 1e15 else repr(float(value))
