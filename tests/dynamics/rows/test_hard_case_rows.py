"""Every hard case of the table ends as its source says; and some that are too long for a table."""

from __future__ import annotations

from decimal import Decimal, localcontext

import pytest

from sim.bridge.end_state import read
from sim.dynamics.loop.run import run
from sim.dynamics.report.document import report
from sim.pages.hard_cases import ALL, HardCase
from sim.pages.hard_cases.collisions import CRADLES, pi_billiard, pi_digits
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


NAMED = {case.name: case for case in ALL}


def one_after_the_other(case: HardCase, most: int) -> tuple[int, Decimal, list[Decimal]]:
    """Impacts (at most so many), s of the last and m/s after it: the next impact of equal carts on
    a line, again and again, in 300 digits."""
    carts = case.plain["carts"].values()
    with localcontext() as context:
        context.prec = 300
        x, v, length = (
            [Decimal(str(cart[key])) for cart in carts]
            for key in ("position", "velocity", "length")
        )
        e = Decimal(case.plain["contact"]["restitution"])
        t, count = Decimal(0), 0
        while count < most:
            closing = [k for k in range(len(v) - 1) if v[k] > v[k + 1]]
            if not closing:
                break
            after, k = min(((x[k + 1] - x[k] - length[k]) / (v[k] - v[k + 1]), k) for k in closing)
            t, count = t + after, count + 1
            x = [a + w * after for a, w in zip(x, v, strict=True)]
            centre, half = (v[k] + v[k + 1]) / 2, e * (v[k] - v[k + 1]) / 2
            v[k], v[k + 1] = centre - half, centre + half
    return count, t, v


def test_three_carts_just_above_the_limit_hit_each_other_as_often_as_the_row_says() -> None:
    """From the middle all were struck at one instant: two contacts, and every method was right."""
    case = NAMED["collapse-just-above"]
    count, _, v = one_after_the_other(case, 1000)
    assert f"{count} times" in case.sentence
    assert ("count.contact", count) in [(one.what, one.value) for one in case.expected]
    found = run(read_scene(case.plain))
    assert found.record.counts["contact"] == count > 10
    assert found.v == pytest.approx([float(w) for w in v], abs=1e-16)
    assert found.v[0] < found.v[1] < found.v[2]  # they part


def test_three_carts_below_the_limit_hit_each_other_without_end_before_the_time_of_the_row() -> (
    None
):
    case = NAMED["collapse-below"]
    count, t, v = one_after_the_other(case, 400)
    assert count == 400 and max(map(abs, v)) < 1e-100
    (last,) = (one.value for one in case.expected if one.what == "last.contact")
    assert last == pytest.approx(float(t), rel=1e-15) and f"in {last:.4f} s" in case.sentence
    found = run(read_scene(case.plain))
    assert found.record.counts["contact"] > 10
    assert len({*found.v}) == 1  # one velocity


@pytest.mark.parametrize("case", CRADLES, ids=lambda case: case.name)
def test_the_digits_of_a_cradle_are_rounded_and_not_cut_off(case: HardCase) -> None:
    """cradle-4 had 0.236977608 for 0.23697760736, and a tolerance that let it pass."""
    found = run(read_scene(case.plain))
    digits = 6 if case.name.startswith("hertz") else 9
    assert [one.value for one in case.expected] == [round(v, digits) for v in found.v]
    assert max(one.tolerance for one in case.expected) < 10.0**-digits


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
