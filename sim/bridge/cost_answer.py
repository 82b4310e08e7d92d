"""What accuracy costs, as the wire delivers it: one run by a method, or one row of the table.

    {"id": 8, "kind": "cost", "scene": {...}, "method": "euler", "parts": 103}
    {"id": 9, "kind": "cost", "scene": {...}, "row": 3}
    {"id": 10, "kind": "cost", "scene": {...}, "digits": [{"method": …, "time_ratio": …}, …]}

The first is answered with both runs over one time grid, column after column: t, x of each cart as
stepped, x of each cart exactly, energy of motion as stepped and exactly. `parts` is how many steps
the run's length is divided into; `rk45` and `adaptive` have `rtol` instead. The second is answered
with one measured row (several for row 0) of about `of`; a page asks for them one by one. Of a
method that cannot follow the scene it has none, and `not_run` with the reason. The third says what
one more digit costs, out of such rows, and where rounding begins.
"""

from __future__ import annotations

from array import array
from collections.abc import Mapping
from typing import Any

from sim.bridge.alive import alive
from sim.bridge.method_choice import method_choice_of
from sim.bridge.protocol import track_of
from sim.dynamics.cost.exact import exact
from sim.dynamics.cost.measure import choices, exact_rows, row
from sim.dynamics.cost.report import digits_of, floor_of, row_object
from sim.dynamics.loop.run import run
from sim.dynamics.report.document import finite
from sim.dynamics.result.finished import Run
from sim.dynamics.result.ledger import kinetic
from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.result.trajectory import sample
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import SteppedRun, stepped
from sim.scene import Scene, read_scene
from sim.scene.said import wire

MOST_PARTS = 20_000
"""Steps of a run that a page may ask for."""

FINEST = 1_000
"""Parts of the finest row that a page measures: a slow laptop has to be done in a few seconds."""

FRAMES = 400
"""Samples of a run that are sent; steps between them are left out, none is put in between."""


def cost_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """Header and numbers; raises SceneError for what makes no sense."""
    scene = read_scene(request.get("scene") or {})
    number, measured = request.get("row"), request.get("digits")
    if isinstance(measured, list):
        return _digits(scene, measured), array("d")
    if isinstance(number, int):
        return _row(scene, number), array("d")
    return _run(scene, method_choice_of(scene, {"parts": 1_000, **request}, MOST_PARTS))


def _row(scene: Scene, number: int) -> dict[str, Any]:
    listed = choices(scene, finest=FINEST)
    truth = exact(scene)
    alive()
    answer: dict[str, Any] = {"of": len(listed) + 1}
    if number <= 0 or number > len(listed):
        return answer | {"rows": [row_object(one) for one in exact_rows(scene, truth)]}
    choice = listed[number - 1]
    try:
        return answer | {"rows": [row_object(row(scene, truth, choice))]}
    except UnsolvedError as error:
        return answer | {
            "rows": [],
            "not_run": {"method": choice.method, "reason": wire(error.message)},
        }


def _digits(scene: Scene, rows: list[dict[str, Any]]) -> dict[str, Any]:
    truth = exact(scene)
    return {**digits_of(rows, truth), "floor": floor_of(truth)}


def _run(scene: Scene, choice: MethodChoice) -> tuple[dict[str, Any], array[float]]:
    solved, result = run(scene), stepped(scene, choice)
    names = [cart.name for cart in scene.carts]
    header = {
        "until": scene.until,
        "bodies": [{"name": c.name, "mass": c.mass, "length": c.length} for c in scene.carts],
        "track": track_of(scene),
        "steps": result.steps,
        "evaluations": result.evaluations,
        "v": {"stepped": _named(names, result.run.v), "exact": _named(names, solved.v)},
        "energy": {
            "initial": solved.ledger.energy_initial,
            "stepped": result.run.ledger.energy_final,
            "exact": solved.ledger.energy_final,
            "imbalance": result.lost_energy,
        },
    }
    numbers, rows = _columns(scene, solved, result)
    return {**{key: finite(value) for key, value in header.items()}, "rows": rows}, numbers


def _named(names: list[str], values: tuple[float, ...]) -> dict[str, float]:
    return dict(zip(names, values, strict=True))


def _columns(scene: Scene, solved: Run, result: SteppedRun) -> tuple[array[float], int]:
    """Both runs at the ends of steps."""
    columns = result.samples.columns
    times = columns[("t",)]
    every = max(1, len(times) // FRAMES)
    places = [*range(0, len(times) - 1, every), len(times) - 1]
    names = [cart.name for cart in scene.carts]
    exactly = [sample(solved, times[k]) for k in places]
    lines = [
        [times[k] for k in places],
        *([columns[("x", name)][k] for k in places] for name in names),
        *([x[cart] for x, _ in exactly] for cart in range(len(names))),
        [kinetic(scene, [columns[("v", name)][k] for name in names]) for k in places],
        [kinetic(scene, v) for _, v in exactly],
    ]
    numbers = array("d")
    for line in lines:
        numbers.extend(line)
    return numbers, len(places)
