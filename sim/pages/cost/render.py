"""From a `cost` block to the complete `<carts-cost>` element: it reads and prints without a script.

What stands there before Python starts: a run that was made when the site was built, and a table
that was measured beforehand (`measured/`, made by `carts cost --json`): times of one computer, so
they are no part of a build that is to come out the same everywhere.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sim.pages.cost.block import USUAL_TITLE, CostBlock
from sim.pages.drawing import draw
from sim.pages.language import mark, told, told_if_ours
from sim.pages.templates import element
from sim.scene import read_scene
from sim.scene.said import from_wire, said

MEASURED = Path(__file__).parent / "measured"
BREAKS = MEASURED / "breaks.json"
WHEN = mark("on {day} with {python} on a shared computer with two cores")
"""What each table says of how it was measured, there with its values."""
FIRST = {"method": "euler", "parts": 103}


def render_cost(block: CostBlock) -> str:
    """HTML of the element."""
    first = next(iter(block.scenes))
    tables = {name: found for name in block.scenes if (found := measured(name))}
    known = tables.get(first, {"rows": []})
    run = baked_run(block.scenes[first])
    breaks = {"breaks": _breaks()} if block.breaks else {}
    inside = draw(
        "cost",
        {
            "id": block.id,
            "title": told_if_ours(block.title, USUAL_TITLE),
            "names": dict(block.names),
            "measured": "",
            **known,
            "run": run,
            **breaks,
        },
    )
    untils = {name: read_scene(plain).until for name, plain in block.scenes.items()}
    return element(
        "cost",
        block.id,
        inside,
        {
            "scenes": dict(block.scenes),
            "untils": untils,  # s: a row's step is a part of it
            "measured": tables,
            "run": run,
            **breaks,
        },
    )


def _breaks() -> dict[str, Any]:
    """Where methods break, measured beforehand; each map names the number that it goes along."""
    found: dict[str, Any] = json.loads(BREAKS.read_text(encoding="utf-8"))
    return found | {"maps": [{**one, "name": _name_of(one["path"])} for one in found["maps"]]}


def _name_of(path: list[str]) -> str:
    """A number of the scene in words, by its path: carts, B, mass."""
    whose, quantity = path[1:-1], path[-1]
    if not whose:
        return told(quantity)
    return told(said("{quantity} of {cart}", quantity=quantity, cart=whose[0]))


def baked_run(plain: Mapping[str, Any]) -> dict[str, Any]:
    """The run that is shown first, as the wire delivers it."""
    from sim.bridge.protocol import answer  # pulls the numerics: only where one is computed

    header, numbers = answer({"id": 0, "kind": "cost", "scene": plain, **FIRST})
    return {"header": header, "numbers": [float(f"{number:.7g}") for number in numbers]}


def measured(name: str) -> dict[str, Any] | None:
    """The table of a scene that was measured beforehand, as the figure draws it."""
    path = MEASURED / f"{name}.json"
    if not path.is_file():
        return None
    found = json.loads(path.read_text(encoding="utf-8"))
    when = told(from_wire(found["measured"]))
    return {key: found[key] for key in ("rows", "floor", "digits")} | {"measured": when}
