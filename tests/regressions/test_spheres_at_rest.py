"""Spheres that come to rest: their force is no straight line, but at rest its tangent is enough."""

from __future__ import annotations

import itertools
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene


def down_to_the_wall(count: int, restitution: float, drag: dict[str, float], until: float) -> Any:
    scene = {
        "carts": {"ABC"[k]: {"mass": 1, "position": 0.2 + 0.3 * k} for k in range(count)},
        "track": {"right": "wall", "length": 0.3 * count + 0.2},
        "contact": {"law": "hertz", "restitution": restitution, "stiffness": 20000},
        "effects": [{"incline": {"angle": "5 deg"}}, *([{"drag": drag}] if drag else [])],
        "until": until,
    }
    return run(read_scene(scene))


@pytest.mark.parametrize("count", [1, 3])
@pytest.mark.parametrize("restitution", [0.0, 0.3])
@pytest.mark.parametrize("drag", [{}, {"quadratic": 0.1}])
def test_spheres_that_lie_against_a_wall_take_no_steps(
    count: int, restitution: float, drag: dict[str, float]
) -> None:
    """They stepped at rest, twenty times a second: and what rounding left of their velocities,
    1e-13 m/s, added up in their accounts to 9e-12 in a minute."""
    brief = down_to_the_wall(count, restitution, drag, 30.0)
    done = down_to_the_wall(count, restitution, drag, 600.0)
    assert done.v == (0.0,) * count
    more = sum(done.solvers.values()) - sum(brief.solvers.values())
    assert abs(more) <= 10  # where it comes to rest goes with rounding, as a step or two do
    assert done.x == pytest.approx(brief.x, abs=1e-13)
    assert done.ledger.imbalance() < 1e-13


def test_at_rest_a_sphere_carries_what_lies_on_it() -> None:
    done = down_to_the_wall(3, 0.3, {}, 60.0)
    pulled = 9.81 * 0.08715574274765817  # m/s², sin 5°
    edges = [x + 0.1 for x in done.x]
    rooms = [b - a - 0.2 for a, b in itertools.pairwise(edges)] + [1.1 - edges[-1]]
    pushes = [20000 * (-room) ** 1.5 for room in rooms]
    assert pushes == pytest.approx([pulled, 2 * pulled, 3 * pulled], rel=1e-9)
