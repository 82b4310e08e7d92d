"""A cart presses its bumper into a wall, turns round, and stays where friction can hold it.

Its velocity at the turn was what rounding had left, and where that led away from the wall the cart
sprang back all the same, by up to 8 mm: one start in twenty.
"""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene

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
