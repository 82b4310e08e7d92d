"""Carts that start in touch, swing apart on a spring, and come back to just touch."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.motion.threshold import first_fall_to
from sim.laws.damped_oscillation import Rate
from sim.scene import read_scene


def swinging(law: str, restitution: float, until: float) -> Any:
    scene = {
        "carts": {
            "A": {"mass": 0.25, "position": 0.2, "velocity": 0.3},
            "B": {"mass": 0.5, "position": 0.4, "velocity": 0.3},
        },
        "contact": {"law": law, "restitution": restitution, "stiffness": 5000},
        "effects": [{"spring": {"between": ["A", "B"], "stiffness": 50, "length": 0.2}}],
        "until": until,
    }
    return run(read_scene(scene))


@pytest.mark.parametrize("law", ["bumper", "paper", "push-only", "hertz"])
@pytest.mark.parametrize("restitution", [0.05, 0.5, 0.9, 1.0])
def test_what_just_touches_swings_on(law: str, restitution: float) -> None:
    """Without approach there is nothing to lose. By rounding, 8e-16 m/s, a `paper` contact was
    pressed first, and then never told to end: it pulled, the swing was over, and the run was
    refused for its energy."""
    rate = math.sqrt(50 / (0.25 * 0.5 / 0.75))  # 1/s, of the spring: room 0.2 (1 − cos(rate t))
    done = swinging(law, restitution, 2.25 * 2.0 * math.pi / rate)
    assert done.x[1] - done.x[0] == pytest.approx(0.4, abs=1e-6)
    assert done.v[1] - done.v[0] == pytest.approx(0.2 * rate, rel=1e-6)
    assert done.ledger.imbalance() < 1e-13


@pytest.mark.parametrize("first", [1e-3, 1e-9, 8e-16, 1e-20, 0.0])
def test_a_swing_that_rises_first_for_however_short_falls_then(first: float) -> None:
    """The turn of 8e-16 m/s was told at 0 s: for the lowest place, where it is the highest."""
    rate = Rate(w0=174.0, beta=173.0, w=math.sqrt(347.0), regime="under")
    assert 0.0 < first_fall_to(rate, 2e-3, first, 1e-3) < 0.02


@pytest.mark.parametrize("law", ["bumper", "push-only"])
@pytest.mark.parametrize("restitution", [1e-4, 0.01, 0.3, 0.5, 0.8, 0.9, 1.0])
@pytest.mark.parametrize("angle", [-2, -3, -5])
def test_a_cart_laid_on_a_bumper_swings_between_no_force_and_twice_its_load(
    law: str, restitution: float, angle: float
) -> None:
    """Springing back it has no force just where it turns. By rounding it parted there, hopped by
    1e-11 m/s, touched again: 16 contacts of a cart that stays, or 14,600 of a dead bumper."""
    scene = {
        "carts": {"A": {"mass": 1.0, "position": 0.1, "length": 0.2}},
        "track": {"left": "wall", "right": "open", "length": 2.0},
        "contact": {"law": law, "restitution": restitution, "stiffness": 1000.0},
        "effects": [{"incline": {"angle": f"{angle} deg"}}],
        "until": 3,
    }
    done = run(read_scene(scene))
    kinds = [event.kind for event in done.record.events]
    load = 9.81 * math.sin(math.radians(-angle))
    assert kinds.count("contact") == 1
    assert "separate" not in kinds
    peak = next(event for event in done.record.events if event.kind == "peak")
    assert peak.force == pytest.approx(2.0 * load, rel=0.01 if law == "bumper" else 1.0)
    assert done.ledger.imbalance() < 1e-13
