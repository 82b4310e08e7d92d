"""Readings in whole centimetres: the jitter of rounding is noise, and a contact ends in spite of
it, also where the other cart rests and its readings are all alike."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sim.measured.analysis import analysed
from sim.measured.events.contacts import contacts
from sim.measured.events.grid import grid_of
from sim.measured.tracks import Measured
from tests.measured.makers import film, truth

HIT = truth(mass=0.5, ratio=1.5, e=0.6, v=(0.43, 0.0), contact=0.05, gap=0.75, after=1.3)


def in_steps(of: Measured, step: float) -> Measured:
    """The readings rounded to whole steps [m], as a ranger or a spreadsheet does."""
    first, second = (
        replace(track, value=tuple(float(np.round(x / step) * step) for x in track.value))
        for track in of.tracks
    )
    return replace(of, tracks=(first, second))


@pytest.mark.parametrize("rate", [40.0, 50.0])
@pytest.mark.parametrize("seed", range(4))
def test_a_contact_of_rounded_readings_ends(rate: float, seed: int) -> None:
    """It went on for 0.55 to 1.9 s, until the last reading."""
    rounded = in_steps(film(HIT, rate, 3e-4, seed=seed), 0.01)
    (found,) = contacts(grid_of(rounded.tracks))
    assert found.end - found.begin < 0.35


@pytest.mark.parametrize("seed", range(4))
def test_a_film_in_whole_centimetres_is_told_and_its_intervals_hold(seed: int) -> None:
    found = analysed(in_steps(film(HIT, 50.0, 3e-4, seed=seed), 0.01)).report
    assert "refused" not in found
    told = {row["key"]: row for row in found["known"]}
    assert told["e"]["low"] < HIT.e < told["e"]["high"]
    if ratio := told.get("mass_ratio"):
        assert ratio["low"] < HIT.ratio < ratio["high"]
