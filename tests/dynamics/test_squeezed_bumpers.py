"""Bumpers squeezed beyond their length: what is said to help, helps."""

from __future__ import annotations

import re
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.report.warnings import warnings
from sim.scene import read_scene

PRESSED: dict[str, list[Any]] = {
    "a push": [{"push": {"cart": "A", "force": 20}}],
    "a slope": [{"incline": {"angle": "40 deg"}}],
    "a release": [{"release": {"between": ["A", "B"], "energy": 5, "at": 0, "stiffness": 400}}],
}


def told(law: str, stiffness: float, speed: float, effects: list[Any]) -> list[str]:
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0.2, "velocity": speed},
            "B": {"mass": 1, "position": 0.4},
        },
        "track": {"right": "wall", "length": 0.6},
        "contact": {"law": law, "restitution": 0.5, "stiffness": stiffness},
        "effects": effects,
        "until": 3,
    }
    return [remark.message for remark in warnings(run(read_scene(plain)))]


@pytest.mark.parametrize("what", PRESSED)
@pytest.mark.parametrize(("law", "soft"), [("bumper", 60), ("paper", 60), ("hertz", 300)])
def test_the_stiffness_that_is_named_is_enough_whatever_presses(
    law: str, soft: float, what: str
) -> None:
    found = told(law, soft, 0.0, PRESSED[what])
    assert found
    named = [re.search(r"Raise the stiffness to (?:at least )?([\d.e+]+)", one) for one in found]
    most = max(float(one[1]) for one in named if one)
    assert told(law, most, 0.0, PRESSED[what]) == []


def test_no_lower_speed_is_asked_for_where_a_push_presses() -> None:
    assert all("or let them meet" not in one for one in told("bumper", 100, 0, PRESSED["a push"]))
    fast = told("bumper", 100, 3, [{"friction": {"coefficient": 0.01, "carts": ["A"]}}])
    assert any("or let them meet at" in one for one in fast)


def of(carts: dict[str, Any], **parts: Any) -> list[str]:
    contact = {"law": "bumper", "restitution": 0.5, "stiffness": 60}
    plain = {"carts": carts, "track": {"length": 2}, "contact": contact, "until": 3} | parts
    return [remark.message for remark in warnings(run(read_scene(plain)))]


@pytest.mark.parametrize("where", ["two carts", "a cart at a wall"])
@pytest.mark.parametrize(("law", "soft"), [("bumper", 60), ("paper", 60), ("hertz", 300)])
def test_the_speed_that_is_named_is_slow_enough_and_a_little_more_is_not(
    law: str, soft: float, where: str
) -> None:
    def meeting(speed: float) -> list[str]:
        carts: dict[str, Any] = {"A": {"mass": 1, "position": 0.2, "velocity": speed}}
        track = {"length": 0.6, "right": "wall"}
        if where == "two carts":
            carts["B"], track = {"mass": 1, "position": 0.5}, {"length": 2}
        contact = {"law": law, "restitution": 0.5, "stiffness": soft}
        return of(carts, track=track, contact=contact)

    (found,) = meeting(2.5)
    named = re.search(r"or let them meet at ([\d.]+) m/s or less", found)
    assert named
    assert meeting(float(named[1])) == []
    assert len(meeting(1.02 * float(named[1]))) == 1


def test_the_bumpers_that_are_squeezed_most_are_told_of_first() -> None:
    found = of({
        "A": {"mass": 1, "position": 0.2, "velocity": 1},
        "B": {"mass": 1, "position": 0.6, "velocity": -0.5},
        "C": {"mass": 1, "position": 1.6, "velocity": -3},
    })  # fmt: skip
    depths = [float(match[1]) for one in found if (match := re.search(r"by ([\d.]+) cm", one))]
    assert len(depths) == 2
    assert depths == sorted(depths, reverse=True)
    assert "between B and C" in found[0]  # not the first that met


def test_no_stiffness_is_named_where_carts_begin_squeezed_as_far_as_their_bumpers() -> None:
    """None would do: they are as deep before anything moves."""
    carts = {
        "A": {"mass": 1, "position": 0.2, "velocity": 1},
        "B": {"mass": 1, "position": 0.31},
    }
    (found,) = of(carts, start={"overlap": True})
    assert found.endswith("but there is room for 8 cm.")


@pytest.mark.parametrize(("bumper", "told"), [("0 cm", 0), ("1 cm", 1)])
def test_a_cart_without_a_bumper_asks_the_wall_to_give_way(bumper: str, told: int) -> None:
    carts = {"A": {"mass": 1, "position": 0.2, "velocity": 1, "bumper_length": bumper}}
    assert len(of(carts, track={"length": 2, "right": "wall"})) == told


HARDLY = {"law": "bumper", "restitution": 1e-9}


def test_a_bumper_that_hardly_springs_back_is_told_of_where_it_is_held_with_others() -> None:
    carts = {
        "A": {"mass": 1, "position": 0.2, "velocity": 1},
        "B": {"mass": 1, "position": 0.6},
        "C": {"mass": 1, "position": 0.8},
    }
    (told,) = warnings(run(read_scene({"carts": carts, "contact": HARDLY, "until": 2})))
    assert told.code == "nearly-rigid"


@pytest.mark.parametrize("meets", [False, True], ids=["never", "alone"])
def test_nothing_is_told_of_one_that_meets_nobody_or_one_alone(meets: bool) -> None:
    """Though elsewhere a group of carts is computed together."""
    carts = {
        "A": {"mass": 1, "position": 0.2, "velocity": 1},
        "B": {"mass": 1, "position": 0.6},
        "C": {"mass": 1, "position": 8, "velocity": 1 if meets else 0},
        "D": {"mass": 1, "position": 8.5},
    }
    plain = {
        "carts": carts,
        "contact": {"pairs": {"C-D": HARDLY}},
        "effects": [{"magnets": {"between": ["A", "B"], "strength": 0.001}}],
        "until": 2,
    }
    done = run(read_scene(plain))
    assert done.solvers["power-series"]
    assert warnings(done) == ()
