"""Carts on bumpers with e = 0 that a push keeps together: no run gets stuck in one instant.

Three things used to repeat without end: nothing pressed locked carts together that static friction
held; a bumper that was just about to give way went to and fro; one of a locked row never halted.
"""

from __future__ import annotations

import itertools
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import stepped
from sim.scene import read_scene

UNTIL = 4
EVERY = list(itertools.product(itertools.product((0.5, 1, 2), repeat=3), (False, True), (0, 0.05)))
CASES = EVERY[::3]  # of four kinds in turn


def scene(masses: tuple[float, ...], wall: bool, friction: float) -> dict[str, Any]:
    effects: list[dict[str, Any]] = [{"push": {"cart": "A", "force": 1}}]
    if friction:
        effects.append({"friction": {"coefficient": friction}})
    places = ("0.3", "0.5", "0.7")
    return {
        "carts": {
            name: {"mass": mass, "position": place}
            for name, mass, place in zip("ABC", masses, places, strict=True)
        },
        "track": {"right": "wall", "length": "0.9"} if wall else {},
        "contact": {"restitution": 0, "stiffness": 100},
        "effects": effects,
        "until": UNTIL,
    }


@pytest.mark.parametrize(("masses", "wall", "friction"), CASES)
def test_a_pushed_row_comes_to_its_end(
    masses: tuple[float, ...], wall: bool, friction: float
) -> None:
    described = read_scene(scene(masses, wall, friction))
    done = run(described, max_steps=2_000)
    assert done.t == UNTIL, done.outcome.sentence
    # Independent: steps of RK4 with located events, which join carts in a way of their own.
    other = stepped(described, MethodChoice("rk4-events", step=UNTIL / 997)).run
    assert done.v == pytest.approx(other.v, abs=1e-6)
    assert done.x == pytest.approx(other.x, abs=1e-6)
