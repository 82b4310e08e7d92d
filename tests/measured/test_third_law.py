"""Two force sensors: equal and opposite is found, and so is what is not."""

from __future__ import annotations

import math
from dataclasses import replace
from random import Random

import pytest

from sim.measured.refusal import FitError
from sim.measured.report import forces_report
from sim.measured.third_law import third_law
from sim.measured.track import Track
from sim.measured.tracks import Measured, read_measured
from tests.measured.devices import Motion, phone
from tests.measured.force_sensors import sensors


def test_equal_and_opposite_forces_are_found_equal() -> None:
    found = third_law(sensors())
    assert abs(found.ratio - 1.0) <= found.ratio_half < 0.02
    impulse = 1.5 * 0.5 / 2.0 * 1.8 * 0.8 * 1.0  # mu (1 + e) u, mu = 0.375 kg
    assert impulse == pytest.approx(0.54)
    for value, wanted in zip(found.impulses, (-0.54, 0.54), strict=True):
        assert value == pytest.approx(wanted, abs=4 * found.impulse_sd[0])
    assert abs(found.worst[1]) < 5 * math.hypot(*found.noise)


def test_the_interval_of_the_ratio_holds_the_truth_as_often_as_promised() -> None:
    found = [third_law(sensors(seed=seed)) for seed in range(40)]
    inside = sum(abs(one.ratio - 1.0) <= one.ratio_half for one in found)
    assert 34 <= inside <= 40


@pytest.mark.parametrize("noise", [0.02, 0.05])
@pytest.mark.parametrize("factor", [0.9, 1.1, 1.2])
def test_a_sensor_that_reads_too_much_or_too_little_is_not_called_a_law(
    factor: float, noise: float
) -> None:
    measured = sensors(factor=factor, noise=noise)
    found = third_law(measured)
    assert found.ratio == pytest.approx(factor, abs=2 * found.ratio_half)
    said = " ".join(forces_report(measured, found)["sentences"])
    assert "Swap the sensors" in said
    assert "equal in size" not in said


def test_zeros_are_taken_off_and_told() -> None:
    found = third_law(sensors(zeros=(0.4, -0.3)))
    assert found.zeros == pytest.approx((0.4, -0.3), abs=0.02)
    assert abs(found.ratio - 1.0) <= 2 * found.ratio_half


def test_sensors_that_both_count_a_push_as_positive_are_turned() -> None:
    assert third_law(sensors(push_is_positive=True)).turned
    assert not third_law(sensors()).turned


def test_a_late_clock_is_told_as_a_clock() -> None:
    measured = sensors(late=0.004)
    found = third_law(measured)
    assert found.lag == pytest.approx(0.004, abs=0.001)
    assert any("clock" in one for one in forces_report(measured, found)["sentences"])
    early = sensors(late=-0.004)
    told = " ".join(forces_report(early, third_law(early))["sentences"])
    assert "The readings of A come 3.9 ms later than those of B" in told


@pytest.mark.parametrize("late", [0.0, 0.01])
@pytest.mark.parametrize("hand", [2.0, 8.0])
def test_a_push_on_one_sensor_alone_is_no_agreement(hand: float, late: float) -> None:
    """One common push, and a hand on each sensor at another time: as scattered as it is, the ratio
    is near 1, and at no hand's instant are both forces equal. A late clock hides nothing."""
    measured = sensors(late=late)
    tracks = [
        replace(track, value=tuple(
            value + (hand if begin <= t < begin + 0.05 else 0.0)
            for t, value in zip(track.t, track.value, strict=True)
        ))
        for begin, track in zip((0.32, 0.70), measured.tracks, strict=True)
    ]  # fmt: skip
    pushed = replace(measured, tracks=(tracks[0], tracks[1]))
    said = " ".join(forces_report(pushed, third_law(pushed))["sentences"])
    assert "equal in size" not in said
    assert f"the two sensors are {hand:.0f}" in said or "scatter too much" in said
    assert "equal in size" in " ".join(forces_report(measured, third_law(measured))["sentences"])


def test_noise_alone_is_refused() -> None:
    random, grid = Random(3), tuple(k / 100 for k in range(100))
    tracks = [
        Track(name, grid, tuple(random.gauss(0, 1) for _ in grid), tuple(range(100)))
        for name in "AB"
    ]
    with pytest.raises(FitError):
        third_law(Measured("force", (tracks[0], tracks[1]), ()))


@pytest.mark.parametrize("late", [-40.0, 0.0, 3.7])
def test_two_phones_are_set_by_the_contact_and_their_ratio_is_that_of_the_masses(
    late: float,
) -> None:
    made = Motion(v=(0.6, 0.0), ratio=1.5, touch=1.2, lasts=0.2, until=2.5, push=0.6, brake=0.0)
    texts = [phone(made, 0, seed=1), phone(made, 1, seed=2, clock=late)]
    measured = read_measured(texts)
    found = third_law(measured)
    assert found.set == pytest.approx(late, abs=0.01)
    assert found.ratio == pytest.approx(1 / 1.5, abs=0.03)
    changes = [after - before for before, after in zip(made.v, made.after, strict=True)]
    assert [abs(one) for one in found.impulses] == pytest.approx(
        [abs(one) for one in changes], abs=0.03
    )
    told = forces_report(measured, found)
    assert told["kind"] == "accelerations"
    assert any("do not test that both pushes act at the same time" in s for s in told["sentences"])


def test_two_force_sensors_whose_clocks_do_not_meet_are_set_by_the_contact() -> None:
    one, two = sensors().tracks
    other = Track(two.name, tuple(t + 100.0 for t in two.t), two.value, two.lines)
    found = third_law(Measured("force", (one, other), ()))
    assert found.set == pytest.approx(100.0, abs=0.002)
    assert abs(found.ratio - 1.0) <= 2 * found.ratio_half
    assert third_law(sensors()).set is None
