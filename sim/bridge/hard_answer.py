"""A hard case, run here and now: exactly, and by common methods in steps of a stated length.

    {"id": 8, "kind": "hard", "scene": {...}, "expected": [["v.A", 0.5], ...], "events": true}

`expected` names numbers of the end state and what they must be (`end_state`); with `events` false
events are only counted. The answer has what came out of each, and a verdict on each method:

    right                 every number within 1 % of what counts in this scene
    blows-up              a speed 20 times what all the energy could give, or beyond all numbers
    passes-through        two carts, or a cart and a wall, have changed places
    misses                fewer contacts than there are
    makes-energy, loses-energy    by more than 2 % of all energy in the scene
    sticks                carts that part stay together
    wrong                 none of these, but wrong
"""

from __future__ import annotations

import itertools
import math
import time
from array import array
from collections.abc import Mapping, Sequence
from typing import Any

from sim.bridge.alive import alive
from sim.bridge.end_state import read
from sim.dynamics.loop.run import run
from sim.dynamics.report.document import finite, report
from sim.dynamics.result.finished import Run
from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import SteppedRun, stepped
from sim.dynamics.stepping.stepped_report import stepped_report
from sim.scene import Scene, read_scene

METHODS = ("euler", "semi-implicit", "rk4")
STEP = 1 / 60
"""s. A picture on a screen lasts so long; many programs take it for their step."""
MOST_STEPS = 5_000
"""A longer run gets longer steps: it has to end while a reader waits."""

RIGHT = 0.01
"""Of what counts in the scene (`_scale`): a number that is off by so much at most is right."""
ENERGY = 0.02
"""Of all the energy in the scene: more of it made or lost is told."""
FAST = 20.0
"""Times what all the energy could give a cart: a speed above it has blown up."""
APART = 1e-3
"""Of the speed at which two carts part: with less of it they stay together."""
LEAST_LENGTH = 0.1
"""m. Places are judged by 1 % of themselves, or of this."""

Wanted = Sequence[tuple[str, float]]


def hard_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """The header; there are no numbers beside it."""
    scene = read_scene(request.get("scene") or {})
    wanted = [(str(what), float(value)) for what, value in request.get("expected") or []]
    kept = bool(request.get("events", True))
    start = time.perf_counter()
    solved = run(scene, keep_events=kept, keep_motion=kept)
    spent = time.perf_counter() - start
    report_values = report(solved)
    header = {
        "exact": {"got": [read(report_values, what) for what, _ in wanted], "seconds": spent},
        "stepped": [_stepped(scene, method, wanted, solved) for method in METHODS],
    }
    return finite(header), array("d")


def step_of(scene: Scene) -> float:
    """The step that is tried [s]."""
    return max(STEP, scene.until / MOST_STEPS)


def _stepped(scene: Scene, method: str, wanted: Wanted, solved: Run) -> dict[str, Any]:
    """One method: numbers, verdict, and the energy that it made, as a part of all there is."""
    alive()
    tried: dict[str, Any] = {"method": method, "step": step_of(scene)}
    lost = {"got": [None for _ in wanted], "verdict": "blows-up", "made": None}
    try:
        result = stepped(scene, MethodChoice(method, step=step_of(scene)), keep_events=True)
        report_values = stepped_report(result)
    except (OverflowError, ValueError, UnsolvedError):
        return tried | lost
    got = [_read(report_values, what) for what, _ in wanted]
    made = result.lost_energy / _energy(solved)
    return tried | {
        "got": got,
        "verdict": _verdict(scene, result, solved, wanted, got, made),
        "made": made,
    }


def _read(report_values: dict[str, Any], what: str) -> float | None:
    """A number that may be missing: no contact, or one beyond all numbers."""
    try:
        return read(report_values, what)
    except (KeyError, TypeError, ValueError):
        return None


def _verdict(
    scene: Scene,
    result: SteppedRun,
    solved: Run,
    wanted: Wanted,
    got: Sequence[float | None],
    made: float,
) -> str:
    end = result.run
    most = _fastest(scene, solved)
    slow = all(abs(v) <= FAST * limit for v, limit in zip(end.v, most, strict=True))
    if not slow or not math.isfinite(made):
        return "blows-up"
    if _changed_places(scene, end.x) and not _changed_places(scene, solved.x):
        return "passes-through"
    if all(
        value is not None and abs(value - true) <= RIGHT * _scale(scene, solved, what, true)
        for (what, true), value in zip(wanted, got, strict=True)
    ):
        return "right"
    for (what, true), value in zip(wanted, got, strict=True):
        if what.startswith(("count", "last")) and (value or 0.0) < true:
            return "misses"
    if abs(made) > ENERGY:
        return "makes-energy" if made > 0.0 else "loses-energy"
    return "sticks" if _stays_together(solved, end) else "wrong"


def _scale(scene: Scene, solved: Run, what: str, true: float) -> float:
    """What 1 % is taken of: the closing speed, a place, the energy; a count has to be exact.

    Where nothing moves at the start, it is the speed that all the energy could give. Where the
    speed at which two part is what is asked for, it is of that itself: of 2e-12 m/s a method that
    gives 3e-8 has no digit right.
    """
    kind, _, whose = what.partition(".")
    if kind == "v" and "-" in whose and true:
        return abs(true)
    if kind == "v":
        closing = max(0.0, *(-w for w in scene.approaches if math.isfinite(w)))
        moving = max(abs(true), *(abs(cart.velocity) for cart in scene.carts))
        return closing or moving or max(_fastest(scene, solved))
    if kind == "x":
        return max(abs(true), LEAST_LENGTH)
    if kind == "count":
        return 0.0
    kinetic = math.fsum(0.5 * cart.mass * cart.velocity**2 for cart in scene.carts)
    return max(abs(true), kinetic if kind != "last" else 0.0)


def _energy(solved: Run) -> float:
    """J: what there is at the start, and what effects give or take."""
    books = solved.ledger
    moved = math.fsum(abs(work) for work in books.works.values())
    return max(abs(books.energy_initial) + moved, abs(books.energy_final)) or 1.0


def _fastest(scene: Scene, solved: Run) -> list[float]:
    """m/s that each cart could have at most: at either end, or with all the energy there is."""
    energy = _energy(solved)
    return [
        max(abs(cart.velocity), abs(v), math.sqrt(2.0 * energy / cart.mass))
        for cart, v in zip(scene.carts, solved.v, strict=True)
    ]


def _changed_places(scene: Scene, x: Sequence[float]) -> bool:
    """Has a centre gone past a neighbour's, or past a wall, by more than a bumper gives way?"""
    edges = [
        *([0.0] if scene.track.left == "wall" else []),
        *x,
        *([scene.track.length or 0.0] if scene.track.right == "wall" else []),
    ]
    room = max(LEAST_LENGTH, *(cart.bumper_length for cart in scene.carts))
    return any(b < a - room for a, b in itertools.pairwise(edges))


def _stays_together(solved: Run, end: Run) -> bool:
    """Is there a pair that parts, and does not here?"""
    pairs = zip(solved.v, solved.v[1:], end.v, end.v[1:], strict=False)
    return any(b - a > 0.0 and abs(d - c) < APART * (b - a) for a, b, c, d in pairs)
