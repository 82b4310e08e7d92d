"""A sensor at each end of the track: hands that push both carts at one time are no explosion."""

from __future__ import annotations

import numpy as np
import pytest

from sim.measured.analysis import analysed
from sim.measured.tracks import read_measured

LENGTH, PUSH, MEET = 2.2, 0.3, 1.1
"""m between the sensors; s that hands push, and until the carts meet."""


def log(seed: int, *, until: float, apart: bool = False) -> str:
    """Both pushed from 0.5 s on to 0.5 and 0.4 m/s; they meet and part with e = 0.8, equal masses.
    `apart`: pushed away from each other instead, and nothing follows."""
    t = np.arange(0.0, until, 0.025)
    dice = np.random.default_rng(seed)
    since = np.clip(t - 0.5, 0.0, None)
    moved = np.where(since < PUSH, since**2 / (2 * PUSH), since - PUSH / 2)
    a, b = 0.5 * moved, 0.4 * moved  # away from each sensor
    after = np.clip(since - MEET, 0.0, None)
    if apart:
        a, b = -a, -b
    else:  # of 0.5 and −0.4 come −0.31 and 0.41 along A's axis
        a, b = a - 0.81 * after, b - 0.81 * after
    x1, x2 = (0.9 if apart else 0.4) + a, (0.9 if apart else LENGTH - 1.8 + 0.2) + b
    lines = ["Time (s),Position 1 (m),Position 2 (m)"]
    for row in zip(t, x1, x2, strict=True):
        noisy = (row[0], *(x + 4e-4 * dice.standard_normal() for x in row[1:]))
        lines.append(",".join(f"{value:.4f}" for value in noisy))
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("seed", range(3))
def test_carts_that_go_away_from_their_sensors_meet(seed: int) -> None:
    """It was told as an explosion of the two hands, with the ratio of the hands' pushes."""
    found = analysed(read_measured([log(seed, until=2.8)])).report
    assert found["outcome"] == "bounce"
    told = {row["key"]: row for row in found["known"]}
    assert told["e"]["low"] < 0.8 < told["e"]["high"]
    assert told["mass_ratio"]["low"] < 1.0 < told["mass_ratio"]["high"]


def test_a_log_that_ends_before_they_meet_says_so() -> None:
    refused = analysed(read_measured([log(1, until=1.5)])).report["refused"]
    assert refused["code"] == "no-contact"
    assert "away from its sensor" in refused["sentence"] and "until the carts" in refused["hint"]


def test_carts_that_come_closer_to_their_sensors_are_an_explosion() -> None:
    found = analysed(read_measured([log(1, until=1.9, apart=True)])).report
    assert found["outcome"] == "explosion"


def zeroed(seed: int, sign: int) -> str:
    """Each sensor counts from its cart's start; the hands push to 0.5 and 0.1 m/s at one time, and
    the carts, equals, meet and stick. `sign`: the way in which the second sensor counts."""
    t = np.arange(0.0, 3.0, 0.025)
    dice = np.random.default_rng(seed)
    since = np.clip(t - 0.5, 0.0, None)
    moved = np.where(since < PUSH, since**2 / (2 * PUSH), since - PUSH / 2)
    after = np.clip(since - MEET, 0.0, None)
    a, b = 0.5 * moved - 0.3 * after, sign * (0.1 * moved - 0.3 * after)
    lines = ["Time (s),Position 1 (m),Position 2 (m)"]
    for row in zip(t, a, b, strict=True):
        noisy = (row[0], *(x + 3e-4 * dice.standard_normal() for x in row[1:]))
        lines.append(",".join(f"{value:.4f}" for value in noisy))
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("sign", [1, -1])
def test_carts_that_set_out_and_meet_unturned_were_not_parted_before(sign: int) -> None:
    found = analysed(read_measured([zeroed(2, sign)])).report
    assert found["outcome"] == "stick"
    told = {row["key"]: row for row in found["known"]}
    assert told["mass_ratio"]["low"] < 1.0 < told["mass_ratio"]["high"]
    (contact,) = (row for row in found["contacts"] if row["chosen"])
    assert contact["from"] < 0.5 + MEET < contact["until"]
