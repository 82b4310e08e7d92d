"""Two that lie in touch beside a sphere, and that static friction holds together.

What presses them follows from friction alone (`motion/friction_shares.py`). Beside spheres nothing
pressed them: each was held to bear its own load, slipped the other way, and halted at once; with
every round the margin grew, until they went on with speeds that no force had given them.
"""

from __future__ import annotations

import math
from collections import Counter
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene

MU, SLOPE, HEAVY, LIGHT = 0.02, math.radians(8.0), 2.88, 0.263


def resting(effects: list[dict[str, Any]]) -> Any:
    scene = {
        "carts": {
            "A": {"mass": HEAVY, "position": 0.4},
            "B": {"mass": LIGHT, "position": 0.65, "velocity": 0.1},
        },
        "track": {"right": "wall", "length": 1.45},
        "contact": {
            "law": "hertz",
            "restitution": 0.05,
            "stiffness": 85.3,
            "pairs": {"A-B": {"law": "instant", "restitution": 0.2}},
        },
        "effects": [
            {"incline": {"angle": "8 deg"}},
            {"friction": {"coefficient": MU}},
            *effects,
        ],
        "until": 8,
    }
    return run(read_scene(scene))


@pytest.mark.parametrize(
    "effects", [[], [{"drag": {"quadratic": 0.01}}], [{"drag": {"linear": 0.01}}]]
)
def test_they_come_to_rest_once_and_stay(effects: list[dict[str, Any]]) -> None:
    done = resting(effects)
    told = Counter((event.kind, event.bodies) for event in done.record.events)
    assert done.v == (0.0, 0.0)
    assert told["start", ("A",)] == told["start", ("B",)] == 0
    assert done.ledger.imbalance() < 1e-14


def test_the_sphere_bears_what_friction_cannot() -> None:
    done = resting([{"drag": {"quadratic": 0.01}}])
    weight = (HEAVY + LIGHT) * 9.81
    overlap = done.x[1] + 0.1 - 1.45
    force = 85.3 * overlap**1.5
    held = weight * math.sin(SLOPE) - force
    assert abs(held) <= MU * weight * math.cos(SLOPE)
