"""Guards that begin at nought: no method gives up, or stops to look, where nothing happens."""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.stepping.methods import ADAPTIVE, MethodChoice, outcome
from sim.scene import read_scene

TURNING = {
    "carts": {
        "A": {"mass": 1, "position": 0.1, "velocity": -1},
        "B": {"mass": 1, "position": 0.569, "velocity": -0.967},
        "C": {"mass": 1, "position": 0.869, "velocity": -1},
        "D": {"mass": 0.331, "position": 1.105, "velocity": -0.3},
    },
    "contact": {"law": "velcro"},
    "effects": [
        {"spring": {"between": ["C", "D"], "stiffness": 442, "length": 0.3}},
        {"spring": {"between": ["C", "D"], "stiffness": 5, "length": 0.3, "damping": 0.3}},
        {"spring": {"between": ["B", "C"], "stiffness": 9.27, "length": 0.1}},
        {"friction": {"coefficient": 0, "static": 0, "carts": ["B"]}},
    ],
    "until": 3,
}
"""Friction of nothing keeps an eye on the direction of B and of what sticks to it: springs swing
it to and fro, and long steps take it there and back."""

LYING = {
    "carts": {
        "A": {"mass": 0.335, "position": 0.1, "velocity": -0.3},
        "B": {"mass": 0.323, "position": 0.35, "velocity": -1},
    },
    "contact": {"law": "instant", "restitution": 0},
    "until": 3,
}
"""After their impact they go on as one, overlapped by what rounding makes of it."""

ABREAST = {
    "carts": {
        "A": {"mass": 2.62, "position": 0.1, "velocity": 1},
        "B": {"mass": 1, "position": 0.3, "velocity": 1},
        "C": {"mass": 0.615, "position": 0.722, "velocity": 0},
        "D": {"mass": 2.08, "position": 0.922, "velocity": 0},
        "E": {"mass": 1, "position": 1.201, "velocity": -1},
    },
    "track": {"right": "wall", "length": 1.351},
    "contact": {"law": "instant", "restitution": 0.5},
    "until": 3,
}
"""A and B touch from the start and have one velocity; so have C and D."""


@pytest.mark.parametrize("rtol", [1e-6, 1e-8, 1e-10])
@pytest.mark.parametrize("method", ADAPTIVE)
@pytest.mark.parametrize("plain", [TURNING, LYING, ABREAST], ids=["turning", "lying", "abreast"])
def test_a_run_by_a_tolerance_comes_to_its_end(
    plain: dict[str, Any], method: str, rtol: float
) -> None:
    scene = read_scene(plain)
    done = outcome(scene, MethodChoice(method, rtol=rtol))
    assert done.v == pytest.approx(run(scene).v, abs=2e3 * rtol)
