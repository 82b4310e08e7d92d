"""Views beside the picture: forces on each cart, the lens, momentum bars. Filled by `views.js`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.pages.language import tr
from sim.pages.widget.effects_forces import agent, linked_pairs, outside
from sim.pages.widget.numbers import speed_unit
from sim.pages.widget.scale_of import Scales
from sim.pages.widget.words import body, force_on


def views_view(
    header: Mapping[str, Any],
    scales: Scales,
    opened: Sequence[str],
    *,
    forces: bool,
    told: bool,
) -> dict[str, Any]:
    """What the views template needs; `opened` are the views that are seen at first."""
    unit = speed_unit(scales.velocity)[1]
    styles = {b["name"]: f"b{i % 8}" for i, b in enumerate(header["bodies"])}
    linked = linked_pairs(header)
    lasting = [c["bodies"] for c in header["contacts"] if c["stiffness"] or c["pair"] in linked]
    carts = [
        {
            "name": name,
            "style": style,
            "forces": [
                force_on(name, body(other))
                for pair in lasting
                if name in pair
                for other in pair
                if other != name
            ]
            + [
                force_on(name, agent(effect))
                for effect in header["effects"]
                if effect["active"] and not effect["between"] and name in effect["carts"]
            ],
        }
        for name, style in styles.items()
    ]
    momenta = [{"label": name, "style": style} for name, style in styles.items()]
    if outside(header):
        momenta.append({"label": outside(header), "style": "wall"})
    if len(momenta) > 1:
        total = tr("all together") if outside(header) else tr("all carts")
        momenta.append({"label": total, "style": "total"})
    keys = ("name", "symbol", "unit", "quantity")
    rows = [
        (tr("resultant force"), "F", "N", "F"),
        (tr("mass"), "m", "kg", "mass"),
        (tr("acceleration"), "a = F/m", "m/s²", "a"),
        (tr("change of velocity"), "Δv", unit, "dv"),
    ]
    return {
        "told": told,
        "forces": forces,
        "open": list(opened),
        "carts": carts,
        "touches": bool(lasting),
        "momenta": momenta,
        "rows": [dict(zip(keys, row, strict=True)) for row in rows],
    }
