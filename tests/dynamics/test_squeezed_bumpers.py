"""Bumpers squeezed beyond their length: what is said to help, helps."""

from __future__ import annotations

import re
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.report.warnings import warnings
from sim.scene import read_scene

PRESSED: dict[str, list[Any]] = {
    "a push": [{"push": {"cart": "A", "force": 20}}],
    "a slope": [{"incline": {"angle": "40 deg"}}],
    "a release": [{"release": {"between": ["A", "B"], "energy": 5, "at": 0, "stiffness": 400}}],
}


def told(law: str, stiffness: float, speed: float, effects: list[Any]) -> list[str]:
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0.2, "velocity": speed},
            "B": {"mass": 1, "position": 0.4},
        },
        "track": {"right": "wall", "length": 0.6},
        "contact": {"law": law, "restitution": 0.5, "stiffness": stiffness},
        "effects": effects,
        "until": 3,
    }
    return [remark.message for remark in warnings(run(read_scene(plain)))]


@pytest.mark.parametrize("what", PRESSED)
@pytest.mark.parametrize(("law", "soft"), [("bumper", 60), ("paper", 60), ("hertz", 300)])
def test_the_stiffness_that_is_named_is_enough_whatever_presses(
    law: str, soft: float, what: str
) -> None:
    found = told(law, soft, 0.0, PRESSED[what])
    assert found
    named = [re.search(r"Raise the stiffness to (?:at least )?([\d.e+]+)", one) for one in found]
    most = max(float(one[1]) for one in named if one)
    assert told(law, most, 0.0, PRESSED[what]) == []


def test_no_lower_speed_is_asked_for_where_a_push_presses() -> None:
    assert all("or let them meet" not in one for one in told("bumper", 100, 0, PRESSED["a push"]))
    fast = told("bumper", 100, 3, [{"friction": {"coefficient": 0.01, "carts": ["A"]}}])
    assert any("or let them meet at" in one for one in fast)
