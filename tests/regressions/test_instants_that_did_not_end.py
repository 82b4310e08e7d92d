"""Runs that stood still: two modes or two touches took turns at one instant, for ever."""

from __future__ import annotations

from collections import Counter
from typing import Any

import pytest

from sim.dynamics.loop.run import Run, run
from sim.scene import read_scene
from sim.scene.model import Scene
from tests.processor_time import budget
from tests.regressions.given import cart

SECONDS = 5.0
"""Of processor time: a hundred times what these runs take."""

CLOSED = 1e-12
"""Of all energies in play."""

SPREAD: dict[str, Any] = {
    "carts": {
        "A": {"mass": 0.659, "position": 0.1, "velocity": 0.2},
        "B": {"mass": 0.79, "position": 0.3},
        "C": {"mass": 1.0, "position": 0.5},
    },
    "track": {"left": "wall", "right": "wall", "length": 0.6},
    "contact": {"law": "instant", "restitution": 0.113},
    "effects": [
        {"spring": {"between": ["A", "B"], "stiffness": 2.95, "length": 0.1, "damping": 8}}
    ],
    "until": 5,
}
"""Three carts fill the track from wall to wall, and a spring spreads two of them."""

BETWEEN_DEAD_ONES: dict[str, Any] = {
    "carts": {
        "A": {"mass": 1.23, "position": 0.1},
        "B": {"mass": 2.8, "position": 0.3, "velocity": 0.5},
        "C": {"mass": 3.63, "position": 0.500668, "velocity": -0.905},
    },
    "track": {"left": "wall", "right": "open", "length": 0.826668},
    "contact": {
        "law": "bumper",
        "restitution": 0,
        "stiffness": 6930,
        "pairs": {"B-C": {"law": "bumper", "restitution": 0.3, "stiffness": 772}},
    },
    "effects": [{"push": {"cart": "C", "force": 0.1, "from": 2.5, "until": 2.6}}],
    "until": 3,
}
"""B presses A to the wall; both bumpers stay pressed in, and a little of its speed is left."""

PARTING: dict[str, Any] = {
    "carts": {
        "A": {"mass": 0.746, "position": 0.35, "velocity": 0.5},
        "B": {"mass": 1.0, "position": 0.55},
        "C": {"mass": 1.0, "position": 0.924},
        "D": {"mass": 0.25, "position": 1.124, "velocity": 0.5},
        "E": {"mass": 0.704, "position": 1.374, "velocity": -1.0},
    },
    "track": {"left": "wall", "right": "wall", "length": 1.474},
    "contact": {
        "law": "bumper",
        "restitution": 0.001,
        "stiffness": 306,
        "pairs": {
            "left-A": {"law": "bumper", "restitution": 0.001, "stiffness": 74.4},
            "B-C": {"law": "bumper", "restitution": 1e-9, "stiffness": 15800},
            "C-D": {"law": "bumper", "restitution": 0, "stiffness": 2070},
            "D-E": {"law": "bumper", "restitution": 0.001, "stiffness": 12.8},
            "E-right": {"law": "paper", "restitution": 0, "stiffness": 35.9},
        },
    },
    "effects": [{"push": {"cart": "C", "force": -1}}],
    "until": 0.554,
}
"""D, which E still presses a little, and C touch with one velocity and nearly one acceleration."""


@pytest.mark.parametrize("plain", [SPREAD, BETWEEN_DEAD_ONES, PARTING])
def test_the_run_goes_on_and_closes_its_accounts(plain: dict[str, Any]) -> None:
    finished = _run(read_scene(plain))
    assert finished.stopped is None
    assert finished.t == plain["until"]
    assert finished.ledger.imbalance() < CLOSED


def test_what_a_spring_spreads_between_walls_rests_without_a_contact_between_the_two() -> None:
    """The spring alone carries: between A and B nothing presses, and nothing moves."""
    finished = _run(read_scene(SPREAD))
    assert finished.x == pytest.approx((0.1, 0.3, 0.5), abs=1e-15)
    assert finished.v == pytest.approx((0.0, 0.0, 0.0), abs=1e-15)


def test_dead_bumpers_that_are_hit_in_turn_end_with_one_velocity() -> None:
    """Each round leaves 0.69 of the speed: after eighty rounds A and B stand at the wall."""
    finished = _run(read_scene(BETWEEN_DEAD_ONES))
    assert finished.v[:2] == pytest.approx((0.0, 0.0), abs=1e-15)
    at_once = Counter(event.t for event in finished.record.events)
    assert max(at_once.values()) < 400


def _run(scene: Scene) -> Run:
    with budget(SECONDS):
        return run(scene)


def test_impacts_in_turn_between_springs_end_when_rounding_is_all_that_is_left() -> None:
    """Two gaps handed the last bit of B's velocity to each other, 100,000 times at one instant."""
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0.6, "velocity": 1},
            "B": {"mass": 1, "position": 0.8, "velocity": 0.2},
            "C": {"mass": 4, "position": 1.0, "velocity": 0},
        },
        "contact": {"law": "instant", "restitution": 0},
        "effects": [
            {"spring": {"between": ["A", "B"], "stiffness": 1e-9, "length": 0.3}},
            {"spring": {"between": ["B", "C"], "stiffness": 1e-9, "length": 0.3}},
        ],
        "until": 1,
    }
    done = run(read_scene(plain), max_events=500)
    assert done.stopped is None
    assert done.v == pytest.approx((0.2 - 3e-10, 0.2, 0.2 + 0.75e-10), abs=1e-15)


def test_a_search_that_begins_where_a_room_has_just_cleared_ends() -> None:
    """Both glide to a stop while pressed in; set free, each slows down: 10 m/s − 2.925 m/s² t."""
    plain: dict[str, Any] = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.75, "velocity": 0.25},
            "B": {"mass": 1.0, "position": 0.95},
        },
        "contact": {"law": "bumper", "restitution": 0.05, "stiffness": 25},
        "effects": [
            {"release": {"between": ["A", "B"], "energy": 100, "at": 0.5}},
            {"friction": {"coefficient": 0.3}},
        ],
        "gravity": 9.75,
        "until": 1,
    }
    with budget(2.0):
        done = run(read_scene(plain))
    assert done.v == pytest.approx((-8.5375, 8.5375), rel=1e-14)
    assert done.ledger.imbalance() < 1e-14


def test_a_touch_of_those_that_move_alike_already_changes_no_velocity() -> None:
    """B meets C, C lies against D: the centre's velocity is theirs, not theirs and a last bit.

    With that bit each touch of two made the next two touch, 2,000 times at one instant.
    """
    plain: dict[str, Any] = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.125, "length": 0.25},
            "B": {"mass": 1.0, "position": 0.375, "length": 0.25},
            "C": {"mass": 1.0, "position": 0.875, "length": 0.25},
            "D": {"mass": 0.3, "position": 1.1875, "velocity": 1.0, "length": 0.25},
        },
        "track": {"left": "wall", "length": 1.3125},
        "contact": {"law": "instant", "restitution": 0},
        "effects": [
            {"spring": {"between": ["left", "A"], "stiffness": 10000, "length": 0.125}},
            {"spring": {"between": ["B", "C"], "stiffness": 8, "length": 0.25}},
            {"incline": {"angle": "-12 deg"}},
            {"friction": {"coefficient": 0.3, "static": 0.45}},
        ],
        "gravity": 9.75,
        "until": 1,
    }
    done = run(read_scene(plain), max_events=1_000)
    assert done.stopped is None
    assert done.ledger.imbalance() < 1e-14


@pytest.mark.parametrize("law", ["push-only", "paper"])
@pytest.mark.parametrize("last_bits", [(0, -1, -3), (1, 0, -3), (2, 2, -2), (3, -1, -3)])
def test_three_in_touch_that_move_alike_but_for_last_bits_go_on(
    last_bits: tuple[int, ...], law: str
) -> None:
    """Alone they push each other by nothing, and go on; that a spring acts on two others far away
    changes nothing of it. Their contacts without an approach ended at once, without end."""
    carts = {
        name: cart(x, 0.5 + bits * 2.0**-53, mass)
        for name, x, bits, mass in zip(
            "ABC", (0.1, 0.3, 0.5), last_bits, (1, 0.25, 0.6), strict=True
        )
    }
    plain = {
        "carts": carts | {"D": cart(2.0), "E": cart(2.3)},
        "contact": {"law": law, "restitution": 0.6, "stiffness": 2500},
        "effects": [{"spring": {"between": ["D", "E"], "stiffness": 100, "length": 0.1}}],
        "until": 1,
    }
    done = run(read_scene(plain), max_events=500)
    assert done.stopped is None
    assert done.v[:3] == pytest.approx((0.5, 0.5, 0.5), rel=1e-15)
    assert done.x[:3] == pytest.approx((0.6, 0.8, 1.0), rel=1e-15)


def test_a_row_that_drag_presses_together_on_springs_without_a_force_goes_on_as_one() -> None:
    """All come to 0.2 m/s at once; drag takes most from the light ones, so that A pushes B and C:
    5 kg · dv/dt = −0.3 N s²/m² · v². The springs have no length, and no force where carts touch."""
    springs = [
        {"spring": {"between": pair, "stiffness": 20, "length": 0}}
        for pair in (["A", "B"], ["B", "C"])
    ]
    plain = {
        "carts": {
            "A": {"mass": 3, "position": 0.5, "velocity": 0.9},
            "B": {"mass": 1, "position": 0.7, "velocity": -0.7},
            "C": {"mass": 1, "position": 0.9, "velocity": -1},
        },
        "track": {"length": 2},
        "contact": {"law": "instant", "restitution": 0.05},
        "effects": [*springs, {"drag": {"quadratic": 0.1}}],
        "until": 0.3,
    }
    with budget(SECONDS):
        done = run(read_scene(plain))
    assert done.v == pytest.approx([1 / (1 / 0.2 + 0.3 / 5 * 0.3)] * 3, rel=1e-13)
    assert done.ledger.imbalance() < CLOSED
