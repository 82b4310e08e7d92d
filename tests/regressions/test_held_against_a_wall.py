"""A cart presses its bumper into a wall, turns round, and stays where friction can hold it.

Its velocity at the turn was what rounding had left, and where that led away from the wall the cart
sprang back all the same, by up to 8 mm: one start in twenty.
"""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene
from tests.fuzz.mirror import mirrored
from tests.processor_time import budget

MASS, GRAVITY, STATIC = 2.0, 10.0, 0.4  # kg, m/s², 1
HOLDS = STATIC * MASS * GRAVITY  # N
SPEEDS = [round(0.30 + 0.0013 * k, 4) for k in range(80)]  # m/s; the push comes to 5.8 to 8.6 N


def scene(speed: float, contact: dict[str, Any]) -> dict[str, Any]:
    return {
        "gravity": GRAVITY,
        "track": {"left": "wall", "length": 3},
        "carts": {"B": {"mass": MASS, "position": 0.1, "velocity": -speed}},
        "contact": contact,
        "effects": [{"friction": {"coefficient": 0.2, "static": STATIC}}],
        "until": 2,
    }


@pytest.mark.parametrize("restitution", [0.2362, 0.5, 0.9, 1.0])
def test_friction_holds_what_it_can_hold_and_nothing_else(restitution: float) -> None:
    held = sprung = 0
    for speed in SPEEDS:
        done = run(read_scene(scene(speed, {"restitution": restitution, "stiffness": 445.4})))
        press = next(event for event in done.record.events if event.kind == "peak")
        stop = next(event for event in done.record.events if event.kind == "stop")
        assert press.force is not None
        if press.force < HOLDS:
            held += 1
            assert stop.t == pytest.approx(press.t, abs=1e-9), speed
        else:
            sprung += 1
            assert stop.t > press.t + 1e-3, speed
    assert held > 40
    assert sprung > 5


@pytest.mark.parametrize("e", [0, 1e-12, 1e-9])
def test_a_bumper_held_at_its_deepest_is_at_rest_when_it_is_let_go_from_either_side(
    e: float,
) -> None:
    """A presses B to the wall and leaves. With the speed that rounding gave it B touched the wall
    anew, in the mirror only, and sprang back by e of the speed of the first approach."""
    plain: dict[str, Any] = {
        "carts": {
            "A": {"mass": 0.29, "position": 0.1, "velocity": 0.0},
            "B": {"mass": 0.361, "position": 0.3, "velocity": -0.3},
        },
        "track": {"left": "wall", "right": "wall", "length": 0.45},
        "contact": {
            "law": "push-only",
            "restitution": 1,
            "stiffness": 93200,
            "pairs": {"B-right": {"law": "bumper", "restitution": e, "stiffness": 11600}},
        },
        "effects": [{"spring": {"between": ["left", "A"], "stiffness": 6.47, "length": 0.05}}],
        "until": 3,
    }
    one, two = run(read_scene(plain)), run(read_scene(mirrored(plain)))
    assert [-v for v in reversed(two.v)] == pytest.approx(list(one.v), abs=1e-14)
    assert two.record.counts == one.record.counts


def test_a_cart_that_a_damped_contact_lets_creep_to_the_edge_of_friction_is_held() -> None:
    """B is held, and what pushes C between it and the wall falls, ever slower, to just what
    friction can bear: by rounding, 1e-17 N, C slid and stood for ever, 1e-9 s after 1e-9 s."""
    carts = {
        "A": {"mass": 0.25, "position": 0.2, "velocity": 0.3},
        "B": {"mass": 1, "position": 0.4, "velocity": 0.3},
        "C": {"mass": 2, "position": 0.6, "velocity": 0.3},
    }
    scene = {
        "carts": carts,
        "track": {"left": "wall", "right": "wall", "length": 1.0},
        "contact": {"law": "push-only", "restitution": 0.05, "stiffness": 5000},
        "effects": [
            {"push": {"cart": "A", "force": 1, "from": 0.5, "until": 3}},
            {"friction": {"coefficient": 0.02}},
        ],
        "until": 20,
    }
    with budget(3.0):
        done = run(read_scene(scene))
    assert done.v == (0.0, 0.0, 0.0)
    assert len(done.record.events) < 20
