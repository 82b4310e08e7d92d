"""Touches that a run made and its certificate did not: where one is due is asked ever anew."""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene
from tests.fuzz.mirror import mirrored
from tests.regressions.given import cart

CREEPING: dict[str, Any] = {
    "carts": {
        "A": {"mass": 1.13, "position": 0.777},
        "B": {"mass": 3.69, "position": 0.977, "velocity": 0.03},
    },
    "track": {"left": "open", "right": "wall", "length": 1.077},
    "contact": {"law": "paper", "restitution": 0, "stiffness": 2527},
    "until": 1,
}


@pytest.mark.parametrize("speed", [0.03, 0.3, 3.0])
def test_a_cart_that_creeps_back_for_ever_never_reaches_its_neighbour(speed: float) -> None:
    """Without spring back it comes off the wall as x e^(−ω x): 400 steps ended 9e-10 m before the
    other, and counted as a touch."""
    carts = CREEPING["carts"] | {"B": CREEPING["carts"]["B"] | {"velocity": speed}}
    finished = run(read_scene(CREEPING | {"carts": carts}))
    assert finished.v[0] == 0.0
    assert {event.bodies for event in finished.record.events if event.kind == "contact"} == {
        ("B", "right")
    }


def test_a_pair_that_clears_for_a_moment_pushes_when_it_touches_again() -> None:
    """Between two looks B and C, driven by A, part by 1e-10 m and close: the damper of the room
    between them counted as a push, 3.5 µs too soon."""
    carts = {
        "A": {"mass": 0.247, "position": 0.264, "velocity": 0.5},
        "B": {"mass": 0.541, "position": 0.514},
        "C": {"mass": 0.105, "position": 0.764},
        "D": {"mass": 8.057, "position": 1.014, "velocity": -0.5},
    }
    scene = {
        "carts": carts,
        "track": {"left": "wall", "right": "wall", "length": 1.587},
        "contact": {"law": "push-only-uncorrected", "restitution": 0.5, "stiffness": 10081},
        "until": 0.73,
    }
    events = run(read_scene(scene)).record.events
    touches = [e for e in events if e.kind == "contact" and e.bodies == ("B", "C")]
    assert touches[-1].t == pytest.approx(0.7244308894936961, abs=1e-11)  # certified


def test_a_bumper_that_was_to_clear_is_still_pressed_in_when_a_push_ends() -> None:
    """Foreseen while the push of 0.66 N still acted: at 0.53 s it was taken for cleared."""
    scene = {
        "carts": {
            "A": {"mass": 0.77, "position": 0.5, "velocity": 0.22},
            "B": {"mass": 4.34, "position": 0.7, "velocity": 0.22},
            "C": {"mass": 3.39, "position": 0.9, "velocity": 0.22},
        },
        "track": {"left": "open", "right": "wall", "length": 1.0},
        "contact": {"law": "bumper", "restitution": 0.018, "stiffness": 5387},
        "effects": [
            {"release": {"between": ["A", "B"], "energy": 0.009, "at": 0.25}},
            {"push": {"cart": "C", "force": -0.66, "from": 0.17, "until": 0.28}},
        ],
        "until": 1,
    }
    finished = run(read_scene(scene))
    assert finished.v[2] == pytest.approx(-0.00241635834979568, rel=1e-11)  # certified


PARTING_BESIDE_A_WALL: dict[str, Any] = {
    "carts": {
        "A": cart(0.1),
        "B": cart(0.3, 0.132, 0.901),
        "C": cart(0.5, 0.127, 1.27),
        "D": cart(0.7, 1.0, 1.79),
    },
    "track": {"left": "open", "right": "wall", "length": 0.87},
    "contact": {
        "law": "bumper",
        "restitution": 0,
        "stiffness": 740,
        "pairs": {
            "A-B": {"law": "hertz", "restitution": 1, "stiffness": 28.7},
            "B-C": {"law": "hertz", "restitution": 0, "stiffness": 742},
            "C-D": {"law": "push-only-uncorrected", "restitution": 1, "stiffness": 7150},
            "D-right": {"law": "bumper", "restitution": 0, "stiffness": 3390},
        },
    },
    "effects": [],
    "until": 3,
}


def _greatest(plain: dict[str, Any], pair: set[str]) -> list[float]:
    events = run(read_scene(plain)).record.events
    return [e.force or 0.0 for e in events if e.kind == "peak" and set(e.bodies) == pair]


def test_an_approach_that_gets_nowhere_is_no_touch_of_two_that_fly_freely_either() -> None:
    """In the mirror the cart was left with 1e-35 m/s towards the wall as both its contacts ended,
    and the bumper, pressed in as far as ever, was told with its full old force of 78 N."""
    straight = _greatest(PARTING_BESIDE_A_WALL, {"D", "right"})
    turned = _greatest(mirrored(PARTING_BESIDE_A_WALL), {"D", "left"})
    assert turned == pytest.approx(straight, rel=1e-12)
    assert straight == pytest.approx([77.898, 12.483], rel=1e-4)


PARTING_IN_A_ROW: dict[str, Any] = {
    "carts": {
        "A": cart(0.1, 0.0, 1.14),
        "B": cart(0.3, 0.0, 1.14),
        "C": cart(0.52, -1.0, 1.14),
        "D": cart(0.72, 1.0, 1.14),
        "E": cart(0.92, -0.463, 1.14),
    },
    "track": {"left": "wall", "right": "open", "length": 1.31},
    "contact": {
        "law": "bumper",
        "restitution": 0,
        "stiffness": 56.3,
        "pairs": {
            "left-A": {"law": "push-only", "restitution": 1, "stiffness": 14700},
            "B-C": {"law": "paper", "restitution": 1, "stiffness": 4300},
            "C-D": {"law": "velcro"},
            "D-E": {"law": "push-only", "restitution": 1, "stiffness": 245},
        },
    },
    "effects": [],
    "until": 1,
}


def test_two_that_a_dead_bumper_held_part_with_one_velocity() -> None:
    """In the mirror they differed by the last bit: they were 1e-18 m apart when the next cart came,
    touched 0.4 µs late, and at once with the 8 N that their bumper had been pressed in by."""
    for plain in (PARTING_IN_A_ROW, mirrored(PARTING_IN_A_ROW)):
        events = run(read_scene(plain)).record.events
        touched = {
            tuple(sorted(e.bodies)): (e.t, e.force)
            for e in events
            if e.kind == "contact" and 0.5 < e.t < 0.8
        }
        assert touched["A", "B"] == touched["B", "C"]
        assert touched["A", "B"][1] == 0.0
