"""Scenes in which located steps came to another end than the exact run, or to none: found by the
adversary's kinds, made plain."""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.stepping.methods import ADAPTIVE, MethodChoice, outcome
from sim.scene import read_scene

FOUND: dict[str, dict[str, Any]] = {
    "friction on one cart leaves another one alone": {
        "carts": {
            "A": {"mass": 1, "position": 0.6, "velocity": 0.5},
            "B": {"mass": 0.6, "position": 0.9},
            "C": {"mass": 1, "position": 1.1},
        },
        "contact": {"law": "push-only", "restitution": 0.3, "stiffness": 7310},
        "until": 2,
        "effects": [{"friction": {"coefficient": 0.3, "static": 0.45, "carts": ["B"]}}],
    },
    "a flight shorter than a step is seen": {
        "carts": {"A": {"mass": 1, "position": 0.2, "velocity": -0.611}},
        "track": {"left": "wall", "length": 2},
        "contact": {"law": "instant", "restitution": 0.5},
        "until": 2.83,
        "effects": [{"incline": {"angle": "-3 deg"}}],
    },
    "a bumper that was clear between two looks remembers nothing": {
        "carts": {
            "A": {"mass": 1.0, "position": 0.2},
            "B": {"mass": 1.75, "position": 0.41, "velocity": 1.0},
            "C": {"mass": 2.47, "position": 0.71, "velocity": -0.3},
        },
        "track": {"left": "wall", "length": 1.12},
        "contact": {
            "law": "bumper", "restitution": 0, "stiffness": 146000,
            "pairs": {"A-B": {"law": "bumper", "restitution": 0.629, "stiffness": 4980}},
        },
        "until": 3,
        "effects": [{"incline": {"angle": "-10 deg"}}],
    },
    "a spring across a bumper that is held pressed goes on pushing": {
        "carts": {
            "B": {"mass": 1, "position": 0.4, "velocity": 0.4},
            "C": {"mass": 0.325, "position": 0.6, "velocity": 0.5},
        },
        "track": {"right": "wall", "length": 0.76},
        "contact": {
            "law": "bumper", "restitution": 0, "stiffness": 22700,
            "pairs": {"B-C": {"law": "push-only", "restitution": 0.05, "stiffness": 37.1}},
        },
        "until": 3,
        "effects": [{"spring": {"between": ["C", "right"], "stiffness": 40, "length": 0.05}}],
    },
    "a cart that is set going and stops within a step does both": {
        "carts": {
            "A": {"mass": 0.705, "position": 0.2},
            "B": {"mass": 0.237, "position": 0.40507},
            "C": {"mass": 1, "position": 0.70507},
        },
        "contact": {
            "law": "push-only", "restitution": 0.3, "stiffness": 44100,
            "pairs": {"A-B": {"law": "bumper", "restitution": 0.05, "stiffness": 704}},
        },
        "until": 1,
        "effects": [
            {"friction": {"coefficient": 0.3, "static": 0.45, "carts": ["B"]}},
            {"push": {"cart": "A", "force": 1}},
        ],
    },
    "a trial step through a magnet is taken again, shorter": {
        "carts": {
            "A": {"mass": 1, "position": 0.1},
            "B": {"mass": 1, "position": 0.4, "velocity": -2},
        },
        "until": 1,
        "effects": [{"magnets": {"between": ["A", "B"], "strength": 1e-8, "power": 2.5}}],
    },
}  # fmt: skip


@pytest.mark.parametrize("method", ADAPTIVE)
@pytest.mark.parametrize("name", FOUND)
def test_steps_of_a_tolerance_come_to_the_exact_end(name: str, method: str) -> None:
    scene = read_scene(FOUND[name])
    true, done = run(scene), outcome(scene, MethodChoice(method, rtol=1e-10))
    x = [cart.position + s for cart, s in zip(scene.carts, done.s, strict=True)]
    assert x == pytest.approx(true.x, abs=1e-6)
    assert done.v == pytest.approx(true.v, abs=1e-6)
