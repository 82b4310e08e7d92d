"""A tilt that moves a cart cannot leave the other one at rest, unless friction holds it."""

from __future__ import annotations

import numpy as np
import pytest

from sim.measured.events.brakes import Side
from sim.measured.events.sides import Speeds, speeds_of


def sides(seed: int, v: tuple[float, ...], friction: float, tilt: float) -> tuple[Side, ...]:
    """Of A and B before and after, at 50 readings a second with 1 mm of noise; B is seen for 0.4 s
    before the contact, the others for 0.8 s. Both effects in m/s²."""
    dice = np.random.default_rng(seed)
    found = []
    for k, speed in enumerate(v):
        count = 20 if k == 1 else 40
        tau = np.arange(1, count + 1) / 50.0 * (1 if k > 1 else -1)
        bend = (tilt - np.sign(speed) * friction) * tau**2 / 2
        found.append((tau, speed * tau + bend + 1e-3 * dice.standard_normal(count)))
    return tuple(found)


def told(speeds: Speeds) -> set[str]:
    return {one.step for one in speeds.rungs}


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("v", [(0.6, 0.0, 0.2, 0.4), (0.0, -0.6, -0.4, -0.2)])
def test_no_tilt_is_told_where_a_cart_rests_before_the_touch(
    seed: int, v: tuple[float, ...]
) -> None:
    """Where both rub and roll one way, it bends three of the four sides as a tilt does."""
    speeds = speeds_of(sides(seed, v, 0.06, 0.0))
    assert speeds.step != "tilt" and told(speeds) == {"friction", "drag"}
    assert [step for step, _ in speeds.held_out] == ["nothing", "friction", "tilt", "drag", "both"]


@pytest.mark.parametrize("seed", range(6))
def test_a_cart_that_turns_round_before_the_touch_does_not_rest(seed: int) -> None:
    """It is as slow as one that rests, and its line is bent."""
    at_the_touch = 0.3 * 0.2  # so that it turns round in the middle of its 0.4 s
    speeds = speeds_of(sides(seed, (0.6, at_the_touch, 0.2, 0.5), 0.0, 0.3))
    assert speeds.step == "tilt" and "tilt" in told(speeds)
