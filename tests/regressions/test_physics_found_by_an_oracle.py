"""Runs that were wrong, found by an independent method in 80 bits; their plainest scenes."""

from __future__ import annotations

from typing import Any

import pytest

from sim.bridge.protocol import answer
from sim.dynamics.loop.run import run
from sim.dynamics.stepping.methods import MethodChoice
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
SPHERES_JUST_TURNING_TO_PULL = {
    "carts": {
        "A": {"mass": 1, "position": 0.4},
        "B": {"mass": 1, "position": 0.6, "velocity": -0.9},
        "C": {"mass": 1, "position": 1.0952, "velocity": 0.3513},
    },
    "track": {"left": "wall", "length": 2},
    "contact": {
        "law": "hertz",
        "stiffness": 109.2,
        "restitution": 0.2,
        "pairs": {
            "A-B": {"law": "bumper", "restitution": 0, "stiffness": 1000},
            "left-A": {"law": "bumper", "restitution": 0.5, "stiffness": 100},
        },
    },
    "effects": [{"incline": {"angle": -0.1992}}],
    "until": 2,
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
    near = stepped(scene, MethodChoice("rk4-events", step=1e-3)).run
    assert done.v == pytest.approx(near.v, abs=1e-6)


def test_spheres_whose_spring_and_damper_just_cancel_are_not_left_out_of_the_row() -> None:
    """A and B part at the very instant at which B-C turns from push to pull."""
    done = run(read_scene(SPHERES_JUST_TURNING_TO_PULL))
    speeds = (0.05598171469512609, 0.05598171469512609, -0.02686900143217931)
    assert done.v == pytest.approx(speeds, abs=1e-13)
    assert done.ledger.imbalance() < 1e-13


def test_a_gap_that_opens_first_and_is_closed_by_a_third_is_seen_to_close() -> None:
    """B rests at the wall, rolls away from it, and is pushed back into it by A."""
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0.1, "velocity": 0.14},
            "B": {"mass": 0.56, "position": 0.3},
        },
        "track": {"right": "wall", "length": 0.4},
        "contact": {"stiffness": 80},
        "effects": [{"incline": {"angle": -0.05}}],
        "until": 1,
    }
    header, _ = answer({"id": 1, "kind": "run", "scene": plain})
    touches = [
        e["t"] for e in header["events"] if e["kind"] == "contact" and "right" in e["bodies"]
    ]
    assert touches[0] == pytest.approx(0.079, abs=1e-3)


def test_a_trial_step_of_a_hertz_pair_does_not_leave_the_domain_of_magnets_beside_it() -> None:
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0.1, "velocity": 3},
            "B": {"mass": 1, "position": 0.31},
            "C": {"mass": 1, "position": 0.6},
        },
        "contact": {"law": "hertz", "stiffness": 2000},
        "effects": [{"magnets": {"between": ["B", "C"], "strength": 1e-6, "power": 2.5}}],
        "until": 1,
    }
    done = run(read_scene(plain))
    assert sum(done.v) == pytest.approx(3.0, abs=1e-9)
