"""A standing cart's tidy readings do not make the contact look surely known."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from random import Random

import numpy as np
import pytest

from sim.measured.model.fit import Fit, fit
from sim.measured.model.standing import sizes_of
from tests.measured.makers import film, truth

MOVING, STANDING = 2.5e-4, 7e-5  # m, as after strong compression
FILMS = 16
MADE = truth(contact=0.15, v=(0.8, 0.0))


@cache
def compressed(seed: int) -> Fit:
    """A film of MADE after strong compression, fitted."""
    random, plain = Random(seed), film(MADE, rate=60, noise=0.0)
    tracks = []
    for cart, track in enumerate(plain.tracks):
        noisy = tuple(
            x + random.gauss(0.0, STANDING if cart == 1 and t < MADE.touch else MOVING)
            for t, x in zip(track.t, track.value, strict=True)
        )
        tracks.append(replace(track, value=noisy))
    return fit(replace(plain, tracks=(tracks[0], tracks[1])))


@pytest.mark.parametrize("unknown", ["ln_w0", "v2"])
def test_intervals_hold_and_are_not_too_wide_where_a_standing_cart_is_tidier(
    unknown: str,
) -> None:
    told = [compressed(seed) for seed in range(FILMS)]
    off = [one.values[one.unknowns.index(unknown)] - MADE.of(unknown) for one in told]
    halves = [one.factor * one.sd(unknown) for one in told]
    assert sum(abs(a) <= b for a, b in zip(off, halves, strict=True)) >= 0.9 * FILMS
    assert 1.6 < np.median(halves) / np.std(off) < 2.6  # of normal noise: 2


@pytest.mark.parametrize("v", [(0.8, 0.0), (0.8, -0.2)])
def test_residuals_of_one_noise_have_one_size(v: tuple[float, float]) -> None:
    found = fit(film(truth(v=v), rate=120))
    residuals = (np.array(found.residuals[0]), np.array(found.residuals[1]))
    t = film(truth(v=v), rate=120).tracks
    times = (np.array(t[0].t), np.array(t[1].t))
    assert all(np.all(one == 1.0) for one in sizes_of(residuals, times, found.parameters))


def test_only_the_standing_cart_s_noise_is_smaller() -> None:
    found = fit(film(truth(v=(0.8, 0.0)), rate=120)).parameters
    t = np.linspace(found.touch - 0.5, found.touch + 0.5, 100)
    tidy = np.where(t < found.touch, 0.01, 1.0)
    usual = np.tile([1.0, -1.0], 50)
    first, second = sizes_of((usual, tidy * usual), (t, t), replace(found, v=(0.8, 0.0)))
    assert np.all(first == 1.0)
    assert second == pytest.approx(tidy)
