"""From a `measured` block to the complete `<carts-measured>` element.

Before Python starts, and without a script, the readings stand there: as points over time and as a
table. What they tell is not told: that is the student's work.
"""

from __future__ import annotations

from typing import Any

from sim.measured.units import OFFERED
from sim.pages.language import told_if_ours
from sim.pages.measured.block import USUAL_TITLE, MeasuredBlock
from sim.pages.templates import element


def render_measured(block: MeasuredBlock, *, drawn: bool = True) -> str:
    """HTML of the element. Not `drawn`: for a page that draws it itself."""
    facts = {
        "id": block.id,
        "title": told_if_ours(block.title, USUAL_TITLE),
        "name": block.name,
        "text": block.text,
        "units": _units(block),
        "offered": {kind: list(names) for kind, names in OFFERED.items()},
        "law": block.law,
        "synthetic": block.synthetic,
        "read": _read(block),
    }
    if not drawn:
        return element("measured", block.id, "", facts)
    from sim.pages.drawing import draw  # V8: only where a site is built

    return element("measured", block.id, draw("measured", facts), facts)


def _units(block: MeasuredBlock) -> dict[str, str] | None:
    if block.units is None:
        return None
    return {"length": block.units.length, "time": block.units.time, "force": block.units.force}


def _read(block: MeasuredBlock) -> dict[str, Any] | None:
    """The readings as the bridge would answer, with the units that the lesson names."""
    measured = block.measured
    if measured is None:
        return None
    return measured.plain() | {"chosen": _units(block)}
