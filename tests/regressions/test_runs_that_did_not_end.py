"""Runs that did not come back, found by the adversary (`tests.fuzz`); their plainest scenes.

What made them endless is that the same few events repeated without motion, so their number is what
is tested, not the time.
"""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene
from tests.fuzz.kinds import scene_of
from tests.reference.effects import integrate
from tests.regressions.given import cart

HELD_BY_A_SPRING = {
    "carts": {"A": cart(0.1), "B": cart(0.3)},
    "contact": {"law": "push-only", "stiffness": 100},
    "effects": [{"spring": {"between": ["A", "B"], "stiffness": 50, "length": 0.1}}],
    "until": 5,
}
DEAD_BESIDE_ELASTIC = {
    "carts": {"A": cart(1, 1), "B": cart(1.764, 0, 2), "C": cart(2, -0.5)},
    "contact": {
        "restitution": 1,
        "stiffness": 800,
        "pairs": {"B-C": {"restitution": 0, "stiffness": 100}},
    },
    "until": 10,
}
TURNED_BACK_AT_THE_EDGE = {
    "carts": {"A": cart(0.2, 0, 0.51), "B": cart(0.577, -0.3, 2.4)},
    "contact": {"law": "push-only-uncorrected", "restitution": 1, "stiffness": 997000},
    "effects": [{"spring": {"between": ["A", "B"], "stiffness": 3.52, "length": 0}}],
    "until": 3,
}
SLIPS_AS_IT_PARTS = {
    "carts": {"A": cart(0.2, 1, 0.271), "B": cart(0.4, -0.3)},
    "track": {"left": "wall", "right": "wall", "length": 0.57},
    "contact": {"law": "bumper", "restitution": 0, "stiffness": 123000},
    "effects": [
        {"push": {"cart": "A", "force": -5, "until": 0.1}},
        {"push": {"cart": "B", "force": 0.1, "until": 0.3}},
        {"push": {"cart": "B", "force": -1}},
        {"friction": {"coefficient": 0.1, "carts": ["A"]}},
    ],
    "until": 3,
}
HERTZ_IN_TOUCH = {
    "carts": {"A": cart(0.5), "B": cart(0.6999)},
    "contact": {"law": "hertz", "stiffness": 100},
    "start": {"overlap": True},
    "until": 1,
}
PUSH_THROUGH_DEAD_ROW = {
    "carts": {
        "A": cart(0.1, 0.317),
        "B": cart(0.3),
        "C": cart(0.5, 0, 4.58),
        "D": cart(0.7),
        "E": cart(0.9, 0, 3.47),
    },
    "track": {"left": "wall", "right": "wall", "length": 1.01},
    "contact": {
        "restitution": 0,
        "stiffness": 780,
        "pairs": {"E-right": {"law": "push-only", "restitution": 0.05, "stiffness": 47700}},
    },
    "effects": [{"incline": {"angle": "-5 deg"}}],
    "until": 1,
}
COLLAPSE = {
    "carts": {"A": cart(0.2), "B": cart(0.4), "C": cart(0.9, -1, 20)},
    "contact": {"law": "instant", "restitution": 0.05},
    "until": 2,
}
FEATHER_BETWEEN_ROCKS = {
    "carts": {
        "A": cart(0.35, 0, 0.2) | {"length": 0.1},
        "B": cart(0.8, 0.5, 1e6),
        "C": cart(1.25, 1, 1e-6) | {"length": 0.1},
        "D": cart(1.4, -1, 3),
    },
    "track": {"left": "wall", "right": "wall", "length": 2},
    "contact": {"law": "paper", "stiffness": 1e6, "restitution": 0.3},
    "until": 5,
}

ENDLESS: dict[str, tuple[dict[str, Any], int]] = {
    "a spring holds a pair at the edge of contact": (HELD_BY_A_SPRING, 50),
    "a dead bumper beside an elastic one": (DEAD_BESIDE_ELASTIC, 200),
    "an elastic pair is let go at no overlap": (TURNED_BACK_AT_THE_EDGE, 50),
    "a cart begins to slip as it comes apart": (SLIPS_AS_IT_PARTS, 60),
    "two spheres that touch at rest": (HERTZ_IN_TOUCH, 10),
    "a push runs through a row of dead bumpers": (PUSH_THROUGH_DEAD_ROW, 100_000),
    "three that touch are hit in turn": (COLLAPSE, 20),
    "a spring draws a cart from the dead bumper of a wall": (scene_of("scales", 60003), 500),
    "a maximum is sought more finely than its time is told": (FEATHER_BETWEEN_ROCKS, 500),
    "so slowly at first that only rounding tells": (scene_of("touching springs", 21011), 50),
}


@pytest.mark.parametrize("what", ENDLESS)
def test_a_run_ends_after_as_many_events_as_it_has(what: str) -> None:
    plain, most = ENDLESS[what]
    done = run(read_scene(plain), max_events=most)
    assert done.stopped is None
    assert done.ledger.imbalance() < 1e-10


@pytest.mark.parametrize(
    "plain",
    [HELD_BY_A_SPRING, TURNED_BACK_AT_THE_EDGE, HERTZ_IN_TOUCH],
    ids=["spring", "edge", "hertz"],
)
def test_what_ends_now_ends_as_the_integration_does(plain: dict[str, Any]) -> None:
    scene = read_scene(plain)
    done, expected = run(scene), integrate(scene)
    assert done.v == pytest.approx(expected.v, abs=1e-9)
    assert done.x == pytest.approx(expected.x, abs=1e-9)


def test_three_that_collapse_go_on_with_the_velocity_of_their_centre_of_mass() -> None:
    done = run(read_scene(COLLAPSE))
    assert done.v == pytest.approx((-20 / 22,) * 3, rel=1e-15)
    assert done.ledger.imbalance() < 1e-15


def test_three_above_the_critical_restitution_do_not_collapse_at_once() -> None:
    """Equal masses part for e > 7 − 4 sqrt 3: the last two impacts leave them apart."""
    plain = {
        "carts": {"A": cart(0.2), "B": cart(0.4), "C": cart(0.9, -1)},
        "contact": {"law": "instant", "restitution": 0.5},
        "until": 2,
    }
    done = run(read_scene(plain))
    assert done.record.counts["contact"] == 3
    assert done.v[0] < done.v[1] < done.v[2]


AT_REST = {
    "carts": {"A": cart(0.1), "B": cart(0.3), "C": cart(0.5)},
    "track": {"left": "wall", "length": 2},
    "contact": {"law": "paper", "restitution": 0.4, "stiffness": 20_000},
    "effects": [{"incline": {"angle": "-5 deg"}}],
    "until": 600,
}


def test_a_row_that_has_come_to_rest_takes_no_steps_until_its_load_changes() -> None:
    ten = run(read_scene(AT_REST | {"until": 10}))
    long = run(read_scene(AT_REST))
    assert long.solvers["power-series"] == ten.solvers["power-series"]
    assert long.v == (0.0, 0.0, 0.0)


def test_what_rests_presses_as_statics_says() -> None:
    """Each bumper carries the carts above it: k o = m g sin(angle) times their number."""
    import math

    done = run(read_scene(AT_REST))
    weight = 9.81 * math.sin(math.radians(5))
    edges = [0.0, *(x + 0.1 for x in done.x)]
    for k, x in enumerate(done.x):
        overlap = edges[k] - (x - 0.1)
        assert overlap == pytest.approx((3 - k) * weight / 20_000, abs=1e-14)
    assert done.ledger.impulses["walls"] == pytest.approx(3 * weight * 600, rel=1e-12)


OVERLAPS: dict[str, dict[str, Any]] = {
    "a row of overlaps": {
        "carts": {"A": cart(0.1, -1, 0.84), "B": cart(0.29, -1, 0.391), "C": cart(0.47, -1, 2.11)},
        "contact": {"law": "paper", "restitution": 0.5, "stiffness": 461},
    },
    "two spheres": {
        "carts": {"A": cart(0.35, 0, 0.467), "B": cart(0.53, -1, 1.06)},
        "contact": {"law": "hertz", "restitution": 0.8, "stiffness": 3170},
    },
}


@pytest.mark.parametrize("what", OVERLAPS)
def test_overlaps_at_the_start_all_push(what: str) -> None:
    scene = read_scene(OVERLAPS[what] | {"start": {"overlap": True}, "until": 1})
    done, expected = run(scene), integrate(scene)
    assert done.v == pytest.approx(expected.v, abs=1e-9)
    assert done.ledger.imbalance() < 1e-11


def test_a_touch_in_the_middle_of_an_integrated_step_costs_no_figures() -> None:
    """C meets B while A and B, two spheres, press each other."""
    plain = {
        "carts": {"A": cart(0.2, 1, 0.207), "B": cart(0.41, 0.5), "C": cart(0.71)},
        "track": {"left": "wall", "length": 2},
        "contact": {"law": "hertz", "restitution": 0.8, "stiffness": 369},
        "effects": [
            {"spring": {"between": ["A", "B"], "stiffness": 1.42, "length": 0.1, "damping": 0.3}}
        ],
        "until": 3,
    }
    assert run(read_scene(plain)).ledger.imbalance() < 2e-11


def test_a_bumper_that_begins_to_be_pressed_further_is_not_at_its_deepest_then() -> None:
    """Its load equals its force; what is left of their difference says nothing about the growth.

    A light cart between two bumpers that do not spring back, one of which is always pressed
    further: none of its 450 steps ends where it begins, because a bumper turns or is climbed again.
    """
    plain = {
        "carts": {
            "A": {"mass": 0.002, "position": 0.1, "velocity": 0.5},
            "B": {"mass": 1680.0, "position": 0.4, "velocity": -1.0},
        },
        "track": {"left": "wall", "right": "open", "length": 1.1},
        "contact": {"law": "bumper", "restitution": 0, "stiffness": 1380.0},
        "until": 0.5,
    }
    done = run(read_scene(plain))
    steps = [part for part in done.record.solved if part.end < done.t]
    assert len(steps) > 300
    causes = [[e.cause for e in part.solver.ends] for part in steps if part.begin == part.end]
    assert not [found for found in causes if "turn" in found or "climb" in found]
    assert done.ledger.imbalance() < 1e-13


MANY_SHORT_STEPS = {
    ("dead bumpers", 81): 900,  # a stiff line that rings on beside soft ones: 6,400 steps
    ("long runs", 24): 150,  # ten minutes of drag on two that a damper holds: 22,000
    ("releases", 64): 120,  # the same, much stiffer, for two seconds: 2,400
    ("magnets", 62): 600,  # a row that a magnet pushes on: 2,000
}


@pytest.mark.parametrize(("kind", "seed"), MANY_SHORT_STEPS)
def test_a_swing_that_changes_nothing_any_more_takes_no_steps(kind: str, seed: int) -> None:
    done = run(read_scene(scene_of(kind, seed)), max_steps=MANY_SHORT_STEPS[kind, seed])
    assert done.stopped is None
    assert done.ledger.imbalance() < 1e-14


def test_bumpers_that_part_by_less_than_the_last_bit_of_their_overlap_have_parted() -> None:
    """Friction and a ringing contact accelerate the two alike: they part for 2e-7 s, by 7e-19 m."""
    plain = scene_of("dead bumpers", 70)
    done = run(read_scene(plain | {"until": 0.08178}), max_events=2_000)
    assert done.stopped is None
    assert done.ledger.imbalance() < 1e-14
