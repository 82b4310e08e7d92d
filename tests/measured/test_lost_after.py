"""Carts that stay together while a sensor has lost one of them: only who saw it can say so."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from sim.measured.analysis import Wanted, analysed
from sim.measured.events.story import Hints
from sim.measured.tracks import read_measured
from tests.measured.device_reports import STICKS, known, lost_at_the_touch
from tests.measured.devices import sensor_carts


def report(text: str, *, together: bool) -> dict[str, Any]:
    return analysed(read_measured([text]), Wanted(hints=Hints(together=together))).report


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize("ratio", [0.5, 1.0, 1.6])
def test_what_one_sensor_saw_tells_the_ratio_of_carts_that_stayed_together(
    ratio: float, seed: int
) -> None:
    text = lost_at_the_touch(ratio, seed)
    alone = report(text, together=False)
    assert alone["refused"]["code"] in ("lost-after", "perhaps-lost")
    assert "--together" in alone["refused"]["hint"]
    told = report(text, together=True)
    assert told["outcome"] == "stick"
    found = known(told)["mass_ratio"]
    assert found["low"] <= ratio <= found["high"] < 1.5 * found["low"]
    after = known(told)["v_common"]
    assert after["value"] == pytest.approx(0.6 / (1.0 + ratio), abs=0.02)
    assert any("The velocity of 1 after the contact is that of 2" in s for s in told["sentences"])


def test_who_says_so_of_carts_that_are_seen_to_part_is_told_that_they_part() -> None:
    text = sensor_carts(replace(STICKS, e=0.9, ratio=1.6))
    assert report(text, together=False)["outcome"] == "bounce"
    assert report(text, together=True)["refused"]["code"] == "parted"
