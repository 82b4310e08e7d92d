"""A standing cart's tidy readings do not make the contact look surely known."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import numpy as np
import pytest

from sim.measured.model.fit import fit
from sim.measured.model.standing import as_if_moving
from tests.measured.makers import film, truth

MOVING, STANDING = 2.5e-4, 7e-5  # m, as after strong compression
FILMS = 16


def compressed(seed: int) -> tuple[float, float]:
    """ln w0 as fitted, less the truth, and half of its interval."""
    made, random = truth(contact=0.15, v=(0.8, 0.0)), Random(seed)
    plain = film(made, rate=60, noise=0.0)
    tracks = []
    for cart, track in enumerate(plain.tracks):
        noisy = tuple(
            x + random.gauss(0.0, STANDING if cart == 1 and t < made.touch else MOVING)
            for t, x in zip(track.t, track.value, strict=True)
        )
        tracks.append(replace(track, value=noisy))
    found = fit(replace(plain, tracks=(tracks[0], tracks[1])))
    k = found.unknowns.index("ln_w0")
    return found.values[k] - made.of("ln_w0"), found.factor * found.sd("ln_w0")


def test_intervals_of_the_stiffness_hold_where_a_standing_cart_is_tidier() -> None:
    told = [compressed(seed) for seed in range(FILMS)]
    assert sum(abs(off) <= half for off, half in told) >= 0.9 * FILMS
    scatter = float(np.std([off for off, _ in told]))
    assert np.median([half for _, half in told]) > 1.6 * scatter


@pytest.mark.parametrize("v", [(0.8, 0.0), (0.8, -0.2)])
def test_residuals_of_one_noise_stay_as_they_are(v: tuple[float, float]) -> None:
    found = fit(film(truth(v=v), rate=120))
    residuals = (np.array(found.residuals[0]), np.array(found.residuals[1]))
    t = film(truth(v=v), rate=120).tracks
    times = (np.array(t[0].t), np.array(t[1].t))
    same = as_if_moving(residuals, times, found.parameters)
    assert all(np.array_equal(a, b) for a, b in zip(same, residuals, strict=True))


def test_only_the_standing_cart_s_residuals_are_enlarged() -> None:
    found = fit(film(truth(v=(0.8, 0.0)), rate=120)).parameters
    t = np.linspace(found.touch - 0.5, found.touch + 0.5, 100)
    r = np.where(t < found.touch, 0.01, 1.0) * np.tile([1.0, -1.0], 50)
    usual = np.tile([1.0, -1.0], 50)
    first, second = as_if_moving((usual, r), (t, t), replace(found, v=(0.8, 0.0)))
    assert np.array_equal(first, usual)
    assert np.abs(second) == pytest.approx(np.ones(100))
