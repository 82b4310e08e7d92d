"""Spheres (law `hertz`) that touch while a spring with a damper pulls one of them to the wall."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import trajectory
from sim.scene import read_scene


def solved(until: float, damping: float) -> Any:
    spring = {"between": ["left", "A"], "stiffness": 20, "length": 0.2, "damping": damping}
    scene = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.3, "velocity": 1.0},
            "B": {"mass": 1.0, "position": 0.5, "velocity": 0.0},
        },
        "track": {"left": "wall", "right": "open", "length": 1.5},
        "contact": {"law": "hertz", "restitution": 1, "stiffness": 5000},
        "effects": [{"drag": {"quadratic": 0.1}}, {"spring": spring}],
        "until": until,
    }
    return run(read_scene(scene))


@pytest.mark.parametrize("damping", [0.0, 1.0])
@pytest.mark.parametrize("until", [0.001, 0.5])
def test_what_the_wall_gives_through_the_spring_is_in_the_account(
    until: float, damping: float
) -> None:
    """While such a row is integrated, what its springs do to a wall was not booked."""
    done = solved(until, damping)
    assert done.solvers["adaptive"]
    account = done.ledger
    given = account.momentum_initial + account.external
    assert given == pytest.approx(account.momentum_final, abs=1e-12)
    assert account.imbalance() < 1e-11


def test_the_drawn_forces_are_those_that_accelerate() -> None:
    """The damper's part was left out of the force, and the spring's out of its slope."""
    done = solved(0.003, 1.0)
    columns = trajectory(done).columns
    a, v = columns[("a", "A")], columns[("v", "A")]
    pulled, pushed = columns[("F", "left-A")], columns[("F", "A-B")]
    assert pulled[0] == pytest.approx(-1.0)
    for k, acceleration in enumerate(a):
        assert acceleration == pytest.approx(pulled[k] - pushed[k] - 0.1 * v[k] ** 2, abs=1e-5)
    t, slope = columns[("t",)], columns[("dF", "left-A")]
    steps = [k for k in range(1, len(t)) if t[k] > t[k - 1]]
    grown = math.fsum((t[k] - t[k - 1]) * (slope[k] + slope[k - 1]) / 2.0 for k in steps)
    assert grown == pytest.approx(pulled[-1] - pulled[0], rel=1e-3)
