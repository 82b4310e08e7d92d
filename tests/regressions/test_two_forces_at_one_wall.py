"""A spring and magnets between a cart and the same wall: each is booked under its own name.

All that the wall gave was booked as whichever stood first in the scene.
"""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene

SPRING = {"spring": {"between": ["left", "A"], "stiffness": 12, "length": 0.15, "damping": 0.4}}
MAGNETS = {"magnets": {"between": ["left", "A"], "strength": 0.004, "power": 2}}
MASS, SPEED, ROOM, END = 0.7, -0.6, 0.25, 1.5

Row = tuple[float, float, float, float]


def by_hand(steps: int) -> Row:
    """Room [m], its rate [m/s], impulses [N s] of spring and magnets: RK4 with equal steps."""

    def slope(at: Row) -> Row:
        room, rate, *_ = at
        spring, magnets = 12 * (0.15 - room) - 0.4 * rate, 0.004 / room**2
        return rate, (spring + magnets) / MASS, spring, magnets

    def moved(at: Row, by: Row, h: float) -> Row:
        a, b, c, d = (x + h * dx for x, dx in zip(at, by, strict=True))
        return a, b, c, d

    at, h = (ROOM, SPEED, 0.0, 0.0), END / steps
    for _ in range(steps):
        one = slope(at)
        two = slope(moved(at, one, h / 2))
        three = slope(moved(at, two, h / 2))
        four = slope(moved(at, three, h))
        for part, weight in ((one, 1), (two, 2), (three, 2), (four, 1)):
            at = moved(at, part, weight * h / 6)
    return at


@pytest.mark.parametrize("effects", [[SPRING, MAGNETS], [MAGNETS, SPRING]])
@pytest.mark.parametrize("law", ["paper", "hertz", "instant"])
def test_spring_and_magnets_at_one_wall_are_booked_each_under_its_own_name(
    law: str, effects: list[dict[str, Any]]
) -> None:
    plain = {
        "carts": {"A": {"mass": MASS, "position": ROOM + 0.1, "velocity": SPEED}},
        "track": {"left": "wall", "length": 2},
        "contact": {"law": law},
        "effects": effects,
        "until": END,
    }
    done = run(read_scene(plain))
    _, rate, spring, magnets = by_hand(3_000)
    assert done.v[0] == pytest.approx(rate, abs=1e-10)
    assert done.ledger.impulses["spring"] == pytest.approx(spring, abs=1e-10)
    assert done.ledger.impulses["magnets"] == pytest.approx(magnets, abs=1e-10)
