"""From a map and its values to the complete `<carts-map>` element."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from sim.pages.map import figure as drawing
from sim.pages.map.bake import MapRun
from sim.pages.map.palette import NONE, ZERO
from sim.pages.map.scale import scale_for
from sim.pages.templates import script_json, templates
from sim.pages.widget.numbers import decimals_of, fixed, plain
from sim.scene.controls import Control
from sim.scene.map import Map

TABLE_COLUMNS, TABLE_ROWS = 6, 11


def render_map(described: Map, written: Mapping[str, Any], run: MapRun) -> str:
    """HTML of the element; `written`: the block's values with its scene's, as the page asks."""
    scale = scale_for(run.low, run.high)
    here = [nearest(values, c.value) for values, c in zip(run.axes, described.over, strict=True)]
    at = here[0] + (here[1] * len(run.axes[0]) if len(here) == 2 else 0)
    made = drawing.figure(described, run, scale)
    view = {
        "id": described.id,
        "of": described.of or "",
        "title": described.title or sentence_case(described.show.label),
        "label": described.show.label,
        "unit": described.show.unit,
        "value": drawing.value_text(run.values[at], run),
        "figure": made,
        "axes": [
            _axis(control, values, place)
            for control, values, place in zip(described.over, run.axes, here, strict=True)
        ],
        "controls": [_control(control) for control in described.controls],
        "table": table(described, run),
        "why": run.why,
        "baked": script_json(_facts(described, written, run, here, run.values[at])),
    }
    return str(templates("sim.pages.map").get_template("map.html.j2").render(view))


def sentence_case(text: str) -> str:
    """With a capital in front; names keep theirs."""
    return text[:1].upper() + text[1:]


def nearest(values: Sequence[float], value: float) -> int:
    """The place of the point of an axis that is nearest to `value`."""
    return min(range(len(values)), key=lambda k: abs(values[k] - value))


def table(described: Map, run: MapRun) -> dict[str, Any]:
    """A part of the values, evenly spread, for readers who want numbers."""
    across = described.over[0]
    if len(run.axes) == 1:
        rows = spread(len(run.axes[0]), 2 * TABLE_ROWS - 1)
        return {
            "head": [described.show.label],
            "rows": [
                (axis_text(across, run.axes[0], k), [drawing.value_text(run.values[k], run)])
                for k in rows
            ],
        }
    columns, rows = spread(len(run.axes[0]), TABLE_COLUMNS), spread(len(run.axes[1]), TABLE_ROWS)
    wide = len(run.axes[0])
    return {
        "head": [axis_text(across, run.axes[0], k) for k in columns],
        "rows": [
            (
                axis_text(described.over[1], run.axes[1], row),
                [drawing.value_text(run.values[row * wide + k], run) for k in columns],
            )
            for row in rows
        ],
    }


def spread(count: int, most: int) -> list[int]:
    """At most so many of the places 0 to count − 1, both ends among them; see `map-table.js`."""
    wanted = min(most, count)
    return [int(k * (count - 1) / (wanted - 1) + 0.5) for k in range(wanted)]


def axis_text(control: Control, values: Sequence[float], place: int) -> str:
    """A point of an axis in the axis's unit, with the decimals that its step needs."""
    return fixed(control.shown(values[place]), axis_decimals(control, values))


def axis_decimals(control: Control, values: Sequence[float]) -> int:
    """Decimals that tell the points of an axis apart."""
    shown = [control.shown(value) for value in values]
    return max(decimals_of(shown[0]), decimals_of(shown[1] - shown[0], 3))


def _axis(control: Control, values: Sequence[float], place: int) -> dict[str, Any]:
    text = axis_text(control, values, place)
    return {
        "set": control.set,
        "key": control.set.replace(".", "-"),
        "label": control.label,
        "unit": control.unit,
        "last": len(values) - 1,
        "place": place,
        "text": text.replace("−", "-"),
        "spoken": f"{text} {control.unit}".strip(),
    }


def _control(control: Control) -> dict[str, Any]:
    low, high, step, value = map(
        control.shown, (control.low, control.high, control.step, control.value)
    )
    text = fixed(value, max(decimals_of(step), decimals_of(low), decimals_of(value)))
    return {
        "set": control.set,
        "key": control.set.replace(".", "-"),
        "label": control.label,
        "unit": control.unit,
        "low": plain(low),
        "high": plain(high),
        "step": plain(step),
        "value": plain(value),
        "text": text.replace("−", "-"),
        "spoken": f"{text} {control.unit}".strip(),
    }


def _range(control: Control) -> dict[str, Any]:
    """What is set, between which two values as the reader sees them."""
    return {
        "set": control.set,
        "label": control.label,
        "unit": control.unit,
        "per": control.per,
        "low": control.shown(control.low),
        "high": control.shown(control.high),
    }


def _facts(
    described: Map, written: Mapping[str, Any], run: MapRun, here: Sequence[int], at: float
) -> dict[str, Any]:
    """What the page's script needs to know; `at`: the value at the point `here`."""
    scale = scale_for(run.low, run.high)
    value = drawing.value_axis(run)
    return {
        "map": dict(written),
        "of": described.of,
        "packages": list(run.packages),
        "label": described.show.label,
        "unit": described.show.unit,
        "decimals": drawing.most_decimals(run),
        "axes": [
            {
                **_range(c),
                "decimals": axis_decimals(c, values),
                "values": values,
            }
            for c, values in zip(described.over, run.axes, strict=True)
        ],
        "here": list(here),
        "at": None if math.isnan(at) else at,
        "controls": [
            {
                **_range(c),
                "step": c.shown(c.step),
                "value": c.shown(c.value),
            }
            for c in described.controls
        ],
        "scale": {
            "low": scale.low,
            "step": scale.step,
            "count": scale.count,
            "colours": [list(colour) for colour in scale.colours],
            "none": list(NONE),
            "zero": scale.zero,
            "line": list(ZERO),
        },
        "value": {"low": value.low, "high": value.high, "step": value.step},
        "plot": [drawing.LEFT, drawing.TOP, drawing.RIGHT, drawing.BOTTOM],
        "size": [drawing.WIDTH, drawing.HEIGHT_OF_CURVE if len(here) == 1 else drawing.HEIGHT],
    }
