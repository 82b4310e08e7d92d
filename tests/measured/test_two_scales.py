"""Two sensors have two scales and two clocks, also where both happen to count on one axis."""

from __future__ import annotations

from dataclasses import replace

import pytest

from sim.measured.analysis import analysed
from sim.measured.tracks import Measured
from tests.measured.makers import film, truth

E, LOUD = 0.8, 5e-4


def seen(seed: int, scale: float = 1.0, turned: bool = False) -> Measured:
    """By a sensor for each cart; B's reads `scale` times each length, or looks the other way."""
    effects = ({"friction": {"coefficient": "0.005"}},)
    made = film(truth(ratio=1.5, e=E, v=(0.6, -0.1), effects=effects), 50, LOUD, seed)
    a, b = made.tracks
    value = tuple(3.0 - scale * x if turned else scale * x for x in b.value)
    return replace(made, tracks=(a, replace(b, value=value)), own=True)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_bounciness_holds_where_one_sensor_reads_every_length_too_long(seed: int) -> None:
    known = {row["key"]: row for row in analysed(seen(seed, 1.015)).report["known"]}
    assert known["e"]["low"] < E < known["e"]["high"] < known["e"]["low"] + 0.15


def test_it_does_not_matter_in_which_direction_a_sensor_counts() -> None:
    one, other = (
        {row["key"]: row for row in analysed(seen(1, turned=turned)).report["known"]}
        for turned in (False, True)
    )
    for key in ("e", "mass_ratio", "v_a", "v_b", "v_a_after", "v_b_after"):
        for end in ("low", "high"):
            assert one[key][end] == pytest.approx(other[key][end], abs=1e-6)
