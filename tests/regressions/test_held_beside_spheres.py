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
from tests.fuzz.mirror import mirrored

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


@pytest.mark.parametrize("count", [1, 2, 3])
@pytest.mark.parametrize("turned", [False, True])
def test_dead_bumpers_that_a_sphere_presses_to_a_wall_let_go_with_it(
    count: int, turned: bool
) -> None:
    """Its force falls as (t − t₀)⁶ of its own time: where rounding had hidden the rest of it they
    let go, were pressed again, and so on, 24,133 times in a row of three."""
    names = "ABC"[:count]
    carts: dict[str, Any] = {
        name: {"mass": 1, "position": round(0.1 + 0.2 * k, 9), "velocity": 0}
        for k, name in enumerate(names)
    }
    carts["S"] = {"mass": 1, "position": round(0.2 + 0.2 * count, 9), "velocity": -1}
    pairs = {f"{names[-1]}-S": {"law": "hertz", "restitution": 1, "stiffness": 101}}
    plain: dict[str, Any] = {
        "carts": carts,
        "track": {"left": "wall", "right": "open", "length": 5},
        "contact": {"law": "bumper", "restitution": 0, "stiffness": 952, "pairs": pairs},
        "until": 3,
    }
    done = run(read_scene(mirrored(plain) if turned else plain))
    parted = [event for event in done.record.events if event.kind == "separate"]
    assert len(parted) == count + 1
    assert len({event.t for event in parted}) == 1
