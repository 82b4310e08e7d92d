"""A contact in which no reading lies has a length that is not told; what was seen is told."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.measured.analysis import analysed
from sim.measured.model.effects import compare
from sim.measured.model.fit import fit
from sim.measured.model.known import WIDEST_LOG
from sim.measured.model.unseen_length import of_any_length
from sim.measured.tracks import Measured
from tests.measured.makers import film, truth

BRAKED: tuple[dict[str, Any], ...] = ({"friction": {"coefficient": 0.008}},)


def hard(seed: int, v: tuple[float, float] = (0.8, 0.0)) -> Measured:
    """Hard bumpers at 30 frames a second on a track that brakes: no frame lies in the contact."""
    return film(truth(contact=0.02, effects=BRAKED, v=v), 30, 1.5e-3, seed)


@pytest.mark.parametrize("seed", range(6))
def test_a_film_with_no_frame_inside_a_hard_bump_tells_bounciness_and_masses(seed: int) -> None:
    report = analysed(hard(seed)).report
    known = {one["key"]: one for one in report["known"]}
    real = truth(contact=0.02, effects=BRAKED)
    assert known["e"]["low"] <= real.e <= known["e"]["high"]
    assert known["mass_ratio"]["low"] <= real.ratio <= known["mass_ratio"]["high"]
    touch = known.get("touch")
    assert touch is None or touch["high"] - touch["low"] < 0.25  # seconds, not hours
    assert "duration" not in known


def test_a_contact_that_readings_lie_in_is_told_as_before() -> None:
    measured = film(truth(contact=0.2, effects=BRAKED), 60, 3e-4, 0)
    rows = compare(measured, fit(measured))
    assert all(row.fit.sd("ln_w0") <= WIDEST_LOG for row in rows)
    assert of_any_length(rows, measured) == rows


def test_the_length_itself_stays_untold() -> None:
    measured = hard(1)
    rows = compare(measured, fit(measured))
    freed = [
        after.fit
        for row, after in zip(rows, of_any_length(rows, measured), strict=True)
        if after.fit is not row.fit
    ]
    assert freed
    assert all(math.isinf(one.sd("ln_w0")) for one in freed)


@pytest.mark.parametrize("seed", [1, 11, 15])
def test_a_cart_that_creeps_or_stands_as_the_length_has_it_is_still_read(seed: int) -> None:
    measured = hard(seed, (0.4, 0.03))
    rows = compare(measured, fit(measured))
    after = of_any_length(rows, measured)
    assert any(one.fit is not row.fit for one, row in zip(after, rows, strict=True))
    assert [row.fit.values for row in after] == [row.fit.values for row in rows]
