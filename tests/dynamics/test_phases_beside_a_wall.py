"""One cart beside a wall: drag, springs and bumper are one oscillation; hops are one phase each."""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample
from sim.scene import read_scene
from tests.reference.effects import integrate

SPRING = {"spring": {"between": ["left", "A"], "stiffness": 30, "length": 0.1, "damping": 0.2}}


def dragged(law: str, e: float, linear: float, *more: dict[str, Any]) -> dict[str, Any]:
    return {
        "carts": {"A": {"mass": 0.47, "position": 0.13, "velocity": -0.5}},
        "track": {"left": "wall", "right": "open", "length": 2},
        "contact": {"law": law, "restitution": e, "stiffness": 700},
        "effects": [{"drag": {"linear": linear}}, *more],
        "until": 2,
    }


@pytest.mark.parametrize("linear", [0.05, 3.0, 60.0])
@pytest.mark.parametrize(("law", "e"), [("paper", 0.4), ("paper", 0), ("bumper", 0.3)])
@pytest.mark.parametrize("more", [[], [SPRING], [{"incline": {"angle": "-2 deg"}}, SPRING]])
def test_a_dragged_cart_at_a_wall_moves_as_the_integration_does(
    law: str, e: float, linear: float, more: list[dict[str, Any]]
) -> None:
    scene = read_scene(dragged(law, e, linear, *more))
    done, expected = run(scene), integrate(scene)
    assert done.v == pytest.approx(expected.v, abs=2e-9)
    assert done.x == pytest.approx(expected.x, abs=2e-9)
    assert done.ledger.imbalance() < 1e-12


def test_the_work_of_drag_at_a_wall_is_the_integral_of_the_square_of_the_speed() -> None:
    """By Simpson's rule over the places in time."""
    done = run(read_scene(dragged("paper", 0.4, 3.0, SPRING)))
    count = 4000
    h = 2.0 / count
    squares = [sample(done, k * h)[1][0] ** 2 for k in range(count + 1)]
    weights = [1, *([4, 2] * (count // 2 - 1)), 4, 1]
    total = h / 3.0 * sum(w * s for w, s in zip(weights, squares, strict=True))
    assert done.ledger.works["drag"] == pytest.approx(-3.0 * total, rel=1e-6)


def test_drag_at_a_wall_takes_no_steps_however_long_the_run() -> None:
    plain = dragged("paper", 0, 0.05, SPRING) | {"until": 600}
    done = run(read_scene(plain))
    assert done.stopped is None
    assert done.solvers["power-series"] <= 5


def test_hops_within_the_remembered_overlap_take_one_phase_each_and_lose_nothing() -> None:
    plain = {
        "carts": {"A": {"mass": 0.8, "position": 0.1}},
        "track": {"left": "open", "right": "wall", "length": 0.5},
        "contact": {"law": "bumper", "restitution": 0.05, "stiffness": 75600},
        "effects": [{"incline": {"angle": "5 deg"}}],
        "until": 40,
    }
    done = run(read_scene(plain))
    hits = [event for event in done.record.events if event.kind == "contact"]
    assert len(hits) > 100
    speeds = [event.before["A"] for event in hits[1:]]
    assert speeds == pytest.approx([speeds[0]] * len(speeds), rel=1e-11)
    assert done.solvers["pair-phase"] <= len(hits) + 10
