"""Carts that bumpers with e = 0 hold fast, and what presses them further: no mode changes for it.

A bumper that does not spring back takes any force up to the one that pressed it in. A cart that it
holds against a wall has no acceleration, whatever rounding leaves of the sum of its forces.
"""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.stepping.methods import MethodChoice, outcome
from sim.scene import read_scene


def dead(
    carts: dict[str, Any], length: float, effects: list[Any], stiffness: float, until: float = 5
) -> Any:
    return read_scene(
        {
            "carts": carts,
            "track": {"left": "wall", "right": "wall", "length": length},
            "contact": {"law": "bumper", "restitution": 0, "stiffness": stiffness},
            "effects": effects,
            "until": until,
        }
    )


def pressed_in_by(m: float, v: float, k: float, air: dict[str, float]) -> float:
    """m. How far a cart of m kg at v < 0 m/s presses in a bumper on what stands fast, on a slope of
    −2° (it leads to the left) with friction 0.02: by steps of the classical Runge-Kutta method.
    """
    steady = -m * 9.81 * math.sin(math.radians(2)) + 0.02 * m * 9.81 * math.cos(math.radians(2))

    def a(o: float, v: float) -> float:
        return (k * o + steady - air.get("linear", 0.0) * v + air["quadratic"] * v * v) / m

    o, h = 0.0, 1e-5
    while v < 0.0:
        o0, v0 = o, v
        k1, l1 = -v, a(o, v)
        k2, l2 = -(v + h / 2 * l1), a(o + h / 2 * k1, v + h / 2 * l1)
        k3, l3 = -(v + h / 2 * l2), a(o + h / 2 * k2, v + h / 2 * l2)
        k4, l4 = -(v + h * l3), a(o + h * k3, v + h * l3)
        o += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        v += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4)
    return o0 + 0.5 * v0 * v0 / a(o0, v0)


@pytest.mark.parametrize("air", [{"quadratic": 0.1}, {"linear": 0.2, "quadratic": 0.1}])
def test_a_cart_held_against_a_wall_does_not_slide_when_another_runs_into_it(
    air: dict[str, float],
) -> None:
    """The first term of its motion, by which a cart at rest in air finds its direction, was
    rounding: it slid, halted at once, and slid again, 10¹² times a second."""
    carts = {
        "A": {"mass": 1, "position": 0.3, "velocity": -1},
        "B": {"mass": 2, "position": 0.5, "velocity": 0.5},
    }
    effects = [{"friction": {"coefficient": 0.02}}, {"incline": {"angle": "-2 deg"}}, {"drag": air}]
    scene = dead(carts, 0.9, effects, 10_000)
    done = run(scene, max_steps=30)
    assert done.stopped is None
    told = [(event.kind, *event.bodies) for event in done.record.events]
    assert told.count(("contact", "A", "B")) == 1
    touch = next(e for e in done.record.events if e.bodies == ("A", "B"))
    overlap = pressed_in_by(2.0, touch.before["B"], 10_000, air)
    assert done.x[1] - done.x[0] == pytest.approx(0.2 - overlap, abs=1e-12)
    assert done.v == (0.0, 0.0)
    assert done.ledger.imbalance() < 1e-14


ROWS = {
    "a row that is hit from above": (
        {
            "A": {"mass": 0.5, "position": 0.1},
            "B": {"mass": 2, "position": 0.3},
            "C": {"mass": 0.5, "position": 0.5},
            "D": {"mass": 2, "position": 0.8, "velocity": 0.5},
        },
        1000,
        "-5 deg",
        0.05,
    ),
    "a cart between two": (
        {
            "A": {"mass": 0.5, "position": 0.1, "velocity": 0.5},
            "B": {"mass": 1, "position": 0.4},
            "C": {"mass": 0.5, "position": 0.6},
        },
        500,
        "-2 deg",
        0.2,
    ),
}


@pytest.mark.parametrize("what", ROWS)
def test_a_cart_that_begins_to_slide_goes_on_sliding_whatever_else_begins_with_it(
    what: str,
) -> None:
    """B overcomes static friction, which falls to sliding friction; that very instant its bumper is
    pressed further. It forgot that it slid, was held again, overcame friction, and so on without
    end. The oracle: steps of RK4 with events, five times finer, come five times nearer."""
    carts, stiffness, slope, mu = ROWS[what]
    sticks = {"coefficient": mu, "static": 1.5 * mu, "carts": ["B"]}
    scene = dead(carts, 1.0, [{"incline": {"angle": slope}}, {"friction": sticks}], stiffness, 1.3)
    done = run(scene, max_steps=60)
    assert done.stopped is None
    assert [event.kind for event in done.record.events].count("start") == 1
    assert done.v == (0.0,) * len(carts)
    assert done.ledger.imbalance() < 1e-14
    off = []
    for h in (1e-3, 2e-4):
        ways = outcome(scene, MethodChoice("rk4-events", h)).s
        ends = [cart.position + way for cart, way in zip(scene.carts, ways, strict=True)]
        off.append(max(abs(a - b) for a, b in zip(done.x, ends, strict=True)))
    assert off[1] < 5e-6
    assert off[1] < 0.4 * off[0]


@pytest.mark.parametrize("mass", [5.0, 7.16, 20.0])
@pytest.mark.parametrize("stiffness", [50, 200])
def test_a_dead_bumper_pressed_in_round_after_round_keeps_all_momentum(
    mass: float, stiffness: float
) -> None:
    """A springs back and forth between B and the wall, ever faster and slower, dozens of times
    within what counts as one instant. Those were impacts and no alternations of rounding: taken for
    such they let the bumper push on for 1e-6 s after its turn, and the speed that this gave B, 1e-6
    of its first, was dropped; for 7.16 kg the run was refused for an account that did not close."""
    a, b = (
        {"mass": m, "position": x, "velocity": -0.5, "length": 0.2}
        for m, x in ((1.0, 0.1), (mass, 0.35))
    )
    plain = {
        "carts": {"A": a, "B": b},
        "track": {"left": "wall"},
        "contact": {
            "law": "bumper",
            "restitution": 0,
            "stiffness": stiffness,
            "pairs": {"left-A": {"law": "instant", "restitution": 1}},
        },
        "effects": [
            {"release": {"between": ["A", "B"], "energy": 0.1, "at": 0, "stiffness": 41.3}}
        ],
        "until": 5,
    }
    done = run(read_scene(plain), max_events=5_000)
    first = -0.5 * (1.0 + mass)
    now = done.v[0] + mass * done.v[1]
    assert done.stopped is None
    assert now - first == pytest.approx(done.ledger.external, rel=1e-12)
    assert done.ledger.imbalance() < 1e-14


@pytest.mark.parametrize(("mass", "speed"), [(2.0, -1.0), (5.0, -0.3), (20.0, -0.5)])
def test_rounds_between_a_wall_that_gives_all_back_and_a_dead_bumper_end(
    mass: float, speed: float
) -> None:
    """Every round leaves (m - 1)/(m + 1) of the speeds: infinitely many before a finite time, and
    both are at rest. They were followed down to 1e-300 m/s, and the run was stopped there."""
    plain = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.1, "velocity": speed},
            "B": {"mass": mass, "position": 0.35, "velocity": speed},
        },
        "track": {"left": "wall"},
        "contact": {
            "law": "bumper",
            "restitution": 0,
            "stiffness": 200,
            "pairs": {"left-A": {"law": "instant", "restitution": 1}},
        },
        "until": 5,
    }
    done = run(read_scene(plain), max_events=1_500)
    assert done.outcome.kind == "came-to-rest"
    assert done.ledger.impulses["walls"] == pytest.approx(-(1.0 + mass) * speed, rel=1e-12)
    assert done.ledger.imbalance() < 1e-14
