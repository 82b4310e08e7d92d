"""A friction that nobody sees slows the carts all the same, and the interval counts it."""

from __future__ import annotations

import numpy as np
import pytest

from sim.measured.events.brakes import solved
from sim.measured.events.outcome import HALF
from sim.measured.events.sides import Speeds, speeds_of

BRAKE = 0.015
"""m/s². A good track: 0.9 s after the push each cart is slower by 2 %."""


def explosion(seed: int, brake: float) -> Speeds:
    """Carts at rest, then 0.3 m/s to the left and to the right; 30 frames a second, 0.5 mm."""
    dice = np.random.default_rng(seed)
    tau = np.arange(1, 28) / 30.0
    sides = []
    for k, v in enumerate((0.0, 0.0, -0.3, 0.3)):
        times = tau if k > 1 else -tau
        exact = v * times - 0.5 * np.sign(v) * brake * times**2
        sides.append((times, exact + 5e-4 * dice.standard_normal(len(tau))))
    return speeds_of(sides)


def test_velocities_just_after_lie_in_their_intervals_on_a_track_that_hardly_brakes() -> None:
    """Straight lines told the velocities of half a second later: 60 % lay inside."""
    held = tried = 0
    for seed in range(40):
        found = explosion(seed, BRAKE)
        for k, true in ((2, -0.3), (3, 0.3)):
            sd = found.covariance[k][k] ** 0.5
            held += abs(found.v[k] - true) < HALF * sd
            tried += 1
            assert sd < 0.01
    assert held >= 0.9 * tried, held / tried


def test_what_is_known_beforehand_of_a_brake_holds_where_readings_say_nothing() -> None:
    tau = np.array([0.1, 0.2, 0.3, 0.4])
    sides = [(-tau, 0 * tau), (-tau, 0 * tau), (tau, -0.3 * tau), (tau, 0.3 * tau)]
    dice = np.random.default_rng(1)
    noisy = [(t, x + 2e-3 * dice.standard_normal(4)) for t, x in sides]
    free, held = solved(noisy, "friction")[0], solved(noisy, "friction", 1e-3)[0]
    assert np.all(np.abs(held[8:]) < 0.002)
    assert np.max(np.abs(free[8:])) > 0.01
    assert held[1:8:2] == pytest.approx(solved(noisy, "nothing")[0][1:8:2], abs=2e-3)
