"""Readings in whole centimetres: the jitter of rounding is noise, and a contact ends in spite of
it, also where the other cart rests and its readings are all alike."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sim.measured.analysis import analysed
from sim.measured.events.contacts import contacts
from sim.measured.events.grid import grid_of
from sim.measured.tracks import Measured, read_measured
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


@pytest.mark.parametrize("frame", [0.04, 0.05, 0.1])
@pytest.mark.parametrize("ratio", [1.0, 2.0])
def test_ideal_numbers_that_somebody_types_hold_the_truth(ratio: float, frame: float) -> None:
    """A cart that rests, one number again and again, and a bump of no length; e = 0.6."""
    touch, v, common = 1.5, 0.5, 0.5 / (1.0 + ratio)
    after = common - 0.3 * ratio / (1.0 + ratio), common + 0.3 / (1.0 + ratio)
    lines = ["t (s);A (m);B (m)"]
    for k in range(round(3.0 / frame)):
        t = k * frame
        a = 0.1 + v * min(t, touch) + after[0] * max(0.0, t - touch)
        lines.append(f"{t:.3f};{a:.2f};{1.05 + after[1] * max(0.0, t - touch):.2f}")
    report = analysed(read_measured(["\n".join(lines)])).report
    known = {one["key"]: one for one in report["known"]}
    assert known["mass_ratio"]["low"] <= ratio <= known["mass_ratio"]["high"]
    assert known["e"]["low"] <= 0.6 <= known["e"]["high"]
