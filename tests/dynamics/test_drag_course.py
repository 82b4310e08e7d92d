"""Drag with a square beside other forces: the closed form beside forty digits, and its accounts."""

from __future__ import annotations

from random import Random
from typing import Any

import mpmath
import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.motion.drag_course import Driven, driven
from sim.scene import read_scene
from tests.reference.effects import integrate

ROUNDING = 4e-15
"""Of the greatest speed, and of the way at that speed."""


def one_way(w0: Any, push: Any, gamma: Any, kappa: Any, t: Any) -> tuple[Any, Any]:
    """Displacement and speed by cosh and sinh of a root that may be imaginary, in many digits."""
    w0, push, gamma, kappa, t = map(mpmath.mpf, (w0, push, gamma, kappa, t))
    omega = mpmath.sqrt(mpmath.mpc(gamma**2 / 4 + kappa * push))
    cosh, sinh = mpmath.cosh(omega * t), mpmath.sinh(omega * t) / omega
    fade = mpmath.exp(-gamma * t / 2)
    u = fade * (cosh + (kappa * w0 + gamma / 2) * sinh)
    slope = fade * (kappa * w0 * cosh + kappa * (push - gamma * w0 / 2) * sinh)
    return mpmath.re(mpmath.log(u) / kappa), mpmath.re(slope / u / kappa)


def in_forty_digits(course: Driven, t: float) -> tuple[Any, Any]:
    first = course.first
    numbers = (first.gamma, first.kappa)
    if t <= course.turn:
        x, w = one_way(first.w0, first.push, *numbers, t)
        return course.direction * x, course.direction * w
    there, _ = one_way(first.w0, first.push, *numbers, course.turn)
    x, w = one_way(0, -first.push, *numbers, mpmath.mpf(t) - mpmath.mpf(course.turn))
    return course.direction * (there - x), -course.direction * w


@pytest.mark.parametrize("seed", range(30))
def test_drag_with_a_square_moves_as_forty_digits_say(seed: int) -> None:
    dice = Random(seed)
    v = dice.choice([0.0, 1.0, -1.0, 1e-3, 30.0]) * dice.uniform(0.1, 2)
    a = dice.choice([1, -1]) * 10 ** dice.uniform(-3, 1)
    course = driven(v, a, dice.choice([0.0, 0.05, 1.0, 3.0]), 10 ** dice.uniform(-6, 1))
    with mpmath.workdps(40):
        for t in (1e-3, 0.1, 1.0, 10.0, 600.0):
            x, speed = in_forty_digits(course, t)
            found = course.at(t)
            fastest = max(abs(v), abs(speed))
            assert abs(found[1] - speed) <= ROUNDING * fastest
            assert abs(found[0] - x) <= ROUNDING * fastest * t


def test_a_body_that_is_turned_back_stands_still_where_the_two_ways_meet() -> None:
    for gamma in (0.0, 2.0, 6.0):
        course = driven(1.5, -2.0, gamma, 0.7)
        assert course.at(course.turn)[1] == pytest.approx(0.0, abs=1e-15)
        assert course.at(course.turn * (1 + 1e-9))[1] < 0.0
        assert course.at(course.turn)[2] == pytest.approx(-2.0, abs=1e-14)


@pytest.mark.parametrize("until", [2, 600])
def test_both_drags_on_a_slope_take_no_steps_and_close_their_account(until: float) -> None:
    scene = read_scene(
        {
            "carts": {"A": {"mass": 0.8, "position": 0.5, "velocity": 0.9}},
            "contact": {"law": "instant"},
            "effects": [
                {"incline": {"angle": "-4 deg"}},
                {"drag": {"linear": 0.2}},
                {"drag": {"quadratic": 0.5}},
            ],
            "until": until,
        }
    )
    done = run(scene)
    assert set(done.solvers) == {"flight"}
    assert done.ledger.imbalance() < 1e-14
    if until < 10:
        expected = integrate(scene)
        assert done.v == pytest.approx(expected.v, abs=1e-10)
        assert done.ledger.works["drag"] == pytest.approx(expected.work["drag"], abs=1e-10)
