"""Contacts in which rounding is all that is left of a rate: they rest, and the run goes on."""

from __future__ import annotations

import math

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene
from tests.fuzz.kinds import scene_of
from tests.regressions.given import cart

RESTING = {
    "impacts at rest that part by rounding": ("rest on slopes", 60),
    "two that part while each swings on a spring of its own": ("springs", 5000),
    "three pressed on a slope, of which two part": ("rest on slopes", 13003),
    "a cart that a spring draws from the wall where it rests": ("scales", 31),
}


@pytest.mark.parametrize("what", RESTING)
def test_a_contact_that_rests_but_for_rounding_does_not_touch_for_ever(what: str) -> None:
    done = run(read_scene(scene_of(*RESTING[what])), max_events=5_000)
    assert done.stopped is None
    assert done.ledger.imbalance() < 1e-10


def test_a_bumper_pressed_further_by_rounding_alone_keeps_the_speed_of_its_bodies() -> None:
    """A hops on its steep line: pressed in just as deep every time, by rounding a bit deeper."""
    plain = {
        "carts": {
            "A": {"mass": 0.562, "position": 0.35},
            "B": {"mass": 1.0, "position": 0.55},
        },
        "contact": {"law": "bumper", "restitution": 0.8, "stiffness": 55000},
        "effects": [
            {"incline": {"angle": "2 deg"}},
            {"friction": {"coefficient": 0.1, "static": 0.15, "carts": ["B"]}},
        ],
        "until": 1,
    }
    assert run(read_scene(plain)).ledger.imbalance() < 1e-13


def test_what_friction_holds_between_bumpers_takes_no_steps() -> None:
    """C to E lie on B, all held by friction, and press A to the wall: they took a step of the
    bumper's swing after the other, to the end of the run."""
    plain = scene_of("rest on slopes", 530231)
    done, long = (run(read_scene(plain | {"until": t})) for t in (3, 300))
    assert done.v == long.v == (0.0,) * 5
    assert done.x == long.x
    steps = [sum(part.begin < run_.t for part in run_.record.solved) for run_ in (done, long)]
    assert steps[0] == steps[1] < 1_000  # a step at the very end has no length


def test_what_a_spring_presses_to_both_walls_rests_also_where_drag_is_of_v_squared() -> None:
    """k d = k_s (L − r) ± m g sin θ at the walls, r the room that is left between the two."""
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0.15, "velocity": 0.5},
            "B": {"mass": 1.7, "position": 0.4, "velocity": 0.5},
        },
        "track": {"left": "wall", "right": "wall", "length": 0.5},
        "contact": {"law": "paper", "restitution": 0, "stiffness": 783000},
        "effects": [
            {"spring": {"between": ["A", "B"], "stiffness": 64, "length": 0.25, "damping": 0.5}},
            {"incline": {"angle": "3 deg"}},
            {"drag": {"quadratic": 0.25}},
        ],
        "until": 300,
    }
    done = run(read_scene(plain))
    assert sum(done.solvers.values()) < 1_000
    assert done.v == (0.0, 0.0)
    (a, b), downhill = done.x, 9.81 * math.sin(math.radians(3))
    push = 64 * (0.25 - (b - a - 0.2))
    assert 783000 * (0.1 - a) == pytest.approx(push - downhill, abs=1e-9)
    assert 783000 * (b - 0.4) == pytest.approx(push + 1.7 * downhill, abs=1e-9)


def test_two_on_a_spring_come_to_rest_between_walls_that_hold_nothing_back() -> None:
    """e = 0 at both walls. At the last, rounding drew A from its wall and let B press it there a
    moment later: it touched and parted without end at one instant."""
    plain = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.1, "velocity": 0.5},
            "B": {"mass": 1.0, "position": 0.3, "velocity": 0.5},
        },
        "track": {"left": "wall", "right": "wall", "length": 0.6},
        "contact": {"law": "bumper", "restitution": 0, "stiffness": 200},
        "effects": [
            {"spring": {"between": ["A", "B"], "stiffness": 5, "length": 0.2, "damping": 0.1}}
        ],
        "until": 60,
    }
    done = run(read_scene(plain), max_events=5_000)
    assert done.stopped is None
    assert done.x == pytest.approx((0.1, 0.5), abs=1e-12)  # each at its wall, the spring at rest
    assert done.v == pytest.approx((0.0, 0.0), abs=1e-12)
    assert done.ledger.imbalance() < 1e-13


@pytest.mark.parametrize("until", [20, 60])
def test_two_that_a_damped_spring_leaves_just_touching_their_walls_come_to_the_end(
    until: int,
) -> None:
    """At its natural length the two touch both walls without a force. What is left of the motion
    goes below the rounding of the places, and wall and cart touched and parted a dozen times every
    billionth of a second."""
    plain = {
        "carts": {
            "A": {"mass": 0.5, "position": 0.1, "velocity": -0.5},
            "B": {"mass": 0.25, "position": 0.4, "velocity": 0.5},
        },
        "contact": {"law": "push-only", "restitution": 0.3, "stiffness": 1000},
        "track": {"length": 0.7, "left": "wall", "right": "wall"},
        "effects": [
            {"spring": {"between": ["A", "B"], "stiffness": 10, "length": 0.3, "damping": 0.1}}
        ],
        "until": until,
    }
    done = run(read_scene(plain), max_events=5_000)
    assert done.stopped is None
    assert done.x == pytest.approx((0.1, 0.6), abs=1e-14)
    assert done.v == pytest.approx((0.0, 0.0), abs=1e-14)
    assert done.ledger.imbalance() < 1e-12


@pytest.mark.parametrize("quadratic", [0, 2])
@pytest.mark.parametrize("law", ["bumper", "push-only", "hertz"])
def test_what_air_has_stopped_is_at_rest_at_the_edge_of_a_contact(
    law: str, quadratic: float
) -> None:
    """b times all ways together is the momentum that there was; the spring of no length is at rest
    where the two just touch. Rounding of their first speeds stayed in their velocities, though not
    in that of the gap, and drag of it held the spring strained to the end, in 6,000 steps."""
    air = {"linear": 10} | ({"quadratic": quadratic} if quadratic else {})
    plain = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.1, "velocity": 1.0},
            "B": {"mass": 7.0, "position": 0.3, "velocity": -1.0},
        },
        "contact": {"law": law, "restitution": 0.5, "stiffness": 500},
        "effects": [
            {"drag": air},
            {"spring": {"between": ["A", "B"], "stiffness": 1320, "length": 0}},
        ],
        "until": 300,
    }
    done = run(read_scene(plain), max_steps=1_000)
    assert done.stopped is None
    (a, b) = done.x
    assert b - a == pytest.approx(0.2, abs=1e-14)
    assert done.v == (0.0, 0.0)
    if not quadratic:
        assert (a - 0.1) + (b - 0.3) == pytest.approx((1.0 - 7.0) / 10, rel=1e-14)
    assert done.ledger.impulses["drag"] == pytest.approx(6.0, rel=1e-14)
    assert done.ledger.imbalance() < 1e-14


def test_faint_drag_of_v_squared_beside_linear_drag_leaves_a_sum_of_modes() -> None:
    """c v² is less than the last bit of b v: the spring's slow creep, k/b = 0.16/s, is one mode."""
    plain = {
        "carts": {
            "A": {"mass": 0.143, "position": 0.15, "velocity": -1e-12},
            "B": {"mass": 4.46, "position": 0.4},
        },
        "effects": [
            {"drag": {"linear": 10, "quadratic": 0.1}},
            {"spring": {"between": ["A", "B"], "stiffness": 1.57, "length": 0.05}},
        ],
        "until": 600,
    }
    done = run(read_scene(plain), max_steps=100)
    assert done.stopped is None
    assert sum(done.x) == pytest.approx(0.55 - 0.143e-12 / 10, abs=1e-15)
    assert done.ledger.impulses["drag"] == pytest.approx(0.143e-12, rel=1e-12)


def test_a_row_at_the_edge_of_its_contacts_that_gets_nowhere_any_more_is_over() -> None:
    """Springs of no length hold both just touching, and nothing presses them. What each touch left
    of the speed of the one before was followed down to 1e-169 m/s, some touches every second."""
    plain = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.1},
            "B": {"mass": 0.25, "position": 0.3, "velocity": 1.0},
        },
        "track": {"left": "wall"},
        "contact": {"law": "push-only", "restitution": 0.5, "stiffness": 3500},
        "effects": [
            {"drag": {"quadratic": 2}},
            {"spring": {"between": ["left", "A"], "stiffness": 100, "length": 0}},
            {"spring": {"between": ["A", "B"], "stiffness": 10, "length": 0}},
        ],
        "until": 1000,
    }
    done = run(read_scene(plain), max_steps=2_000)
    assert done.stopped is None
    assert done.v == (0.0, 0.0)
    assert done.x == pytest.approx((0.1, 0.3), abs=1e-14)
    assert done.ledger.imbalance() < 1e-14


def test_what_friction_has_stopped_is_not_set_going_by_the_rates_that_rounding_left() -> None:
    """A creeps to its place against the wall, B is stopped on the way: its velocity of nought did
    not fit the rate of the gap, followed from it again, and B halted once more at every step."""
    plain = {
        "carts": {"A": cart(0.1, 0.0, 0.3), "B": cart(0.3, -0.1, 0.3), "C": cart(0.6, 0.0, 0.3)},
        "track": {"left": "wall", "right": "open", "length": 1.5},
        "contact": {"law": "push-only", "restitution": 0.05, "stiffness": 4680},
        "effects": [
            {"drag": {"linear": 0.5}},
            {"friction": {"coefficient": 0.05, "static": 0.06}},
            {"magnets": {"between": ["B", "C"], "strength": 1e-4, "power": 4}},
        ],
        "until": 2,
    }
    finished = run(read_scene(plain))
    ends = [end for part in finished.record.solved for end in part.solver.ends]
    assert sum(end.cause == "halt" for end in ends) < 20
    assert finished.v[1] == 0.0
    assert finished.v[0] == pytest.approx(0.0, abs=1e-15)
