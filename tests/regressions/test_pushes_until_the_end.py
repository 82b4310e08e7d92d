"""What ends exactly when the run does changes no velocity in it."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from sim.dynamics.loop.run import Run, run
from sim.scene import read_scene

SPREAD = 1e-12
"""m and m/s. Both runs go the same way until their last instant."""


def pushed(plain: dict[str, Any], push: dict[str, Any]) -> Run:
    return run(read_scene(plain | {"effects": [{"push": push}]}))


def alike(plain: dict[str, Any], push: dict[str, Any]) -> None:
    closed, unending = pushed(plain, push | {"until": plain["until"]}), pushed(plain, push)
    assert closed.v == pytest.approx(unending.v, abs=SPREAD)
    assert closed.x == pytest.approx(unending.x, abs=SPREAD)


@pytest.mark.parametrize("law", ["push-only", "push-only-uncorrected", "paper", "bumper", "hertz"])
def test_a_push_that_ends_with_the_run_parts_no_cart_from_its_wall(law: str) -> None:
    """It presses A to the right wall. An end foreseen for the contact, 1e-19 s late, was that of
    the contact that had begun at this instant: A left the wall at 0.16 m/s."""
    plain = {
        "carts": {"A": {"mass": 0.1, "position": 0.45, "velocity": -0.5}},
        "track": {"left": "wall", "right": "wall", "length": 0.55},
        "contact": {"law": law, "restitution": 0.5, "stiffness": 50},
        "until": 2,
    }
    alike(plain, {"cart": "A", "force": 0.5})


@pytest.mark.parametrize("seed", range(60))
def test_a_push_until_the_end_is_a_push_without_an_end(seed: int) -> None:
    dice = Random(seed)
    carts, x = {}, 0.2
    for name in "ABC"[: dice.choice([1, 2, 2, 3])]:
        x = round(x + dice.choice([0.2, 0.25, 0.3]), 3)
        mass, velocity = dice.choice([0.1, 0.25, 0.5, 1]), dice.choice([0, 0.5, -0.5, 1])
        carts[name] = {"mass": mass, "position": x, "velocity": velocity}
    length = round(x + dice.choice([0.1, 0.2, 0.3]), 3)
    plain = {
        "carts": carts,
        "track": {"left": "wall", "right": "wall", "length": length},
        "contact": {
            "law": dice.choice(["bumper", "paper", "push-only"]),
            "restitution": dice.choice([0.5, 0.8, 1]),
            "stiffness": dice.choice([20, 50, 100]),
        },
        "until": dice.choice([1, 1.5, 2, 3]),
    }
    alike(plain, {"cart": dice.choice(list(carts)), "force": dice.choice([0.5, 1, -1])})
