"""Carts that stick, and cases that a random scene once found wrong."""

from __future__ import annotations

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import trajectory
from sim.scene import read_scene
from tests import registry


def test_stuck_carts_go_on_as_one():
    finished = run(registry.scene("sticky"))
    assert list(finished.v) == pytest.approx([0.3, 0.3], rel=1e-15)
    assert finished.x[1] - finished.x[0] == pytest.approx(0.2, rel=1e-15)
    assert finished.ledger.warmed == pytest.approx(0.5 * (2 / 3) * 0.81, rel=1e-14)


@pytest.mark.parametrize("place", [f"1.{k}" for k in range(10)])
@pytest.mark.parametrize("stiffness", [100, 700, 1300])
def test_a_hit_without_bounce_is_one_contact(place, stiffness):
    """Rounding left carts with a bumper of e = 0 that closed by 1e-17 m/s: a second contact."""
    plain = {
        "carts": {
            "A": {"mass": "0.5", "position": "0.4", "velocity": "0.6"},
            "B": {"mass": 1, "position": place},
        },
        "contact": {"restitution": 0, "stiffness": stiffness},
        "until": 4,
    }
    finished = run(read_scene(plain))
    kinds = [event.kind for event in finished.record.events]
    assert [kinds.count(kind) for kind in ("contact", "peak", "separate")] == [1, 1, 1]
    assert list(finished.v) == pytest.approx([0.2, 0.2], rel=1e-15)


def test_the_force_between_stuck_carts_is_what_accelerates_the_rear_one():
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0, "velocity": "0.6"},
            "B": {"mass": 2, "position": "0.4"},
            "C": {"mass": 3, "position": 1, "velocity": "-0.3"},
        },
        "contact": {"pairs": {"A-B": {"law": "velcro"}}, "stiffness": 600},
        "until": 3,
    }
    columns = trajectory(run(read_scene(plain))).columns
    for inner, outer, a in zip(
        columns[("F", "A-B")], columns[("F", "B-C")], columns[("a", "A")], strict=True
    ):
        assert -inner == pytest.approx(1 * a, abs=1e-12)
        assert inner - outer == pytest.approx(2 * a, abs=1e-12)


def test_two_that_stick_to_each_other_and_to_a_wall_never_touch_again():
    """What rounding leaves of their distance is no touch: once that ended in NaN."""
    plain = {
        "carts": {
            "A": {"mass": 1, "position": "0.4039", "velocity": "0.4"},
            "B": {"mass": 4, "position": "0.6578", "velocity": "-0.6"},
            "C": {"mass": 5, "position": "0.9617", "velocity": "-0.9"},
        },
        "track": {"left": "wall"},
        "contact": {
            "restitution": "0.5",
            "stiffness": 231,
            "pairs": {"left-A": {"law": "velcro"}, "A-B": {"law": "velcro"}},
        },
        "until": "0.8",
    }
    finished = run(read_scene(plain))
    contacts = [event.bodies for event in finished.record.events if event.kind == "contact"]
    assert contacts.count(("A", "B")) == contacts.count(("left", "A")) == 1
    assert finished.v[:2] == (0.0, 0.0)
    assert finished.v[2] == pytest.approx(-0.238820183, abs=1e-9)


def test_a_bumper_forgets_once_it_is_clear_while_a_neighbour_touches():
    """It cleared during another contact; an independent integration gives these velocities."""
    plain = {
        "carts": {
            "B": {"mass": "3.053", "position": "0.6", "velocity": "0.938"},
            "C": {"mass": 1, "position": "0.92", "velocity": "0.44"},
        },
        "track": {"right": "wall", "length": "1.03"},
        "contact": {
            "restitution": "0.9",
            "stiffness": "1757.84",
            "pairs": {"B-C": {"restitution": "0.9", "stiffness": "89.04"}},
        },
        "until": "0.7",
    }
    finished = run(read_scene(plain))
    assert list(finished.v) == pytest.approx([-0.78041, 0.29109], abs=1e-5)


def test_an_instant_contact_rests_while_a_neighbour_presses_on_it():
    """Infinitely many impacts before a finite time; then the wall holds, then lets go."""
    plain = {
        "carts": {
            "A": {"mass": 1, "position": "0.3", "velocity": 1},
            "B": {"mass": 1, "position": "0.6"},
        },
        "track": {"right": "wall", "length": "0.71"},
        "contact": {"pairs": {"B-right": {"law": "instant", "restitution": "0.5"}}},
        "until": 2,
    }
    finished = run(read_scene(plain))
    assert finished.outcome.kind == "reached-end"
    assert finished.record.counts["contact"] < 100
    assert finished.ledger.imbalance() < 1e-14


def test_a_curved_contact_counts_when_friction_is_judged():
    """A is stopped and pushed back by B at one instant: it never rests, and nothing is told."""
    plain = {
        "carts": {
            "A": {"mass": 1, "position": "0.5", "velocity": "0.4"},
            "B": {"mass": 1, "position": "0.8"},
        },
        "contact": {"law": "hertz", "stiffness": 2000},
        "effects": [{"friction": {"coefficient": "0.05"}}],
        "until": 4,
    }
    events = run(read_scene(plain)).record.events
    told = [(event.kind, event.bodies) for event in events if event.kind in ("start", "stop")]
    assert told == [("start", ("B",)), ("stop", ("A",)), ("stop", ("B",))]


def test_carts_come_to_rest_against_one_that_sticks_to_the_wall():
    """It has infinite mass then, and no momentum to share."""
    plain = {
        "carts": {
            "A": {"mass": 1, "position": "0.1"},
            "B": {"mass": 1, "position": "0.3", "velocity": "-0.1"},
            "C": {"mass": 1, "position": "0.6", "velocity": "-0.4"},
        },
        "track": {"left": "wall"},
        "contact": {
            "law": "instant",
            "restitution": "0.5",
            "pairs": {"left-A": {"law": "velcro"}},
        },
        "effects": [{"incline": {"angle": "-3 deg"}}],
        "until": 4,
    }
    finished = run(read_scene(plain))
    assert finished.v == (0.0, 0.0, 0.0)
    assert list(finished.x) == pytest.approx([0.1, 0.3, 0.5], abs=1e-12)
    assert finished.ledger.imbalance() < 1e-14


def test_a_run_that_stops_at_its_start_draws_the_forces_that_act_there():
    """Stopped among the impacts of a light cart between two others; the magnets push all along."""
    plain = {
        "carts": {
            "A": {"mass": 2, "position": "0.1", "velocity": 1},
            "B": {"mass": "0.05", "position": "0.3"},
            "C": {"mass": 1000, "position": "0.5"},
            "D": {"mass": 1, "position": "0.702"},
        },
        "contact": {"law": "instant", "restitution": "0.5"},
        "effects": [{"magnets": {"between": ["C", "D"], "strength": "1e-6", "power": 1}}],
        "until": "0.05",
    }
    finished = run(read_scene(plain), max_events=3)
    assert finished.t == 0.0
    columns = trajectory(finished).columns
    assert list(columns["F", "C-D"]) == pytest.approx([1e-6 / 0.002], rel=1e-9)


@pytest.mark.parametrize("scene", ["hertz-pair", "hertz-cradle"])
def test_a_soft_hertz_contact_may_still_be_pressed_at_the_end_of_the_run(scene: str):
    """The last step had no time left, and so no series."""
    plain = registry.plain(scene)
    plain["contact"] = {**plain["contact"], "stiffness": "0.05"}
    finished = run(read_scene(plain))
    assert finished.t == read_scene(plain).until
    assert finished.ledger.imbalance() < 1e-9
