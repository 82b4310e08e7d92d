"""Certificates that missed, found among random scenes; each in its plainest scene."""

from __future__ import annotations

import pytest

from sim.certify.certificate import certify, document
from sim.scene import read_scene
from tests.certify.held import misses


def test_a_cart_that_a_wall_stops_dead_is_told_to_stop_where_friction_holds_it() -> None:
    """As a run tells it."""
    scene = read_scene({
        "carts": {"A": {"mass": 2, "position": 0.25, "velocity": -1}},
        "track": {"left": "wall"}, "contact": {"law": "instant", "restitution": 0}, "until": 1,
        "effects": [{"push": {"cart": "A", "force": 0.1, "from": 0.5}},
                    {"friction": {"coefficient": 0.04}}],
    })  # fmt: skip
    found = document(certify(scene))
    assert [event["kind"] for event in found["events"]] == ["contact", "stop", "end"]
    assert misses(scene, found) == []


def test_friction_that_holds_one_of_a_pair_changes_the_damping_of_the_other() -> None:
    """Critical for two masses is not critical for one."""
    scene = read_scene({
        "carts": {"A": {"mass": 6.606, "position": 0.2},
                  "B": {"mass": 0.396, "position": 0.586, "velocity": -0.5}},
        "track": {"right": "wall", "length": 1.31}, "until": 1.2,
        "contact": {"law": "paper", "restitution": 0, "stiffness": 112},
        "effects": [{"friction": {"coefficient": 0.0125, "static": 0.0232}}],
    })  # fmt: skip
    found = document(certify(scene))
    kinds = [event["kind"] for event in found["events"]]
    assert kinds == ["contact", "peak", "start", "stop", "end"]
    assert misses(scene, found) == []


def test_a_cart_that_turned_round_and_one_that_stops_later_do_not_stay_together() -> None:
    """Both had stood still once, at two times."""
    scene = read_scene({
        "carts": {"A": {"mass": 3.5, "position": 0.2, "velocity": -0.142},
                  "B": {"mass": 0.15, "position": 0.45, "velocity": 0.5}},
        "contact": {"law": "velcro"}, "until": 3,
        "effects": [{"friction": {"coefficient": 0.04}},
                    {"push": {"cart": "B", "force": -0.95, "from": 0.22, "until": 0.39}}],
    })  # fmt: skip
    found = document(certify(scene))
    assert found["order"] == "proved" and misses(scene, found) == []


def test_an_impact_at_one_of_two_that_have_just_parted_brings_their_force_back() -> None:
    """Their dashpot had not recovered."""
    scene = read_scene({
        "carts": {"A": {"mass": 2.442, "position": 0.2, "velocity": 1.438},
                  "B": {"mass": 1.999, "position": 0.4, "velocity": 0.188},
                  "C": {"mass": 0.213, "position": 0.65, "velocity": -0.5}},
        "contact": {"law": "velcro", "pairs": {
            "A-B": {"law": "push-only-uncorrected", "restitution": 0.02, "stiffness": 4922}}},
        "until": 0.5,
    })  # fmt: skip
    found = document(certify(scene))
    told = [(event["kind"], event["bodies"]) for event in found["events"]]
    assert told.count(("contact", ["A", "B"])) == 2
    assert misses(scene, found) == []


def test_two_pushes_of_one_instant_are_weighed_by_friction_together() -> None:
    """0.37 N of both at once do not move B; it started, and slid, for the 6.9 N of the first."""
    scene = read_scene({
        "carts": {"A": {"mass": 1, "position": 0.594, "velocity": 0.74},
                  "B": {"mass": 1, "position": 0.794},
                  "C": {"mass": 1, "position": 0.994, "velocity": -0.7}},
        "track": {"right": "open", "length": 1.5}, "until": 0.5,
        "contact": {"law": "push-only", "restitution": 0.5, "stiffness": 663},
        "effects": [{"friction": {"coefficient": 0.0372, "static": 0.0458}}],
    })  # fmt: skip
    found = document(certify(scene))
    starts = [event["t"] for event in found["events"] if event["kind"] == "start"]
    assert [float(low) > 0.003 for low, _ in starts] == [True]
    assert misses(scene, found) == []


def test_the_spring_of_an_exploder_is_followed_when_what_it_pushes_comes_off_a_wall() -> None:
    """B stuck to the wall through C when the spring was let go, and went alone at that instant."""
    scene = read_scene({
        "carts": {"A": {"mass": 0.29, "position": 0.79},
                  "B": {"mass": 0.44, "position": 0.99, "velocity": 0.56},
                  "C": {"mass": 2.05, "position": 1.19}},
        "track": {"left": "wall", "right": "wall", "length": 1.29},
        "contact": {"law": "velcro"}, "until": 0.4,
        "effects": [
            {"release": {"between": ["A", "B"], "energy": 0.1648, "at": 0.25, "stiffness": 530.9}},
            {"release": {"between": ["B", "C"], "energy": 0.1111, "at": 0.25}}],
    })  # fmt: skip
    found = document(certify(scene))
    assert found["final"]["x"]
    assert misses(scene, found) == []


def test_carts_that_friction_holds_stand_until_an_exploder_moves_them() -> None:
    """The heavy one never starts: of a stop that never was the order was proved."""
    scene = read_scene({
        "carts": {"A": {"mass": 0.2, "position": 0.3}, "B": {"mass": 5, "position": 0.5}},
        "contact": {"law": "bumper", "restitution": 1, "stiffness": 1000}, "until": 1,
        "effects": [
            {"release": {"between": ["A", "B"], "energy": 0.02, "at": 0.25, "stiffness": 100}},
            {"friction": {"coefficient": 0.1}}],
    })  # fmt: skip
    found = document(certify(scene))
    told = {(event["kind"], *event["bodies"]) for event in found["events"]}
    assert ("start", "A") in told and ("stop", "B") not in told
    assert found["order"] == "proved" and misses(scene, found) == []


@pytest.mark.parametrize("law", ["push-only", "push-only-uncorrected", "paper", "bumper"])
@pytest.mark.parametrize("speed", [0.01, 0.05])
@pytest.mark.parametrize("e", [0.5, 0.7, 1])
def test_a_contact_beside_a_cart_that_friction_holds_ends_when_forty_digits_say(
    law: str, speed: float, e: float
) -> None:
    """B's whole mass swings against A, which stands: with less damping, and later, than two that
    move. At 1 cm/s A stays; at 5 cm/s it starts and stops in most of these contacts."""
    scene = read_scene({
        "carts": {"A": {"mass": 0.5, "position": 0.5},
                  "B": {"mass": 1, "position": 0.62, "velocity": -speed, "length": 0}},
        "contact": {"law": law, "restitution": e, "stiffness": 20000}, "until": 3,
        "effects": [{"friction": {"coefficient": 0.3, "static": 0.45, "carts": ["A"]}}],
    })  # fmt: skip
    found = document(certify(scene))
    assert found["order"] == "proved" and misses(scene, found) == []
