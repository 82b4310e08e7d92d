"""How large the force of each effect becomes, for the scale of a picture: by hand."""

from __future__ import annotations

import math
import pkgutil
from importlib import import_module
from typing import Any

import pytest

import sim.effects
from sim.effects.part import part_of
from tests.web.scene.given.widget_site import baked

G = 9.81
CARTS = {
    "A": {"mass": 2, "length": 0.1, "position": 0.5, "velocity": 0.5},
    "B": {"mass": 3, "length": 0.1, "position": 1.0, "velocity": -0.7},
}
PAIR = {"between": ["A", "B"]}
WALL = {"between": ["B", "right"]}
ROOM = 0.4  # m, between A and B, and the same to the right end
MU, CLOSING = 6 / 5, 1.2
LARGEST: list[tuple[str, dict[str, Any], float]] = [
    ("friction", {"coefficient": 0.02}, 0.02 * 3 * G),
    ("friction", {"coefficient": 0.02, "static": 0.05}, 0.05 * 3 * G),
    ("friction", {"carts": ["A"], "coefficient": 0.02}, 0.02 * 2 * G),
    ("incline", {"angle": "-3 deg"}, 3 * G * math.sin(math.radians(3))),
    ("incline", {"carts": ["A"], "angle": "3 deg"}, 2 * G * math.sin(math.radians(3))),
    ("push", {"cart": "A", "force": "-0.4 N"}, 0.4),
    ("drag", {"linear": 0.2}, 0.2 * 0.7),
    ("drag", {"linear": 0.2, "quadratic": 0.3}, 0.2 * 0.7 + 0.3 * 0.7**2),
    ("spring", {**PAIR, "stiffness": 5, "length": 0.7}, 5 * 0.3),
    ("spring", {**PAIR, "stiffness": 5, "length": 0.1}, 5 * 0.3),
    ("release", {**PAIR, "energy": 0.3, "stiffness": 200}, math.sqrt(2 * 0.3 * 200)),
    ("release", {**PAIR, "energy": 0.3}, 0.0),
    # all energy of the approach between the two: C/r³ with C/2 (1/r² − 1/room²) = mu w²/2
    ("magnets", {**PAIR, "strength": 0.01},
     0.01 * (1 / ROOM**2 + MU * CLOSING**2 / 0.01) ** 1.5),
    ("magnets", {**PAIR, "strength": 0.5, "power": 1},
     0.5 / (ROOM * math.exp(-0.5 * MU * CLOSING**2 / 0.5))),
    ("magnets", {**WALL, "strength": 0.01}, 0.01 * (1 / ROOM**2 + 3 * 0.7**2 / 0.01) ** 1.5),
]  # fmt: skip


@pytest.mark.parametrize(("kind", "numbers", "newtons"), LARGEST)
def test_the_largest_force_of_an_effect_is_what_mechanics_says(
    kind: str, numbers: dict[str, Any], newtons: float
) -> None:
    plain = {"carts": CARTS, "track": {"length": 1.45, "right": "wall"}, "until": 0.01}
    _, header, _ = baked({"id": "one", **plain, "effects": [{kind: numbers}]})
    (effect,) = header["effects"]
    found = import_module(f"sim.effects.{kind}.largest").largest(effect, header)
    assert found == pytest.approx(newtons, rel=1e-9)


def test_every_effect_that_says_how_large_it_becomes_stands_here() -> None:
    kinds = [found.name for found in pkgutil.iter_modules(sim.effects.__path__) if found.ispkg]
    assert {kind for kind in kinds if part_of(kind, "largest")} == {kind for kind, *_ in LARGEST}
