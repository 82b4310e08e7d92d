"""Accuracy and cost of the exact solver, against rational arithmetic and against stepping.

Times are ratios within one process; seconds are never compared with a goal.
"""

from __future__ import annotations

import math
import random
import time
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from sim.dynamics.loop.run import run
from sim.dynamics.motion.impact import impact
from sim.scene import read_scene
from tests import registry

STEP = 1e-3  # s, of the stepping method that the paper's applet would use


def rows() -> list[dict[str, Any]]:
    """One row per goal."""
    bare = _seconds(lambda: impact(1.0, 2.0, 1.0, -0.5, 0.8, 500.0), 20_000)
    stepped = _seconds(lambda: rk4(1.0, 2.0, 1.0, -0.5, 0.8, 500.0, 1.0), 20)
    scene = read_scene(registry.two_carts(law="paper", restitution="0.8"))
    engine = _seconds(lambda: run(scene, keep_events=False, keep_motion=False), 2_000)
    return [
        row(
            "impact: worst error over 5 000 pairs",
            worst_error(5_000),
            "of the largest speed",
            4e-16,
            "rational arithmetic",
        ),
        row(
            "RK4 at 1 ms / exact outcome",
            stepped / bare,
            "times the cost",
            1_000,
            "same output, same process",
            at_least=True,
        ),
        row(
            "run of two carts / bare formula",
            engine / bare,
            "times the cost",
            20,
            "the formula alone",
        ),
        *batch_rows(bare),
    ]


def batch_rows(bare: float) -> list[dict[str, Any]]:
    """Many outcomes at once; `bare` [s] is the cost of the formula for one of them in Python."""
    import numpy as np

    from sim.dynamics.batch.grid import solve
    from sim.dynamics.batch.impacts import impacts

    count = 4_000
    dice = np.random.default_rng(3)
    m1, m2 = 10 ** dice.uniform(-2, 2, count), 10 ** dice.uniform(-2, 2, count)
    v1, v2, e = dice.uniform(0, 3, count), dice.uniform(-3, 0, count), dice.uniform(0, 1, count)
    each = _seconds(lambda: impacts("bumper", m1, m2, v1, v2, e, 500.0), 50) / count
    plain = registry.plain("light-meets-heavy")
    axes = (
        ("A.mass", tuple(np.linspace(0.5, 5, 200).tolist())),
        ("contact.restitution", tuple(np.linspace(0, 1, 200).tolist())),
    )
    point = _seconds(lambda: solve(plain, axes, ("v", "B")), 3) / 40_000
    scene = read_scene(plain)
    one = _seconds(lambda: run(scene, keep_events=False, keep_motion=False), 500)
    name = "batch of 4 000 pair outcomes"
    return [
        row(f"{name}: each", 1e9 * each, "ns", 100, "one numpy call"),
        row(f"{name} / bare formula", each / bare, "of the cost", 0.2, "the formula in Python"),
        row("map of 200 × 200, judged: each point", 1e9 * point, "ns", 100, "one numpy call"),
        row("map of 200 × 200 / a run per point", point / one, "of the cost", 0.01, "the engine"),
    ]


def row(
    name: str, value: float, unit: str, goal: float, reference: str, *, at_least: bool = False
) -> dict[str, Any]:
    """One row of build/bench.json; `at_least` marks goals that are lower bounds."""
    line = {"name": name, "value": value, "unit": unit, "goal": goal, "reference": reference}
    return line | ({"at_least": True} if at_least else {})


def worst_error(count: int) -> float:
    """Largest error of an outgoing velocity, as a fraction of the largest speed in play."""
    dice, worst = random.Random(7), Fraction(0)
    for _ in range(count):
        m1, m2 = 10 ** dice.uniform(-3, 3), 10 ** dice.uniform(-3, 3)
        v1, v2, e = dice.uniform(0, 3), dice.uniform(-3, 0), dice.uniform(0.01, 1)
        got = impact(m1, m2, v1, v2, e, 500.0)
        a, b, c, d, f = map(Fraction, (m1, m2, v1, v2, e))
        centre = (a * c + b * d) / (a + b)
        for value, want in (
            (got[0], centre + f * (centre - c)),
            (got[1], centre + f * (centre - d)),
        ):
            worst = max(worst, abs(Fraction(value) - want) / max(c, -d, c - d))
    return float(worst)


def rk4(
    m1: float, m2: float, v1: float, v2: float, e: float, k: float, until: float
) -> tuple[float, float]:
    """The paper's equations (1) to (3), mended, stepped by classical RK4 without event location."""
    c = -2.0 * math.log(e) / math.hypot(math.pi, math.log(e)) * math.sqrt(k * m1 * m2 / (m1 + m2))
    length = 0.2

    def force(x: float, y: float, v: float, w: float) -> tuple[float, float]:
        overlap = length - (y - x)
        push = k * overlap + c * (v - w) if overlap > 0.0 else 0.0
        return -push / m1, push / m2

    x, y, v, w, h = 0.0, 0.8, v1, v2, STEP
    for _ in range(round(until / h)):
        a1, b1 = force(x, y, v, w)
        v2_, w2 = v + 0.5 * h * a1, w + 0.5 * h * b1
        a2, b2 = force(x + 0.5 * h * v, y + 0.5 * h * w, v2_, w2)
        v3, w3 = v + 0.5 * h * a2, w + 0.5 * h * b2
        a3, b3 = force(x + 0.5 * h * v2_, y + 0.5 * h * w2, v3, w3)
        v4, w4 = v + h * a3, w + h * b3
        a4, b4 = force(x + h * v3, y + h * w3, v4, w4)
        x += h / 6.0 * (v + 2.0 * v2_ + 2.0 * v3 + v4)
        y += h / 6.0 * (w + 2.0 * w2 + 2.0 * w3 + w4)
        v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4)
        w += h / 6.0 * (b1 + 2.0 * b2 + 2.0 * b3 + b4)
    return v, w


def _seconds(call: Callable[[], object], times: int) -> float:
    """Best of five: the least disturbed."""
    best = math.inf
    for _ in range(5):
        start = time.perf_counter()
        for _ in range(times):
            call()
        best = min(best, time.perf_counter() - start)
    return best / times
