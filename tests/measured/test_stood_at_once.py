"""A cart that stands in every reading after a contact may have left it slowly."""

from __future__ import annotations

import pytest

from sim.dynamics.loop.run import run
from sim.measured.analysis import analysed
from tests.measured.makers import film, truth


@pytest.mark.parametrize(("e", "seed"), [(0.985, 2), (0.999, 3), (0.999, 4)])
def test_a_velocity_that_friction_takes_before_the_first_reading_lies_inside(
    e: float, seed: int
) -> None:
    """Equal masses: up to 6 mm/s at the parting, which 0.07 m/s² take in a tenth of a second; the
    readings after it tell less than 1 mm/s."""
    effects = ({"friction": {"coefficient": "0.007"}},)
    made = truth(ratio=1.0, e=e, v=(0.55, 0.0), contact=0.1, gap=0.5, after=0.9, effects=effects)
    parted = next(one for one in run(made.scene).record.events if one.kind == "separate")
    known = {row["key"]: row for row in analysed(film(made, 60, 3e-4, seed)).report["known"]}
    assert known["v_a_after"]["low"] < parted.after["A"] < known["v_a_after"]["high"]
    assert known["e"]["low"] < e < known["e"]["high"]
    assert known["e"]["high"] - known["e"]["low"] < 0.1
