"""Spheres that touch and are pressed together slowly: faint at first, but not for ever."""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene


@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
@pytest.mark.parametrize("friction", [None, 0.2])
def test_spheres_that_air_presses_together_push_each_other(
    restitution: float, friction: float | None
) -> None:
    """Whether their force stays faint was asked at the end of a stretch only, where they had
    parted again: for half a second they went through each other, and the run was refused."""
    effects: list[Any] = [{"incline": {"angle": "-5 deg"}}, {"drag": {"linear": 0.05}}]
    scene = {
        "carts": {
            "A": {"mass": 0.5, "position": 0.2, "velocity": 0.3},
            "B": {"mass": 0.25, "position": 0.4, "velocity": 0.3},
        },
        "contact": {"law": "hertz", "restitution": restitution, "stiffness": 1000},
        "effects": effects + ([{"friction": {"coefficient": friction}}] if friction else []),
        "until": 0.25,
    }
    done = run(read_scene(scene))
    deepest = max(e.force or 0.0 for e in done.record.events if e.kind == "peak")
    assert deepest > 1e-3  # N
    assert 0.2 - (done.x[1] - done.x[0]) < 5e-4  # it was 7e-4 m
    assert done.ledger.imbalance() < 1e-14
