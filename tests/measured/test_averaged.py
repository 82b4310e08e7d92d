"""A brake that the readings do not show counts as much as it is likely."""

from __future__ import annotations

from dataclasses import replace

import pytest

from sim.measured.analysis import Wanted, analysed
from sim.measured.model.averaged import averaged
from sim.measured.model.brake_doubt import doubted
from sim.measured.model.effects import Compared, compare
from sim.measured.model.fit import Asked, fit
from sim.measured.model.quantity import Known
from tests.measured.makers import film, truth

FAINT = truth(
    e=0.6, v=(0.6, 0.0), gap=0.5, after=0.8, contact=0.05,
    effects=({"friction": {"coefficient": 0.0012}},),
)  # fmt: skip
"""A good air track: 0.012 m/s², which a film of 30 frames per second and 2 mm hardly shows."""
FAINT_AT_THE_TOUCH = (0.6**2 - 2.0 * 0.0012 * 9.81 * 0.5) ** 0.5
"""m/s. Of A, after half a metre with friction."""


@pytest.fixture(scope="module")
def rows() -> list[Compared]:
    readings = film(truth(), 60.0, 1e-3, seed=3)
    return compare(readings, fit(readings, Asked()))


def test_a_friction_that_stays_unseen_is_counted_in_the_intervals() -> None:
    """Told without a brake, the velocity of A missed the truth in eight of these twelve films."""
    inside = 0
    for seed in range(12):
        found = analysed(film(FAINT, 30.0, 2e-3, seed=seed)).report
        v = next(row for row in found["known"] if row["key"] == "v_a")
        inside += v["low"] < FAINT_AT_THE_TOUCH < v["high"]
    assert inside >= 10


def test_an_effect_that_is_as_likely_counts_by_its_share_and_no_value_changes(
    rows: list[Compared],
) -> None:
    plain = rows[0].fit
    far = replace(plain, asked=Asked(effect="tilt"),
                  values=tuple(one + 0.1 for one in plain.values))  # fmt: skip
    twin = Compared("tilt", plain.noise, 0.5, 0.0, far)
    found = averaged(plain, [rows[0], twin])
    more = found.sd("v1") ** 2 - plain.sd("v1") ** 2
    assert more == pytest.approx(0.5 * 0.1**2, rel=1e-6)
    assert found.values == plain.values
    assert found.parameters == plain.parameters


def test_an_effect_that_the_readings_rule_out_counts_nothing(rows: list[Compared]) -> None:
    plain = rows[0].fit
    ruled_out = replace(plain, asked=Asked(effect="tilt"), squares=2.0 * plain.squares,
                        values=tuple(one + 0.1 for one in plain.values))  # fmt: skip
    found = averaged(plain, [rows[0], Compared("tilt", plain.noise, 1.0, 0.0, ruled_out)])
    assert found.sd("v1") == pytest.approx(plain.sd("v1"), rel=1e-9)


def test_an_effect_that_the_reader_asks_for_is_taken_for_certain() -> None:
    readings = film(FAINT, 30.0, 2e-3, seed=1)
    own, asked = (
        next(row for row in analysed(readings, wanted).report["known"] if row["key"] == "v_a")
        for wanted in (Wanted(), Wanted(effect="none"))
    )
    assert asked["high"] - asked["low"] < own["high"] - own["low"]


def test_velocities_too_are_no_surer_than_those_beside_the_contact(rows: list[Compared]) -> None:
    tilted = next(row.fit for row in rows if row.effect == "tilt")
    p, sd = tilted.parameters, 5.0 * tilted.sd("v1")
    beside = Known("v_a", "velocity of A before", p.v[0], p.v[0] - sd, p.v[0] + sd, sd, "m/s")
    found = doubted(tilted, [beside], told=False)
    assert found.sd("v1") == pytest.approx(sd, rel=1e-9)
