"""Runs that were wrong, found by an independent method in 80 bits; their plainest scenes."""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.stepping.methods import Way
from sim.dynamics.stepping.recorded import stepped
from sim.scene import read_scene

IDLE_RELEASE = {
    "carts": {
        "A": {"mass": 1, "position": 0.1, "velocity": -0.5},
        "B": {"mass": 1, "position": 0.5},
    },
    "effects": [
        {"push": {"cart": "A", "force": 0.5}},
        {"release": {"between": ["A", "B"], "energy": 0.1, "at": 1}},
    ],
}
PARTING_OVERLAP = {
    "carts": {"A": {"mass": 1, "position": 0.1}, "B": {"mass": 1, "position": 0.28, "velocity": 1}},
    "contact": {"law": "push-only", "restitution": 0.3, "stiffness": 60},
    "start": {"overlap": True},
    "until": 2,
}
RESUMED_PARTING = {
    "carts": {
        "A": {"mass": 1.61, "position": 0.1, "velocity": 0.326},
        "B": {"mass": 1.61, "position": 0.3, "velocity": 0.364},
        "C": {"mass": 1, "position": 0.5},
        "D": {"mass": 1.61, "position": 0.7},
    },
    "contact": {
        "restitution": 0,
        "stiffness": 513,
        "pairs": {"A-B": {"law": "push-only", "restitution": 1, "stiffness": 126}},
    },
    "until": 10,
}

CASES: dict[str, tuple[dict[str, Any], tuple[float, ...]]] = {
    "an idle release leaves no old closing speed": (IDLE_RELEASE, (1.30397, 0.69603)),
    "an overlap that parts does not pull": (PARTING_OVERLAP, (0.0, 1.0)),
    "a contact that goes on alone does not pull": (
        RESUMED_PARTING,
        (0.057913, 0.241152, 0.241152, 0.241152),
    ),
}


@pytest.mark.parametrize("what", CASES)
def test_a_run_ends_as_the_oracle_says(what: str) -> None:
    plain, speeds = CASES[what]
    scene = read_scene(plain)
    done = run(scene)
    assert done.v == pytest.approx(speeds, abs=1e-5)
    assert done.ledger.imbalance() < 1e-12
    near = stepped(scene, Way("rk4-events", step=1e-3)).run
    assert done.v == pytest.approx(near.v, abs=1e-6)
