"""The work of quadratic drag: the integral of a speed cubed, over as long as half a swing."""

from __future__ import annotations

import math

import pytest

from sim.dynamics.motion.polynomial import cube_integral

ORDER = 26


def test_the_cube_of_a_sine_over_half_a_swing_is_four_thirds() -> None:
    sine = [0.0 if n % 2 == 0 else (-1) ** (n // 2) / math.factorial(n) for n in range(ORDER)]
    assert cube_integral(sine, math.pi) == pytest.approx(4.0 / 3.0, rel=1e-13)


def test_the_cube_of_a_line_is_a_quarter_of_the_fourth_power() -> None:
    assert cube_integral([0.0, 2.0], 3.0) == pytest.approx(8.0 * 3.0**4 / 4.0, rel=1e-15)
