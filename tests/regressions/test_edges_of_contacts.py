"""A spring whose place of rest is the very edge of a contact: each touch keeps a part of the speed.

There is no overlap at rest that would say what is small: speeds went down to 1e-118 m/s, touch by
touch, for as long as the run lasted, until two carts touched and parted at one instant without end.
"""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene

LEAST = 1e-20 * 0.2 / 600.0
"""m/s. Takes a cart no further than 1e-20 of its length in the run."""


def on_a_spring(effects: list[dict[str, Any]], **more: Any) -> Any:
    scene = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.3, "velocity": 0.3},
            "B": {"mass": 1.5, "position": 0.7},
        },
        "effects": effects,
        "until": 600,
    }
    return run(read_scene(scene | more))


@pytest.mark.parametrize("law", ["bumper", "paper", "push-only"])
@pytest.mark.parametrize("damping", [0.0, 1.0])
def test_the_touches_end_when_nothing_is_left_of_the_motion(law: str, damping: float) -> None:
    spring = {"between": ["A", "B"], "stiffness": 30, "length": 0, "damping": damping}
    done = on_a_spring(
        [{"spring": spring}], contact={"law": law, "restitution": 0.5, "stiffness": 300}
    )
    told = [e for e in done.record.events if e.kind == "contact"]
    assert told[-1].t < 60.0
    assert told[-1].before["A"] == pytest.approx(0.12, abs=1e-15)
    assert done.v == pytest.approx((0.12, 0.12), rel=1e-15)
    assert done.x[1] - done.x[0] == pytest.approx(0.2, abs=1e-13)


def test_beside_a_wall_the_cart_stands_at_its_edge() -> None:
    spring = {"between": ["left", "A"], "stiffness": 30, "length": 0, "damping": 0.2}
    done = on_a_spring(
        [{"spring": spring}],
        carts={"A": {"mass": 1.0, "position": 0.1, "velocity": 0.3}},
        track={"left": "wall"},
        contact={"law": "paper", "restitution": 0.5, "stiffness": 300},
    )
    speeds = [abs(e.before["A"]) for e in done.record.events if e.kind == "contact"]
    assert min(speeds) > LEAST
    assert done.v == (0.0,)
    assert done.x == (0.1,)
    assert done.outcome.kind == "came-to-rest"


def test_a_third_one_that_comes_later_finds_the_two_as_they_were_left() -> None:
    """They touch without a force, and the blow goes through both."""
    done = on_a_spring(
        [{"spring": {"between": ["A", "B"], "stiffness": 30, "length": 0}}],
        carts={
            "A": {"mass": 1.0, "position": 0.1, "velocity": 0.3},
            "B": {"mass": 1.5, "position": 0.5},
            "C": {"mass": 2.5, "position": 61.0, "velocity": -0.48},
        },
        contact={"law": "bumper", "restitution": 0.5, "stiffness": 300},
        until=160,
    )
    momentum = 0.3 - 2.5 * 0.48
    assert 1.0 * done.v[0] + 1.5 * done.v[1] + 2.5 * done.v[2] == pytest.approx(momentum)
    assert done.v[0] == pytest.approx(done.v[1], abs=1e-12)
    assert done.v[2] > done.v[1]
    assert done.ledger.imbalance() < 1e-14


def test_carts_on_a_spring_that_the_air_has_stopped_take_no_more_steps() -> None:
    spring = {"between": ["A", "B"], "stiffness": 30, "length": 0.2}
    done = on_a_spring([{"spring": spring}, {"drag": {"quadratic": 0.5, "linear": 0.5}}])
    assert done.v == (0.0, 0.0)
    assert done.x[1] - done.x[0] == pytest.approx(0.4, abs=1e-14)
    assert done.solvers["power-series"] < 1500
