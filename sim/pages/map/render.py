"""From a map and its values to the complete `<carts-map>` element."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any

from sim.pages.language import told
from sim.pages.map.bake import MapRun
from sim.pages.templates import element
from sim.scene.fence.controls import Control
from sim.scene.fence.map import Map
from sim.scene.said import capital

FIRST_LETTER = ord("0")
"""Of the colours of a picture, as the script that paints it tells them."""


def render_map(
    described: Map, written: Mapping[str, Any], run: MapRun, *, drawn: bool = True
) -> str:
    """HTML of the element; `written`: the block's values with its scene's, as the page asks.

    Not `drawn`: the values stand beside the facts, for a page that draws them itself.
    """
    facts = _facts(described, written, run)
    values = [_known(value) for value in run.values]
    title = described.title or capital(told(described.show.label))
    shown = {"id": described.id, "title": title, "values": values, "why": told(run.why)}
    if not drawn:
        return element("map", described.id, "", {**facts, "draw": shown})
    from sim.pages.drawing import draw  # V8: only where a site is built

    picture = _picture(run, values) if len(run.axes) == 2 else ""
    inside = draw("map", {"facts": facts, "draw": shown, "picture": picture})
    return element("map", described.id, inside, facts)


def _picture(run: MapRun, values: Sequence[float | None]) -> str:
    """The bands of the map as an address that holds the picture itself."""
    from sim.pages.drawing import draw
    from sim.pages.map.png import data_url, png

    grid = {"low": run.low, "high": run.high, "columns": len(run.axes[0]), "values": values}
    made = json.loads(draw("map-picture", grid))
    pixels = bytes(letter - FIRST_LETTER for letter in made["letters"].encode("latin-1"))
    return data_url(png(made["width"], pixels, made["palette"]))


def nearest(values: Sequence[float], value: float) -> int:
    """The place of the point of an axis that is nearest to `value`."""
    return min(range(len(values)), key=lambda k: abs(values[k] - value))


def _known(value: float) -> float | None:
    return None if math.isnan(value) else value


def _facts(described: Map, written: Mapping[str, Any], run: MapRun) -> dict[str, Any]:
    """What the page's script needs to know; `at`: the value at the point `here`."""
    here = [nearest(values, c.value) for values, c in zip(run.axes, described.over, strict=True)]
    at = here[0] + (here[1] * len(run.axes[0]) if len(here) == 2 else 0)
    return {
        "map": dict(written),
        "of": described.of,
        "packages": list(run.packages),
        "label": told(described.show.label),
        "unit": described.show.unit,
        "low": run.low,
        "high": run.high,
        "axes": [
            {**_range(control), "values": values}
            for control, values in zip(described.over, run.axes, strict=True)
        ],
        "here": here,
        "at": _known(run.values[at]),
        "controls": [
            {**_range(c), "step": c.shown(c.step), "value": c.shown(c.value)}
            for c in described.controls
        ],
    }


def _range(control: Control) -> dict[str, Any]:
    """What is set, between which two values as the reader sees them."""
    return {
        "set": control.set,
        "label": told(control.label),
        "unit": control.unit,
        "per": control.per,
        "low": control.shown(control.low),
        "high": control.shown(control.high),
    }
