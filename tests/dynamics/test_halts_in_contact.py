"""Who halts in a contact is held by friction, whatever rounding left of the contact's rate."""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene
from tests.fuzz.mirror import mirrored

G, STATIC, LIGHT = 9.81, 0.15, 0.245


def braked(v: float) -> dict[str, Any]:
    """B, of 1 kg, runs into A, goes on with it, and both are braked to a halt; air acts too."""
    return {
        "carts": {
            "A": {"mass": LIGHT, "position": 0.8, "velocity": v + 0.0236},
            "B": {"mass": 1.0, "position": 1.0, "velocity": v},
        },
        "track": {"left": "open", "right": "open", "length": 1.8},
        "contact": {"law": "paper", "restitution": 0, "stiffness": 931e3},
        "effects": [
            {"friction": {"coefficient": 0.1, "static": STATIC}},
            {"drag": {"linear": 3.0}},
        ],
        "until": 1.0,
    }


@pytest.mark.parametrize("v", [-0.065, -0.077, -0.083, -0.101, -0.103, -0.104])
def test_who_halts_in_a_contact_that_friction_can_balance_stays(v: float) -> None:
    """It was pushed off again by signs of rounding, and stopped 1e-8 m from where it had been."""
    done = run(read_scene(braked(v)))
    touch = next(e for e in done.record.events if e.kind == "contact")
    stops = [e for e in done.record.events if e.kind == "stop"]
    assert len(stops) == 2
    assert not [e for e in done.record.events if e.t > touch.t and e.kind in ("start", "separate")]
    overlap = done.x[0] - (done.x[1] - 0.2)
    assert 0.0 < 931e3 * overlap < STATIC * LIGHT * G
    assert stops[1].t - stops[0].t < 1e-5
    other = run(read_scene(mirrored(braked(v))))
    assert done.x == pytest.approx([1.8 - x for x in reversed(other.x)], abs=1e-14)
