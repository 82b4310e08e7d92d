"""Views beside the picture: forces on each cart, the lens, momentum bars. Filled by `views.js`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.pages.widget.numbers import speed_unit
from sim.pages.widget.scale_of import Scales
from sim.pages.widget.words import body


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
    lasting = [c["bodies"] for c in header["contacts"] if c["stiffness"]]
    carts = [
        {
            "name": name,
            "style": style,
            "forces": [
                f"force on {name} by {body(other)}"
                for pair in lasting
                if name in pair
                for other in pair
                if other != name
            ],
        }
        for name, style in styles.items()
    ]
    momenta = [{"label": name, "style": style} for name, style in styles.items()]
    if "wall" in (header["track"]["left"], header["track"]["right"]):
        momenta.append({"label": "wall + Earth", "style": "wall"})
    if len(momenta) > 1:
        momenta.append({"label": "all", "style": "total"})  # as the page names them
    keys = ("name", "symbol", "unit", "quantity")
    rows = [
        ("resultant force", "F", "N", "F"),
        ("mass", "m", "kg", "mass"),
        ("acceleration", "a = F/m", "m/s²", "a"),
        ("change of velocity", "Δv", unit, "dv"),
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
