"""A force gives its impulse F Δt whether its cart moves or not; what holds it gives it back."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import stepped
from sim.scene import Scene, read_scene

CHOICES = [
    MethodChoice("rk4", step=1e-3),
    MethodChoice("rk4-events", step=1e-2),
    MethodChoice("rk45", rtol=1e-9),
    MethodChoice("adaptive", rtol=1e-9),
]
G = 9.81


def push(cart: str, force: float, **when: float) -> dict[str, Any]:
    return {"push": {"cart": cart, "force": force, "until": 9, **when}}


def alone(*effects: dict[str, Any], until: float = 3.0) -> Scene:
    """1 kg at rest."""
    return read_scene(
        {"carts": {"A": {"mass": 1, "position": 0}}, "effects": list(effects), "until": until}
    )


def on_the_wall(*effects: dict[str, Any], **more: Any) -> Scene:
    """1 kg at 1 m/s comes to a wall after 0.5 m, and sticks to it."""
    return read_scene(
        {
            "carts": {"B": {"mass": 1, "position": "0.4", "velocity": 1}},
            "track": {"right": "wall", "length": 1},
            "contact": {"law": "velcro"},
            "effects": list(effects),
            "until": 3,
        }
        | more
    )


ROUGH = {"friction": {"coefficient": "0.1"}}
CASES: dict[str, tuple[Scene, dict[str, float]]] = {
    "held": (alone(ROUGH, push("A", 0.5, until=2)), {"push": 1.0, "friction": -1.0}),
    "held without kinetic friction": (
        alone({"friction": {"coefficient": 0, "static": "0.5"}}, push("A", 1), until=1),
        {"push": 1.0, "friction": -1.0},
    ),
    "held, then not": (  # slides with 2 N − 0.981 N for the last second
        alone(ROUGH, push("A", 0.5, until=2), push("A", 2, **{"from": 2})),
        {"push": 3.0, "friction": -1.0 - 0.1 * G},
    ),
    "held on a slope": (
        alone({"friction": {"coefficient": "0.5"}}, {"incline": {"angle": "5 deg"}}),
        {
            "incline": 3 * G * math.sin(math.radians(5)),
            "friction": -3 * G * math.sin(math.radians(5)),
        },
    ),
    "two pushes in balance": (alone(push("A", 1), push("A", -1)), {"push": 0.0}),
    "stuck to a wall": (on_the_wall(push("B", 0.5)), {"push": 1.5, "walls": -2.5}),
    "stuck to a wall, and a push that ends": (
        on_the_wall(push("B", 0.5, until=2)),
        {"push": 1.0, "walls": -2.0},
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_the_exact_run_books_both_sides_of_what_holds_a_cart(case: str) -> None:
    scene, impulses = CASES[case]
    books = run(scene).ledger
    for name, impulse in impulses.items():
        assert books.impulses.get(name, 0.0) == pytest.approx(impulse, abs=1e-12), name
    left = books.momentum_initial + books.external - books.momentum_final
    assert left == pytest.approx(0, abs=1e-12)
    assert books.imbalance() < 1e-12


@pytest.mark.parametrize("choice", CHOICES, ids=lambda choice: choice.method)
@pytest.mark.parametrize("case", CASES)
def test_no_stepper_reports_what_holds_a_cart_as_its_own_error(
    case: str, choice: MethodChoice
) -> None:
    scene, impulses = CASES[case]
    done = stepped(scene, choice)
    near = 1e-2 if choice.method == "rk4" else 1e-9
    for name, impulse in impulses.items():
        assert done.run.ledger.impulses.get(name, 0.0) == pytest.approx(impulse, abs=near), name
    assert abs(done.lost_momentum) < 1e-9


def test_a_hand_that_pushes_a_held_cart_is_told() -> None:
    """It was: no impulse from outside."""
    scene, _ = CASES["held"]
    assert set(run(scene).ledger.impulses) == {"push", "friction"}


HIT = {
    "A": {"mass": 1, "position": "0.2", "velocity": 1},
    "B": {"mass": 2, "position": "0.7", "velocity": 1},
}


@pytest.mark.parametrize("law", ["instant", "bumper"])
@pytest.mark.parametrize("choice", CHOICES, ids=lambda choice: choice.method)
def test_a_cart_that_sticks_to_a_wall_hands_on_what_hits_it(choice: MethodChoice, law: str) -> None:
    """A comes back from B, which the wall holds: it gave −2 − 2 N s, and −F Δt for the push."""
    contact = {"law": law, "restitution": 1} | ({"stiffness": 500} if law == "bumper" else {})
    scene = read_scene(
        {
            "carts": HIT,
            "track": {"right": "wall", "length": "0.9"},
            "contact": contact | {"pairs": {"B-right": {"law": "velcro"}}},
            "effects": [push("B", 0.5)],
            "until": 1,
        }
    )
    true, done = run(scene).ledger, stepped(scene, choice)
    assert true.impulses == pytest.approx({"push": 0.5, "walls": -4.5}, abs=1e-12)
    assert done.run.v == pytest.approx((-1, 0), abs=1e-2)
    assert done.run.ledger.impulses["walls"] == pytest.approx(-4.5, abs=1e-2)
    assert abs(done.lost_momentum) < 1e-9
