"""Rows that touch and give nothing back (e = 0), against impacts that are struck one by one."""

from __future__ import annotations

import itertools
import math
from random import Random

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene

ENDED = 1e-13
"""Of the fastest one. Approaches of the plain loop that are rounding."""

AGREE = 1e-11
"""Of the fastest one. What is left where the loop ends, and the rounding of its many impacts."""

FEW = 60
"""Impacts of a run, of up to six bodies. The loop needs hundreds."""


def struck_one_by_one(inverse: list[float], v: list[float]) -> tuple[list[float], int]:
    """Velocities in the end [m/s], and how many impacts it took; always the fastest first."""
    v, count = list(v), 0
    fastest = max(map(abs, v))
    while True:
        closing = [a - b for a, b in itertools.pairwise(v)]
        k = max(range(len(closing)), key=closing.__getitem__)
        if closing[k] <= ENDED * fastest:
            return v, count
        push = closing[k] / (inverse[k] + inverse[k + 1])
        v[k] -= push * inverse[k]
        v[k + 1] += push * inverse[k + 1]
        count += 1


@pytest.mark.parametrize("seed", range(60))
def test_a_row_that_gives_nothing_back_ends_as_its_impacts_one_by_one_do(seed: int) -> None:
    dice = Random(seed)
    n, wall = dice.randint(3, 6), dice.random() < 0.5
    masses = [round(10 ** dice.uniform(-1, 1), 3) for _ in range(n)]
    speeds = [round(dice.uniform(-1, 1), 3) for _ in range(n)]
    speeds[0], speeds[-1] = 1.0, -1.0  # they meet
    carts = {
        chr(65 + k): {"mass": m, "position": round(0.1 + 0.2 * k, 1), "velocity": v}
        for k, (m, v) in enumerate(zip(masses, speeds, strict=True))
    }
    track = {"left": "wall" if wall else "open", "right": "open", "length": 0.2 * n}
    contact = {"law": "instant", "restitution": 0}
    done = run(read_scene({"carts": carts, "track": track, "contact": contact, "until": 1e-3}))
    inverse, v = [1 / m for m in masses], speeds
    if wall:
        inverse, v = [0.0, *inverse], [0.0, *v]
    expected, _ = struck_one_by_one(inverse, v)
    assert done.v == pytest.approx(expected[1:] if wall else expected, rel=0, abs=AGREE)
    assert done.solvers["instant"] <= FEW


def test_a_heavy_cart_that_presses_two_light_ones_against_a_wall_stands_still_at_once() -> None:
    """One by one: each impact takes a thousandth of its velocity; a million did not end it."""
    carts = {
        "A": {"mass": "1.15 g", "position": 0.2, "velocity": 0},
        "B": {"mass": "0.2 g", "position": 0.41, "velocity": 0},
        "C": {"mass": "1 kg", "position": 1.13, "velocity": -1},
    }
    track = {"left": "wall", "right": "open", "length": 1.8}
    contact = {"law": "instant", "restitution": 0}
    done = run(read_scene({"carts": carts, "track": track, "contact": contact, "until": 1}))
    assert done.v == (0.0, 0.0, 0.0)
    assert done.stopped is None
    assert done.solvers["instant"] <= FEW
    assert math.isclose(done.ledger.warmed, 0.5, rel_tol=1e-12)  # J, all that it had
