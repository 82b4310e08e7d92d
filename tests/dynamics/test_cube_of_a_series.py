"""The work of quadratic drag: the integral of a speed cubed, over as long as half a swing."""

from __future__ import annotations

import math

import pytest

from sim.dynamics.motion.quadrature import nodes, square_and_cube

ORDER = 26


def test_the_cube_of_a_sine_over_half_a_swing_is_four_thirds() -> None:
    sine = [0.0 if n % 2 == 0 else (-1) ** (n // 2) / math.factorial(n) for n in range(ORDER)]
    assert square_and_cube(sine, math.pi)[1] == pytest.approx(4.0 / 3.0, rel=1e-13)


def test_the_cube_of_a_line_is_a_quarter_of_the_fourth_power() -> None:
    assert square_and_cube([0.0, 2.0], 3.0)[1] == pytest.approx(8.0 * 3.0**4 / 4.0, rel=1e-15)


def test_the_square_of_a_cosine_over_a_whole_step_is_told_to_its_last_bits() -> None:
    cosine = [0.0 if n % 2 else (-1) ** (n // 2) / math.factorial(n) for n in range(ORDER)]
    square, _ = square_and_cube(cosine, 2.0)
    assert square == pytest.approx(1.0 + math.sin(4.0) / 4.0, rel=1e-15)


def test_in_a_mirror_the_cube_turns_its_sign_and_no_bit() -> None:
    p = [0.3, -0.7, 0.11, 0.05]
    square, cube = square_and_cube(p, 0.7)
    assert square_and_cube([-c for c in p], 0.7) == (square, -cube)


def test_the_weights_of_all_places_add_up_to_one() -> None:
    assert math.fsum(weight for _, weight in nodes()) == pytest.approx(1.0, abs=1e-15)
    assert all(0.0 < place < 1.0 for place, _ in nodes())
