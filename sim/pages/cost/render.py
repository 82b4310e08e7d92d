"""From a `cost` block to the complete `<carts-cost>` element: it reads and prints without a script.

What stands there before Python starts: a run that was made when the site was built, and a table
that was measured beforehand (`measured/`, made by `carts cost --json`): times of one computer, so
they are no part of a build that is to come out the same everywhere.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sim.pages.cost.block import CostBlock
from sim.pages.cost.figure import LABELS, METHODS, figure
from sim.pages.templates import script_json, templates
from sim.pages.widget.numbers import fixed, short

MEASURED = Path(__file__).parent / "measured"
FIRST_METHOD, FIRST_PARTS = "euler", 103
PARTS = (19, 61, 103, 211, 499, 997, 9973)
TOLERANCES = (1e-6, 1e-9, 1e-12)
MANY, HUGE = 1000, 10_000


def render_cost(block: CostBlock) -> str:
    """HTML of the element."""
    first = next(iter(block.scenes))
    run = baked_run(block.scenes[first])
    known = measured(first)
    rows = known["rows"] if known else []
    view = {
        "id": block.id,
        "title": block.title,
        "scenes": list(block.names.items()),
        "methods": [(name, LABELS[name]) for name in METHODS if not name.startswith("exact")],
        "parts": PARTS,
        "tolerances": [(r, tolerance(r)) for r in TOLERANCES],
        "method": FIRST_METHOD,
        "chosen": FIRST_PARTS,
        "figure": figure(rows),
        "rows": [cells(row, run["header"]["until"]) for row in rows],
        "measured": known.get("measured", "") if known else "",
        "told": told(run["header"]),
        "baked": script_json(
            {
                "scenes": dict(block.scenes),
                "first": first,
                "labels": LABELS,
                "rows": rows,
                "run": run,
            }
        ),
    }
    return str(templates("sim.pages.cost").get_template("cost.html.j2").render(view))


def baked_run(plain: Mapping[str, Any]) -> dict[str, Any]:
    """The run that is shown first, as the wire delivers it."""
    from sim.bridge.protocol import answer  # pulls the numerics: only where one is computed

    request = {"id": 0, "kind": "cost", "scene": plain, "method": FIRST_METHOD}
    header, numbers = answer(request | {"parts": FIRST_PARTS})
    return {"header": header, "numbers": [float(f"{number:.7g}") for number in numbers]}


def measured(name: str) -> dict[str, Any] | None:
    """The table of a scene that was measured beforehand."""
    path = MEASURED / f"{name}.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else None


def told(header: Mapping[str, Any]) -> list[tuple[str, str, str]]:
    """Quantity, as stepped, exactly; see `told` in `cost-element.js`."""
    energy = header["energy"]
    speeds = [
        (f"velocity of {name} at the end", f"{plain(v, 4)} m/s", f"{plain(true, 4)} m/s")
        for (name, v), true in zip(
            header["v"]["stepped"].items(), header["v"]["exact"].values(), strict=True
        )
    ]
    return [
        *speeds,
        (
            "energy at the end, of that at the start",
            percent(energy["stepped"], energy["initial"]),
            percent(energy["exact"], energy["initial"]),
        ),
        ("energy made from nothing", f"{short(energy['imbalance'])} J", "0 J"),
        ("times that all forces were computed", str(header["evaluations"]), "0"),
    ]


def percent(part: float, whole: float) -> str:
    """145 %; nothing of nothing is 100 %."""
    return f"{plain(100 * part / whole if whole else 100.0, 1)} %"


def plain(value: float, decimals: int) -> str:
    """So many decimals; numbers that no cart could have as powers of ten."""
    return fixed(value, decimals) if abs(value) < HUGE else short(value)


def cells(row: Mapping[str, Any], until: float) -> list[str]:
    """One line of the table; see `cells` in `cost-table.js`."""
    size = "–"
    if row.get("rtol") is not None:
        size = tolerance(row["rtol"])
    elif row.get("step") is not None:
        size = f"{short(until)} s / {round(until / row['step'])}"
    ratio = row["time_ratio"]
    times = str(round(ratio)) if ratio >= MANY else short(ratio)
    return [
        LABELS[row["method"]],
        size,
        str(row["evaluations"]),
        times,
        *("–" if row[key] is None else short(row[key], 2) for key in ("error_v", "energy_error")),
    ]


def tolerance(rtol: float) -> str:
    """A power of ten as it is typed at a command line."""
    return f"tolerance 1e{round(math.log10(rtol))}"
