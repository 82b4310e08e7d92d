"""A cart that a hand lets go just before it meets the other: few readings lie between."""

from __future__ import annotations

import math
import random
from typing import Any

import numpy as np
import pytest

from sim.measured.events.by_hand import Given
from sim.measured.events.nearer import nearer
from sim.measured.events.story import Hints, story_of
from sim.measured.tracks import read_measured
from tests.measured.uniform_logs import table

FRAME, STEP, NOISE = 0.05, 1.715e-4, 6e-5  # s, m, m: a wheel that counts steps
SPEED, PUSHED, FREE, SOFT = 0.65, 0.15, 0.38, 0.08  # m/s and s: hand, then free, then contact


def log(ratio: float, e: float, seed: int) -> str:
    """A is pushed from rest, runs free for eight readings and meets B softly."""
    dice = random.Random(seed)
    let_go = 0.6 + PUSHED
    touch = let_go + FREE
    common = SPEED / (1.0 + ratio)
    ends = common * (1.0 - ratio * e), common * (1.0 + e)
    fine = np.arange(0.0, 2.4, 1e-3)
    rise = np.clip((fine - 0.6) / PUSHED, 0.0, 1.0)
    given = np.clip((fine - touch) / SOFT, 0.0, 1.0)
    given = 0.5 - 0.5 * np.cos(np.pi * given)
    a = np.cumsum(SPEED * rise + (ends[0] - SPEED) * given) * 1e-3
    b = np.cumsum(ends[1] * given) * 1e-3 + 0.4
    times = np.arange(0.0, 2.35, FRAME)

    def read(x: Any) -> list[float]:
        seen = [one + dice.gauss(0.0, NOISE) for one in np.interp(times, fine, x)]
        return [STEP * round(one / STEP) for one in seen]

    return table("t (s),x_A (m),x_B (m)", times.tolist(), read(a), read(b))


@pytest.mark.parametrize("seed", [1, 2, 3])
@pytest.mark.parametrize(("ratio", "e"), [(0.6, 0.9), (1.0, 0.5), (1.6, 0.2)])
def test_what_smoothing_took_for_the_contact_tells_the_velocity_before_it(
    ratio: float, e: float, seed: int
) -> None:
    """Of a hand that is seen, or set, to end a little later three readings were left: refused."""
    held = Hints(segments=(Given("hand", 0.55, 0.88, 0),))
    told = story_of(read_measured([log(ratio, e, seed)]), held)
    assert told.refused is None and told.speeds
    before, spread = told.speeds.v[0], math.sqrt(told.speeds.covariance[0][0])
    assert before == pytest.approx(SPEED, abs=2.0 * spread)
    assert spread < 0.05 * SPEED


def test_readings_that_are_pushed_are_not_taken() -> None:
    t = np.arange(10) * FRAME
    x = SPEED * t - 2.0 * np.clip(t - 4.5 * FRAME, 0.0, None) ** 2
    kept = (t > 0.5 * FRAME) & (t < 3.5 * FRAME)
    more = nearer(t, x, kept, (3.6 * FRAME, 9.6 * FRAME), after=False)
    assert np.flatnonzero(more).tolist() == [1, 2, 3, 4]
    back = nearer(t, x[::-1], kept[::-1], (-0.6 * FRAME, 5.4 * FRAME), after=True)
    assert np.flatnonzero(back).tolist() == [5, 6, 7, 8]
