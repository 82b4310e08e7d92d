"""Every hard case of the table ends as its source says; and some that are too long for a table."""

from __future__ import annotations

import pytest

from sim.bridge.end_state import read
from sim.dynamics.loop.run import run
from sim.dynamics.report.document import report
from sim.pages.hard_cases import ALL, HardCase
from sim.pages.hard_cases.collisions import pi_billiard, pi_digits
from sim.scene import read_scene
from tests.dynamics.given.box_of_two import box_of_two

COUNTED = {"keep_events": False, "keep_motion": False}


@pytest.mark.parametrize("case", ALL, ids=lambda case: case.name)
def test_a_hard_case_ends_as_its_source_says(case: HardCase) -> None:
    found = report(run(read_scene(case.plain), keep_events=case.events, keep_motion=case.events))
    for expected in case.expected:
        got = read(found, expected.what)
        assert abs(got - expected.value) <= expected.tolerance, (expected.what, got, case.why)


def test_every_row_has_a_name_of_its_own() -> None:
    names = [case.name for case in ALL]
    assert len(names) == len(set(names)) >= 40


def test_five_digits_of_pi_are_counted() -> None:
    """Galperin, M/m = 1e8: 31,415 impacts."""
    finished = run(read_scene(pi_billiard(4, law="instant")), **COUNTED)
    assert finished.record.counts["contact"] == pi_digits(4) == 31_415
    assert finished.ledger.energy_final == pytest.approx(0.5e8, rel=1e-10)


def test_three_digits_fewer_where_bumpers_are_soft() -> None:
    """Contacts that overlap in time, against a 40-digit event solver: 313 of 314."""
    finished = run(read_scene(pi_billiard(2, stiffness=1e8)), **COUNTED)
    assert finished.record.counts["separate"] == 313


@pytest.mark.slow
def test_a_million_elastic_impacts_keep_the_energy() -> None:
    """v' = V + e (V − v) keeps 1e-13; the usual impulse form drifts by 1e-10."""
    finished = run(read_scene(box_of_two(1e9)), max_events=1_000_000, **COUNTED)
    assert finished.outcome.kind == "too-many-events"
    assert finished.record.counts["contact"] == 1_000_000
    ledger = finished.ledger
    assert ledger.energy_final == pytest.approx(ledger.energy_initial, rel=1e-11)
