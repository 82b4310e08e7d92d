"""Readings whose push has another shape than the model's: its numbers are no surer than theirs."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from sim.measured.analysis import analysed
from sim.measured.tracks import Measured
from tests.measured.makers import film, truth

E, RATE, LAG = 0.8, 30.0, 0.04


def lagging(seed: int) -> Measured:
    """A device that comes nearer to where the cart is by a share of the way in each frame."""
    effects = ({"friction": {"coefficient": "0.006"}},)
    made = truth(ratio=0.6, e=E, v=(0.6, 0.0), gap=0.6, after=1.2, effects=effects)
    exact, noise = film(made, RATE * 10, 1e-9), film(made, RATE, 4e-4, seed)
    still = film(made, RATE, 1e-9)
    share, tracks = 1.0 - math.exp(-0.1 / (RATE * LAG)), []
    for fine, loud, quiet in zip(exact.tracks, noise.tracks, still.tracks, strict=True):
        at, places = fine.value[0], []
        for k, x in enumerate(fine.value):
            at += share * (x - at)
            places += [at] if k % 10 == 0 else []
        value = (x + a - b for x, a, b in zip(places, loud.value, quiet.value, strict=True))
        tracks.append(replace(loud, value=tuple(value)))
    return replace(noise, tracks=(tracks[0], tracks[1]))


@pytest.mark.parametrize("seed", [1, 2, 4])
def test_a_device_that_lags_behind_widens_what_the_model_tells(seed: int) -> None:
    known = {row["key"]: row for row in analysed(lagging(seed)).report["known"]}
    assert known["e"]["low"] < E < known["e"]["high"] < known["e"]["low"] + 0.2
