"""Intervals hold the truth where residuals are alike, and stay narrow where they are not."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.special import stdtrit

from sim.measured.model.coloured import colours, cosine_transform, scatter, variances
from sim.measured.model.covariance import covariance_of
from tests.benchmarks.intervals import chain

Floats = NDArray[np.float64]
FILMS = 120
LENGTHS = (60, 60)
"""Readings of two tracks: two seconds of a school film."""

NONE = np.zeros(sum(LENGTHS), dtype=bool)
"""No reading lies in a contact."""

ALIKE = np.ones(sum(LENGTHS))
"""Sizes of noise."""

CHANCE = 0.07
"""Three standard deviations of a share of 0.95 among FILMS pairs of velocities that go together."""


def lines(counts: tuple[int, int] = LENGTHS) -> Floats:
    """Jacobian of two straight lines: a place and a velocity for each track."""
    columns = np.zeros((sum(counts), 4))
    for k, rows in enumerate((slice(0, counts[0]), slice(counts[0], None))):
        columns[rows, 2 * k] = 1.0
        columns[rows, 2 * k + 1] = np.linspace(-1.0, 1.0, counts[k])
    return columns


def judged(rho: float, size: float = 1.0) -> tuple[float, float, float]:
    """Share of true velocities inside of the intervals: ours, those for white noise; how much
    wider ours are, in the median. `size`: of the second track's noise."""
    columns, ours, white, wider = lines(), [], [], []
    inverse = np.linalg.inv(columns.T @ columns)
    freedom = len(columns) - 4
    factor = float(stdtrit(freedom, 0.975))
    for seed in range(FILMS):
        random = np.random.default_rng(seed)
        noise = [chain(LENGTHS[0], rho, random), size * chain(LENGTHS[1], rho, random)]
        both = np.concatenate(noise)
        found = inverse @ columns.T @ both  # the truth is 0
        left = both - columns @ found
        both_left = (left[: LENGTHS[0]], left[LENGTHS[0] :])
        told = np.array(covariance_of(columns, both_left, freedom, NONE, ALIKE))
        plain = float(left @ left) / freedom * inverse
        for k in (1, 3):
            ours.append(abs(found[k]) <= factor * math.sqrt(told[k, k]))
            white.append(abs(found[k]) <= factor * math.sqrt(plain[k, k]))
            wider.append(math.sqrt(told[k, k] / plain[k, k]))
    return float(np.mean(ours)), float(np.mean(white)), float(np.median(wider))


def test_white_noise_costs_little_width() -> None:
    ours, white, wider = judged(0.0)
    assert 0.95 - CHANCE <= white <= ours
    assert 1.0 <= wider <= 1.15


@pytest.mark.parametrize(("rho", "size"), [(0.8, 1.0), (0.5, 2.5)])
def test_noise_that_lasts_makes_intervals_as_wide_as_it_takes(rho: float, size: float) -> None:
    ours, white, _ = judged(rho, size)
    assert ours >= 0.95 - CHANCE
    assert white < 0.85  # of which one would say 95 %


def bumped(size: float) -> tuple[float, float, float]:
    """Share of intervals that hold what twelve readings alone tell, whose noise is `size` times
    that of the others: ours, those that count all readings alike; how much wider ours are."""
    pushed = NONE.copy()
    pushed[27:33] = pushed[87:93] = True
    columns = np.column_stack([lines(), pushed * 1.0])
    inverse, freedom = np.linalg.inv(columns.T @ columns), len(columns) - 5
    factor = float(stdtrit(freedom, 0.975))
    held, wider = [], []
    for seed in range(FILMS // 2):
        noise = np.random.default_rng(seed).normal(size=len(columns)) * np.where(pushed, size, 1.0)
        found = inverse @ columns.T @ noise  # the truth is 0
        left = noise - columns @ found
        both = (left[: LENGTHS[0]], left[LENGTHS[0] :])
        half = [
            factor * math.sqrt(covariance_of(columns, both, freedom, told, ALIKE)[4][4])
            for told in (pushed, NONE)
        ]
        held.append([abs(found[4]) <= one for one in half])
        wider.append(half[0] / half[1])
    return float(np.mean(held, axis=0)[0]), float(np.mean(held, axis=0)[1]), float(np.median(wider))


def test_what_the_contact_s_frames_alone_tell_counts_that_they_may_be_noisier() -> None:
    ours, alike, wider = bumped(1.5)
    assert ours >= 0.95 - CHANCE
    assert alike < ours
    assert wider > 1.1


def test_noise_of_one_size_costs_little_width_in_the_contact() -> None:
    ours, _, wider = bumped(1.0)
    assert ours >= 0.95 - CHANCE
    assert wider < 1.15


def test_the_cosine_transform_keeps_lengths_and_angles() -> None:
    for count in (1, 2, 9, 40):
        basis = cosine_transform(np.eye(count))
        assert np.abs(basis @ basis.T - np.eye(count)).max() < 1e-12


@pytest.mark.parametrize("rho", [0.3, 0.7, 0.93])
def test_a_chain_is_nearly_independent_in_the_cosine_transform(rho: float) -> None:
    count = 80
    steps = np.abs(np.subtract.outer(np.arange(count), np.arange(count)))
    turned = cosine_transform(cosine_transform(rho**steps).T)
    chained = next(one for one in colours() if one.rho == rho and one.share == 1.0)
    told = variances(chained, count)
    # At the longest wave a short chain has less than a long one; neighbours help each other out.
    assert np.diag(turned)[2:] == pytest.approx(told[2:], rel=0.2)
    off = turned - np.diag(np.diag(turned))
    assert np.linalg.norm(off) < 0.25 * np.linalg.norm(np.diag(turned))


def test_all_weights_beforehand_make_one() -> None:
    listed = list(colours())
    assert sum(one.weight for one in listed) == pytest.approx(1.0)
    assert (listed[0].rho, listed[0].share) == (0.0, 0.0)
    assert variances(listed[0], 9) == pytest.approx(np.ones(9))


def some() -> tuple[Floats, list[Floats]]:
    columns = np.linalg.svd(lines((50, 30)), full_matrices=False)[0]
    random = np.random.default_rng(3)
    noise = np.concatenate([chain(50, 0.6, random), 2.0 * chain(30, 0.6, random)])
    left = noise - columns @ (columns.T @ noise)
    return columns, [left[:50], left[50:]]


def test_metres_or_millimetres_tell_the_same() -> None:
    columns, left = some()
    none, alike = np.zeros(80, dtype=bool), np.ones(80)
    large = scatter(columns, [1e3 * one for one in left], 76, none, alike)
    assert large == pytest.approx(1e6 * scatter(columns, left, 76, none, alike), rel=1e-9)


def test_the_order_of_tracks_and_the_direction_of_time_are_free() -> None:
    columns, left = some()
    none, alike = np.zeros(80, dtype=bool), np.ones(80)
    wanted = scatter(columns, left, 76, none, alike)
    swapped = scatter(np.vstack([columns[50:], columns[:50]]), left[::-1], 76, none, alike)
    assert swapped == pytest.approx(wanted, rel=1e-9, abs=1e-12)
    back = np.vstack([columns[49::-1], columns[:49:-1]])
    assert scatter(back, [one[::-1] for one in left], 76, none, alike) == pytest.approx(
        wanted, rel=1e-9, abs=1e-12
    )


@pytest.mark.parametrize("left", [0.0, 1e-300, 1e-16])
def test_readings_without_noise_have_no_colour_and_no_impossible_scatter(left: float) -> None:
    columns, _ = some()
    residuals: Any = [left * np.ones(50), -left * np.ones(30)]
    found = scatter(columns, residuals, 76, np.zeros(80, dtype=bool), np.ones(80))
    assert np.all(np.isfinite(found))
    assert np.all(np.diag(found) >= 0.0)
