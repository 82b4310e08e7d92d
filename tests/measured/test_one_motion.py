"""Two columns of one cart's motion are no collision; two sensors that face each other may be."""

from __future__ import annotations

from random import Random

import pytest

from sim.measured.events.story import Hints, story_of
from sim.measured.tracks import read_measured


def marks(speed_of_b: float, noise: float = 5e-4) -> str:
    """A turns back at 1 s; the second column moves alike, at so many times its speed."""
    dice, rows = Random(1), ["t (s),x_A (m),x_B (m)"]
    for k in range(60):
        x = 0.5 * k / 30 if k < 30 else 0.5 - 0.054 * (k / 30 - 1)
        a, b = x + dice.gauss(0, noise), 0.1 + speed_of_b * x + dice.gauss(0, noise)
        rows.append(f"{k / 30:.4f},{a:.5f},{b:.5f}")
    return "\n".join(rows)


@pytest.mark.parametrize("noise", [0, 5e-4, 2e-3])
def test_one_motion_in_both_columns_is_no_bounce(noise: float) -> None:
    """It was one, "by the third law", with e = 0.107 and a mass ratio of 1.000."""
    refused = story_of(read_measured([marks(1, noise)])).refused
    assert refused is not None and refused.code == "one-motion"


def test_whoever_turns_a_sensor_says_that_there_are_two() -> None:
    story = story_of(read_measured([marks(1)]), Hints(flips=("B",)))
    assert story.refused is None and story.outcome == "bounce"


def test_sensors_that_face_each_other_are_joined_where_the_carts_differ() -> None:
    story = story_of(read_measured([marks(0.9)]))
    assert story.refused is None and story.outcome == "bounce"
