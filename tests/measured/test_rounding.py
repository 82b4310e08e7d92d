"""Readings that were rounded are not taken for surer than their step lets them be."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sim.measured.events.brakes import solved
from sim.measured.rounding import BOUND, step_of, unseen

RATE = 20  # Hz
COUNT = 20  # readings on each side
STEP = 0.01  # m


def rounded(x: np.ndarray, step: float = STEP) -> np.ndarray:
    return np.round(x / step) * step


def sides(before: float, after: float, at: float = 0.0) -> list[tuple[np.ndarray, np.ndarray]]:
    """A cart that moves and one that rests, then the other way round; velocities in m/s."""
    early = np.arange(-COUNT, 0) / RATE
    late = np.arange(1, COUNT + 1) / RATE
    exact = [(early, before * early), (early, 0 * early), (late, 0 * late), (late, after * late)]
    return [(tau, rounded(x + at)) for tau, x in exact]


@pytest.mark.parametrize("step", [0.0005, 0.002, 0.01, 1 / 3])
def test_the_step_is_found_whatever_it_is(step: float) -> None:
    dice = np.random.default_rng(5)
    assert step_of(rounded(dice.uniform(0, 40 * step, 60), step)) == pytest.approx(step)


def test_readings_that_are_not_rounded_have_no_step() -> None:
    dice = np.random.default_rng(6)
    for _ in range(50):
        assert step_of(dice.uniform(0, 1, 60)) == 0.0
    assert step_of(np.full(9, 0.3)) == 0.0


@pytest.mark.parametrize("places", [4, 5, 6, 15])
def test_the_way_of_an_even_cart_is_no_step_to_which_its_readings_are_rounded(places: int) -> None:
    """As whoever tries the page types them: at rest, a push, one velocity, as many decimals."""
    t = np.arange(70) / 30
    exact = 1.1 + 0.5 * np.maximum(0.0, t - 1.0)
    assert step_of(np.round(exact, places)) == pytest.approx(10.0**-places if places < 7 else 0.0)


def test_a_cart_that_covers_one_step_in_each_reading_has_the_step_of_its_decimals() -> None:
    assert step_of(np.round(0.3 + 0.01 * np.arange(60), 2)) == pytest.approx(0.01)


@pytest.mark.parametrize("m", [1, 2, 3, 4])
def test_a_cart_that_covers_a_step_in_m_readings_may_be_off_by_a_2m_th_of_it(m: int) -> None:
    exact = STEP * np.arange(120) / m + 0.3 * STEP / m
    left = rounded(exact) - exact
    left -= left.mean()
    assert unseen(np.ones((1, 1)), left, STEP)[0] == pytest.approx(BOUND * STEP / (2 * m), rel=1e-6)


def test_errors_of_rounding_that_are_chance_add_nothing() -> None:
    left = np.random.default_rng(7).uniform(-STEP / 2, STEP / 2, 4000)
    assert unseen(np.ones((1, 1)), left, STEP)[0] < 0.2 * STEP / 2
    assert unseen(np.ones((1, 1)), left + np.roll(left, 1), STEP)[0] == 0.0


def test_velocities_of_carts_in_step_with_the_rounding_lie_in_their_intervals() -> None:
    """0.40 m/s is two steps a reading: all readings of 0.41 m/s or so may lie on that line."""
    held = tried = 0
    for before in np.linspace(0.38, 0.42, 9):
        for after in np.linspace(0.19, 0.21, 9):
            for at in (0.0, 0.0013, 0.0041):
                numbers, covariance, _ = solved(sides(before, after, at), "nothing")
                for k, true in ((0, before), (1, 0.0), (2, 0.0), (3, after)):
                    sd = math.sqrt(covariance[2 * k + 1, 2 * k + 1])
                    held += abs(numbers[2 * k + 1] - true) <= 2.0 * sd
                    tried += 1
                    assert sd < 0.03  # where all gaps are of two steps, nobody can tell one
    assert held >= 0.95 * tried, held / tried
