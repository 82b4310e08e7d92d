"""Two contacts of spheres that begin at one instant: integrated, by the method of order 8."""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene
from tests.reference.effects import integrate

SUMMED = 1e-13
"""Relative. The method's stages are summed by numpy, in an order that the processor decides: on
some the two halves of a mirrored row are equal to the last bit, on some to the last two."""


def mirrored_row() -> dict[str, Any]:
    """Five spheres: two and two come to the one in the middle, springs behind them."""
    masses, speeds = (1.7, 0.5, 1.3, 0.5, 1.7), (0.5, 1.0, 0.0, -1.0, -0.5)
    carts = {
        name: {"mass": mass, "position": 0.75 + 0.25 * k, "velocity": v, "length": 0.25}
        for k, (name, mass, v) in enumerate(zip("ABCDE", masses, speeds, strict=True))
    }
    spring = {"stiffness": 1.78, "length": 0.3}
    return {
        "carts": carts,
        "track": {"length": 2.5},
        "contact": {"law": "hertz", "restitution": 0.5, "stiffness": 67.55},
        "effects": [
            {"drag": {"quadratic": 0.3}},
            {"spring": {"between": ["A", "B"], **spring}},
            {"spring": {"between": ["D", "E"], **spring}},
        ],
        "until": 3.0,
    }


def test_what_spheres_part_with_is_what_the_springs_beside_them_go_on_with() -> None:
    """The last step before they part takes 1e-8 s: a velocity is no slope of places there."""
    scene = read_scene(mirrored_row())
    done, expected = run(scene), integrate(scene, most_steps=20_000)
    assert done.solvers["adaptive"] > 0
    assert done.ledger.imbalance() < 1e-13
    assert done.v == pytest.approx(expected.v, abs=1e-11)
    mirrored = tuple(-v for v in reversed(done.v))
    assert done.v == pytest.approx(mirrored, rel=SUMMED)
