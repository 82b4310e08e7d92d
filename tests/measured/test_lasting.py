"""How long a contact lasts is no surer than the law by which the bumpers push."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from sim.measured.analysis import analysed
from sim.measured.model.lasting import MAGNETS, SHAPES, by_any_law, smoothed
from sim.measured.model.quantity import Known
from sim.measured.track import Track
from sim.measured.tracks import Measured
from tests.measured.makers import film, truth

SURE = Known("duration", "the contact lasts", 0.1, 0.0999, 0.1001, 5e-5, "s")


def width(push: str) -> float:
    """Root mean square of the time around the middle of a push that lasts 1, as its share."""
    t = np.linspace(0.0, 1.0, 100001)
    f = {"sine": np.sin(np.pi * t), "even": np.ones_like(t), "soft": 1 - np.cos(2 * np.pi * t)}
    return float(np.sqrt(np.average((t - 0.5) ** 2, weights=f[push])))


@pytest.mark.parametrize("push", ["even", "soft"])
def test_a_push_of_another_shape_with_the_same_width_lies_in_the_interval(push: str) -> None:
    times = width("sine") / width(push)
    found = by_any_law(SURE, 0.7, 0.75)
    assert found.low < times * SURE.value < found.high
    assert found.low == pytest.approx(SURE.value * math.exp(-SHAPES), rel=1e-3)


def test_weak_and_long_or_strong_and_short_springing_back_are_not_told_apart() -> None:
    assert by_any_law(SURE, 0.16, 0.2).high == pytest.approx(SURE.value / 0.16**0.5, rel=1e-3)
    assert by_any_law(SURE, 0.9, 0.92).high < 1.5 * SURE.value


def test_carts_that_lose_nothing_may_be_magnets_which_push_from_afar() -> None:
    found = by_any_law(SURE, 0.94, 0.99)
    assert found.high == pytest.approx(SURE.value * math.exp(MAGNETS), rel=1e-3)


@pytest.mark.parametrize(
    ("rate", "own", "alike", "least"),
    [(30, False, 0.1, 0.0), (20, False, 0.1, 0.35), (50, True, 0.1, 0.14), (50, False, 0.6, 0.14)],
)
def test_a_logger_or_smoothing_may_have_made_a_contact_long_and_a_film_has_not(
    rate: int, own: bool, alike: float, least: float
) -> None:
    t = tuple(k / rate for k in range(40))
    first, second = (Track(name, t, t, tuple(range(40))) for name in "AB")
    assert smoothed(Measured("length", (first, second), (), own), alike) == pytest.approx(least)


def means(track: Track) -> Track:
    """The same with means over five readings, as loggers give them."""
    whole = np.pad(np.array(track.value), 2, mode="edge")
    return replace(track, value=tuple(np.convolve(whole, np.ones(5) / 5, "valid").tolist()))


def test_of_smoothed_readings_under_a_films_heads_no_length_of_a_contact_is_told() -> None:
    wanted = truth(mass=0.25, ratio=1.1, e=0.6, v=(0.5, 0.1), contact=0.03, after=1.0)
    plain = film(wanted, 25, 5e-4, seed=3)
    a, b = map(means, plain.tracks)
    report = analysed(replace(plain, tracks=(a, b))).report
    assert report["outcome"] == "bounce"
    assert "duration" not in {one["key"] for one in report["known"]}
