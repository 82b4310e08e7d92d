"""“How is this computed?”: what the exact run costs here and now, or the same scene step by step.

    {"id": 8, "kind": "how", "scene": {...}, "set": {...}}
    {"id": 9, "kind": "how", "scene": {...}, "set": {...}, "method": "euler", "parts": 103}

The first is answered by `cost`: seconds of the solution, and of the points to draw. The second
by a run like any other (see `protocol`), and under `how` by what it took and how wrong it is; the
method's number is `parts`, into which the run's length is divided, or `rtol`.
"""

from __future__ import annotations

import math
import time
from array import array
from collections.abc import Callable, Mapping
from typing import Any

from sim.bridge.alive import alive
from sim.bridge.method_choice import method_choice_of
from sim.bridge.protocol import MOST_EVENTS_DRAWN, MOST_STEPS_DRAWN, effects_of, plain_of, wire
from sim.dynamics.cost.distance import far
from sim.dynamics.loop.run import run
from sim.dynamics.report.document import finite
from sim.dynamics.report.warnings import warnings
from sim.dynamics.result.finished import Run
from sim.dynamics.result.trajectory import trajectory
from sim.dynamics.stepping.drawn import Drawn, drawn
from sim.dynamics.stepping.methods import MethodChoice, outcome
from sim.dynamics.stepping.recorded import SteppedRun, stepped
from sim.dynamics.stepping.stepped_report import stepped_report
from sim.scene import Scene, read_scene
from sim.scene.said import wire as said_by

MOST_PARTS = 5_000
"""Steps of a run that a widget may ask for: it has to answer while a slider is moved."""

LONG_ENOUGH = 0.01
"""s that are measured at once, by as many runs as fill them: a browser's clock may be coarse."""

TRIES = 2


def how_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """Header and numbers; raises SceneError or UnsolvedError for what cannot be done."""
    plain = plain_of(request)
    scene = read_scene(plain)
    if "method" not in request:
        return {"cost": _cost(scene)}, array("d")
    choice = method_choice_of(scene, request, MOST_PARTS)
    result = stepped(scene, choice)
    solved = _exact(scene)
    shown = drawn(result, solved)
    header, numbers = wire(result.run, shown.samples, stepped_report(result))
    header["events"] = [e for e in header["events"] if shown.blown is None or e["t"] < shown.blown]
    header["effects"] = effects_of(plain, scene)
    # A blown-up run would ask for stiffnesses that no bumper has.
    header["warnings"] = [{"code": w.code, "message": said_by(w.message)} for w in warnings(solved)]
    header["how"] = finite(_compared(scene, choice, result, solved, shown))
    return header, numbers


def _exact(scene: Scene, *, kept: bool = True) -> Run:
    return run(
        scene,
        keep_events=kept,
        keep_motion=kept,
        max_events=MOST_EVENTS_DRAWN,
        max_steps=MOST_STEPS_DRAWN,
    )


def _cost(scene: Scene) -> dict[str, float]:
    """Seconds: all, of which the solution; the rest are the points of the curves."""
    solved = _exact(scene)
    solution = seconds(lambda: _exact(scene))
    return {"solution": solution, "points": seconds(lambda: trajectory(solved))}


def _compared(
    scene: Scene, choice: MethodChoice, result: SteppedRun, solved: Run, shown: Drawn
) -> dict[str, Any]:
    """What it took, and how far it is from the truth at the end; SI."""
    whole = solved.t == scene.until
    books = result.run.ledger
    return {
        "method": choice.method,
        "step": choice.step,
        "rtol": choice.rtol,
        "steps": result.steps,
        "evaluations": result.evaluations,
        "blown": shown.blown,
        "seconds": {
            "stepped": seconds(lambda: outcome(scene, choice)),
            "exact": seconds(lambda: _exact(scene, kept=False)),
        },
        "whole": whole,  # did the exact run come to the end too?
        "error": {
            "v": far(result.run.v, solved.v) if whole else None,
            "x": far(result.run.x, solved.x) if whole else None,
        },
        "energy": {"made": result.lost_energy, "initial": books.energy_initial},
    }


def seconds(call: Callable[[], object]) -> float:
    """Of one call: the best of some tries, each long enough for a coarse clock."""
    best = math.inf
    for _ in range(TRIES):
        alive()
        many, spent, start = 0, 0.0, time.perf_counter()
        while spent < LONG_ENOUGH:
            call()
            many += 1
            spent = time.perf_counter() - start
        best = min(best, spent / many)
        if many == 1:
            break  # a long run: once is enough
    return best
