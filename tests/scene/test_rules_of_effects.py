"""What cannot be meant of effects is told, whatever else the list holds and whatever is off."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import SceneError, apply_changes, read_scene

OFF = {"drag": {"linear": 1, "active": False}}
STEEP = {"incline": {"angle": 0.7}}
BAD: dict[str, dict[str, Any]] = {
    "effects.0.friction.static": {"friction": {"coefficient": 0.5, "static": 0.1}},
    "effects.0.push.until": {"push": {"cart": "A", "force": 1, "from": 2, "until": 1}},
}


def two(*effects: dict[str, Any], **more: Any) -> dict[str, Any]:
    carts = {"A": {"mass": 1, "position": 0.5}, "B": {"mass": 2, "position": 1.5}}
    return {"carts": carts, "effects": list(effects), "until": 0.5} | more


def told(plain: dict[str, Any]) -> list[str]:
    with pytest.raises(SceneError) as caught:
        read_scene(plain)
    return [problem.where for problem in caught.value.problems]


@pytest.mark.parametrize("where", BAD)
def test_an_effect_that_is_off_switches_no_rule_off(where: str) -> None:
    assert told(two(BAD[where])) == [where]
    assert told(two(BAD[where], OFF)) == [where]


@pytest.mark.parametrize("where", BAD)
def test_the_numbers_of_an_effect_that_is_off_are_looked_at_too(where: str) -> None:
    ((kind, body),) = BAD[where].items()
    assert told(two({kind: body | {"active": False}})) == [where]


@pytest.mark.parametrize("where", BAD)
def test_a_rule_is_told_beside_an_entry_that_was_not_understood(where: str) -> None:
    assert told(two(BAD[where], {"fricton": {"coefficient": 1}})) == ["effects.1.fricton", where]


@pytest.mark.parametrize("where", BAD)
def test_the_rules_hold_for_an_estimate_too(where: str) -> None:
    assert told(two(estimate=[BAD[where]])) == [where.replace("effects", "estimate")]


def test_two_inclines_under_one_cart_are_refused() -> None:
    """Each alone is fine; together they would pull with more than the cart weighs."""
    for second in (STEEP, {"incline": {"angle": -0.7}}, {"incline": {"angle": 0.1}}):
        assert told(two(STEEP, second)) == ["effects.1.incline"]
        assert told(two(STEEP, OFF, second)) == ["effects.2.incline"]
    only_b = {"incline": {"angle": 0.1, "carts": ["B"]}}
    assert told(two(STEEP, only_b)) == ["effects.1.incline"]


def test_a_track_may_be_bent_between_two_carts() -> None:
    bent = [
        {"incline": {"angle": 0.7, "carts": ["A"]}},
        {"incline": {"angle": -0.2, "carts": ["B"]}},
    ]
    done = run(read_scene(two(*bent, until=0.05)))
    assert done.a == pytest.approx([9.81 * math.sin(0.7), 9.81 * math.sin(-0.2)], rel=1e-15)


def test_one_incline_may_wait_beside_one_that_acts_and_take_its_place() -> None:
    waiting = {"incline": {"angle": 0.2, "active": False}}
    rough = {"friction": {"coefficient": 0.1}}
    plain = two(STEEP, waiting, rough, until=0.05)
    swapped = apply_changes(plain, {"effects.0.active": False, "effects.1.active": True})
    for one, angle in ((plain, 0.7), (swapped, 0.2)):
        down = 9.81 * (math.sin(angle) - 0.1 * math.cos(angle))
        assert run(read_scene(one)).a == pytest.approx([down, down], rel=1e-14)
    assert told(apply_changes(plain, {"effects.1.active": True})) == ["effects.1.incline"]


def test_a_pair_may_be_named_from_either_side():
    carts = {"A": {"mass": 1, "position": 0.5}, "B": {"mass": 1, "position": 1}}
    plain = {"carts": carts, "track": {"length": 2, "right": "wall"}, "until": 1}
    spring = {"stiffness": 5, "length": 0.4}
    for pair in (("A", "B"), ("B", "right")):
        for between in (pair, pair[::-1]):
            effects = [{"spring": {"between": list(between), **spring}}]
            (effect,) = read_scene({**plain, "effects": effects}).effects
            assert effect.between == pair
