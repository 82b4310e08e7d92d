"""A release that parts bumpers while they overlap: they push no more, until pressed again."""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene
from tests.reference.effects import integrate

BESIDE: dict[str, list[dict[str, Any]]] = {
    "nothing": [],
    "a slope that is nearly none": [{"incline": {"angle": 1e-9}}],
    "a slope for one": [{"incline": {"angle": "5 deg", "carts": ["A"]}}],
    "a spring to the wall": [
        {"spring": {"between": ["left", "A"], "stiffness": 50, "length": 0.6}}
    ],
    "a spring across": [{"spring": {"between": ["A", "B"], "stiffness": 5, "length": 0.3}}],
    "drag": [{"drag": {"quadratic": 0.5}}],
}


def scene_with(law: str, e: float, energy: float, beside: list[dict[str, Any]]) -> dict[str, Any]:
    """A has pressed B for 0.1 s when the energy between them is set free."""
    release = {"release": {"between": ["A", "B"], "energy": energy, "at": 0.1}}
    return {
        "carts": {
            "A": {"mass": 1, "position": 0.3, "velocity": 0.5},
            "B": {"mass": 1, "position": 0.5},
        },
        "track": {"left": "wall", "length": 3},
        "contact": {"law": law, "restitution": e, "stiffness": 20},
        "effects": [release, *beside],
        "until": 0.5,
    }


@pytest.mark.parametrize("beside", BESIDE)
@pytest.mark.parametrize(
    ("law", "e"), [("push-only", 1), ("push-only", 0.5), ("paper", 0.5), ("bumper", 0.5)]
)
def test_bumpers_that_a_release_parts_push_no_more(law: str, e: float, beside: str) -> None:
    """By any law, whatever else acts: a slope of 1e-9 made a push-only pair push on."""
    scene = read_scene(scene_with(law, e, 0.1, BESIDE[beside]))
    done = run(scene)
    assert list(done.v) == pytest.approx(list(map(float, integrate(scene).v)), abs=1e-11)
    assert done.ledger.imbalance() < 1e-13


@pytest.mark.parametrize("beside", [{"left", "A"}, {"A", "B"}], ids=["from outside", "across"])
@pytest.mark.parametrize("law", ["push-only", "paper", "bumper"])
def test_bumpers_that_a_release_parts_push_when_they_are_pressed_again(
    law: str, beside: set[str]
) -> None:
    """A spring presses A against B again before their overlap is gone: A does not pass B."""
    length = 0.6 if "left" in beside else 0.0
    between = sorted(beside, key=["left", "A", "B"].index)
    spring = {"spring": {"between": between, "stiffness": 60, "length": length}}
    plain = scene_with(law, 0.5, 1e-5, [spring])
    plain["carts"]["B"]["mass"] = 50
    plain["contact"]["stiffness"] = 2000
    plain["effects"][0]["release"]["at"] = 0.02
    done = run(read_scene(plain))
    assert done.record.counts["contact"] >= 2
    assert done.x[1] - done.x[0] > 0.15
    assert done.ledger.imbalance() < 1e-12
