"""Came to rest, or only turning round as the run ends."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import stepped
from sim.scene import read_scene

PUSH = {"push": {"cart": "A", "force": -1}}
STOPPED = {"push": {"cart": "A", "force": -1, "until": 1}}
SLOPE = {"incline": {"angle": "-5 deg"}}
WEIGHT = 9.81  # N, of 1 kg


def alone(*effects: dict[str, Any], v: float = 1, **more: Any) -> dict[str, Any]:
    carts = {"A": {"mass": 1, "position": 0.5, "velocity": v}}
    return {"carts": carts, "effects": list(effects), "until": 1} | more


def pressed(law: str, v: float = 0.0) -> dict[str, Any]:
    """Two carts down a slope against a wall, with what stops them for good."""
    carts = {
        "A": {"mass": 1, "position": 0.1, "velocity": 0},
        "B": {"mass": 2, "position": 0.3, "velocity": v},
    }
    contact = {"law": law, "restitution": 0.3} | ({} if law == "instant" else {"stiffness": 4000})
    return {"carts": carts, "track": {"left": "wall"}, "contact": contact, "effects": [SLOPE],
            "until": 30}  # fmt: skip


TURNING: dict[str, dict[str, Any]] = {
    "a push": alone(PUSH),
    "a push with friction too weak to hold": alone(
        {"push": {"cart": "A", "force": -0.75}}, {"friction": {"coefficient": 0.25 / WEIGHT}}
    ),
    "a slope with drag": alone(
        {"push": {"cart": "A", "force": -1}}, {"drag": {"linear": 1}}, v=1, until=0.6931471805599453
    ),
    "a spring": alone(
        {"spring": {"between": ["left", "A"], "stiffness": 1, "length": 0.4}},
        until=1.5707963267948966, track={"left": "wall"},
    ),
    "a push that comes": alone({"push": {"cart": "A", "force": 1, "from": 1}}, v=0),
}  # fmt: skip

RESTING: dict[str, dict[str, Any]] = {
    "a push that ends as it stops": alone(STOPPED),
    "friction that holds": alone({"friction": {"coefficient": 0.2}}, until=2),
    "friction that stops it as the run ends": alone({"friction": {"coefficient": 1 / WEIGHT}}),
    "friction that holds it on a slope": alone({"friction": {"coefficient": 0.2}}, SLOPE, until=2),
    "nothing at all": alone(v=0),
    "a pressed row with dampers": pressed("paper", -0.2),
    "a pressed row of hard carts": pressed("instant", -0.2),
    "velcro on the wall": alone(
        v=-1, track={"left": "wall"}, contact={"law": "velcro"}
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", TURNING)
def test_a_cart_that_turns_round_as_the_run_ends_has_not_come_to_rest(name: str) -> None:
    done = run(read_scene(TURNING[name]))
    assert done.v == pytest.approx([0.0], abs=1e-12)
    assert done.outcome.kind == "reached-end"


@pytest.mark.parametrize("name", RESTING)
def test_a_cart_that_stands_still_and_stays_so_has_come_to_rest(name: str) -> None:
    plain = RESTING[name]
    done = run(read_scene(plain))
    later = run(read_scene(plain | {"until": float(plain["until"]) + 1}))
    assert later.x == pytest.approx(done.x, abs=1e-11)
    assert done.outcome.kind == "came-to-rest"


@pytest.mark.parametrize("keep", [True, False])
def test_the_acceleration_at_the_end_is_that_of_newtons_second_law(keep: bool) -> None:
    done = run(read_scene(alone(PUSH, {"drag": {"linear": 0.5}}, v=2)), keep_motion=keep)
    assert done.a == pytest.approx([-1 - 0.5 * done.v[0]], rel=1e-15)
    assert run(read_scene(RESTING["nothing at all"])).a == (0.0,)


def test_a_stepped_run_tells_a_turn_from_rest_too() -> None:
    turning = stepped(read_scene(alone(PUSH)), MethodChoice("verlet", step=1 / 64)).run
    assert turning.v[0] == pytest.approx(0.0, abs=1e-12)
    assert turning.outcome.kind == "reached-end"
    resting = stepped(read_scene(alone(v=0)), MethodChoice("verlet", step=1 / 64)).run
    assert resting.outcome.kind == "came-to-rest"


def test_carts_that_lie_against_a_wall_lie_there_however_long() -> None:
    """By a contact that gives nothing there is no swing to fade: they do not creep by rounding."""
    plain = pressed("instant") | {"contact": {"law": "instant", "restitution": 1}}
    plain["carts"]["B"]["position"] = 0.5
    plain["effects"] = [{"incline": {"angle": "-10 deg"}}, {"friction": {"coefficient": 0.05}}]
    soon, late = (run(read_scene(plain | {"until": t})) for t in (20, 600))
    assert soon.v == (0.0, 0.0)
    assert late.x == soon.x


def test_a_swing_of_which_nothing_is_left_has_a_result_and_its_greatest_force() -> None:
    """B swings once on A's bumper, back to where it was at rest, and sticks to the wall there.

    Of all energy of the run 1e-22 J is left, and half of that was rounding: it was refused.
    """
    stuck = {"law": "push-only", "restitution": 1, "stiffness": 2000}
    plain = {
        "carts": {"A": {"mass": 1, "position": 0.1}, "B": {"mass": 0.5, "position": 0.3}},
        "track": {"left": "wall", "right": "wall", "length": 0.4},
        "contact": {"law": "velcro", "pairs": {"A-B": stuck}},
        "effects": [SLOPE],
        "until": 3,
    }
    done = run(read_scene(plain))
    weight = 0.5 * WEIGHT * math.sin(math.radians(5))
    swing = 2 * math.pi * math.sqrt(0.5 / 2000)
    caught = next(e for e in done.record.events if e.bodies == ("B", "right"))
    peak = next(e for e in done.record.events if e.kind == "peak")
    # it comes back without speed: an overlap to its last figure tells the instant to half of them
    assert caught.t == pytest.approx(swing, rel=2e-8)
    assert peak.bodies == ("A", "B")
    assert peak.force == pytest.approx(2 * weight, rel=1e-9)
    assert done.x == pytest.approx((0.1, 0.3), abs=1e-12)
    assert done.ledger.imbalance() < 1e-12
