"""What the engine costs: chains, boxes, effects, and an adaptive method on the same scenes.

Times are ratios within one process; calls are counted by the interpreter's profiling hook.
"""

from __future__ import annotations

import math
import random
import sys
import time
from collections.abc import Callable
from typing import Any
from unittest import mock

from sim.dynamics.loop.run import run
from sim.dynamics.motion.power_series import series
from sim.scene import effects, read_scene
from tests.benchmarks.physics import row
from tests.dynamics.given.pi_billiard import pi_billiard
from tests.dynamics.given.rows_of_carts import row as carts_in_a_row
from tests.dynamics.given.rows_of_carts import scenes as tier_two_scenes
from tests.reference import many_contacts

BARE = {"keep_events": False, "keep_motion": False}


def rows() -> list[dict[str, Any]]:
    """One row per goal of the engine."""
    return [*chains(), box(), *against_an_adaptive_method(), without_effects(), billiard()]


def chains() -> list[dict[str, Any]]:
    """A push through touching carts, and through spaced ones."""
    touching = read_scene(carts_in_a_row([1] + [0] * 49))
    each = {n: spaced(n) for n in (10, 10_000)}
    grows = each[10_000] / each[10] / (math.log(10_000) / math.log(10))
    return [
        row(
            "touching chain of 50", 1e3 * best(lambda: run(touching, **BARE), 1), "ms", 20, "alone"
        ),
        row(
            "spaced chain: cost per event, N = 10 000 / N = 10, per log N", grows, "times", 1, "10"
        ),
    ]


def spaced(count: int) -> float:
    """Seconds per event of carts in a row that hand a push on."""
    plain = carts_in_a_row([1] + [0] * (count - 1), gap=0.1, until=2 * count, k=1e5)
    scene = read_scene(plain)
    return best(lambda: run(scene, **BARE), max(1, 300 // count)) / (2 * count)


def box() -> dict[str, Any]:
    """50 carts between walls for 10 s."""
    dice, n, room = random.Random(2), 50, 10.0
    x = sorted(round(dice.uniform(0, room), 6) for _ in range(n))
    plain = {
        "carts": {
            f"c{k}": {
                "mass": 1,
                "position": repr(x[k]),
                "velocity": f"{dice.uniform(-1, 1):.6f}",
                "length": 0,
            }
            for k in range(n)
        },
        "track": {"left": "wall", "right": "wall", "length": room},
        "contact": {"law": "instant"},
        "until": 10,
    }
    scene = read_scene(plain)
    return row("box of 50 for 10 s, e = 1", 1e3 * best(lambda: run(scene, **BARE), 3), "ms", 3, "")


def against_an_adaptive_method() -> list[dict[str, Any]]:
    """Random coupled contacts; the reference is the series in steps a third as long."""
    times, worse = [], 0.0
    for plain in tier_two_scenes(12, seed=5):
        scene = read_scene(plain)
        ours, theirs = run(scene, **BARE), integrated(plain)
        with mock.patch.object(series, "REACH", series.REACH / 3):
            truth = run(scene, **BARE).v
        off = max(abs(a - b) for a, b in zip(ours.v, truth, strict=True))
        adaptive_off = max(abs(a - b) for a, b in zip(theirs[1], truth, strict=True))
        worse = max(worse, off / adaptive_off)
        mine = best(lambda scene=scene: run(scene, **BARE), 1)
        other = best(lambda plain=plain: integrated(plain), 1, 1)
        times.append(mine / other)
    mean = math.exp(math.fsum(math.log(t) for t in times) / len(times))
    name = "coupled contacts / DOP853 at 1e-12"
    return [
        row(f"{name}: time, geometric mean", mean, "of the time", 0.1, "12 random scenes"),
        row(f"{name}: time, worst", max(times), "of the time", 0.5, "12 random scenes"),
        row(f"{name}: error, worst", worse, "of the error", 1, "steps a third as long"),
    ]


def integrated(plain: dict[str, Any]) -> Any:
    """The same scene by scipy."""
    carts = list(plain["carts"].values())
    return many_contacts.integrate(
        [float(c["mass"]) for c in carts],
        [float(c["position"]) for c in carts],
        [float(c["velocity"]) for c in carts],
        e=float(plain["contact"]["restitution"]),
        k=float(plain["contact"]["stiffness"]),
        until=float(plain["until"]),
        left=0.0,
        right=float(plain["track"]["length"]),
    )


def without_effects() -> dict[str, Any]:
    """Calls that a scene without effects makes, with and without one more effect known."""
    scene = read_scene(carts_in_a_row([1, 0, -1], gap=0.3))
    before = calls(lambda: run(scene, **BARE))
    more = dict(effects.kinds()) | {"another": effects.kinds()["friction"]}
    with mock.patch.object(effects, "kinds", lambda: more):
        after = calls(lambda: run(scene, **BARE))
    name = "calls of a scene without effects, with one more effect in the library"
    return row(name, after / before, "of the calls", 1, "without it")


def calls(do: Callable[[], object]) -> int:
    """Python calls that it makes."""
    do()
    count = 0

    def seen(_frame: object, event: str, _argument: object) -> None:
        nonlocal count
        count += event == "call"

    sys.setprofile(seen)
    try:
        do()
    finally:
        sys.setprofile(None)
    return count


def billiard() -> dict[str, Any]:
    """Galperin's pi billiard: 3 141 592 collisions."""
    finished = run(read_scene(pi_billiard(6)), max_events=4_000_000, **BARE)
    off = abs(finished.record.counts["contact"] - 3_141_592)
    return row(
        "pi billiard, six decimals: collisions too many or too few", off, "", 0, "digits of pi"
    )


def best(call: Callable[[], object], times: int, tries: int = 5) -> float:
    """Seconds per call, the least disturbed of some tries."""
    found = math.inf
    for _ in range(tries):
        start = time.perf_counter()
        for _ in range(times):
            call()
        found = min(found, time.perf_counter() - start)
    return found / times
