"""Two force sensors: what their clocks leave untested, and what their rounding leaves unknown."""

from __future__ import annotations

import math
from dataclasses import replace
from random import Random

import pytest

from sim.measured.events.story import Hints, story_of
from sim.measured.refusal import FitError
from sim.measured.report import forces_report
from sim.measured.third_law import third_law
from sim.measured.tracks import Measured, read_measured
from tests.measured.device_reports import LOGGED
from tests.measured.devices import sensor_carts
from tests.measured.force_sensors import sensors

STEP = 0.1  # N
EVEN = STEP / math.sqrt(12.0)


def told(measured: Measured) -> str:
    return " ".join(forces_report(measured, third_law(measured))["sentences"])


@pytest.mark.parametrize(("late", "cart"), [(0.015, "B"), (-0.015, "A")])
def test_curves_that_were_moved_onto_each_other_are_not_called_equal_at_every_instant(
    late: float, cart: str
) -> None:
    said = told(sensors(late=late))
    assert "At every instant" not in said
    assert f"Once the readings of {cart} are moved to be 1" in said
    assert "Whether both act at the same time is then not tested by these readings." in said
    assert "At every instant the two forces are equal" in told(sensors())


def file(centre: float, sign: float, seed: int, *, until: float = 3.0, name: str = "F") -> str:
    dice = Random(seed)
    rows = []
    for k in range(round(until * 200)):
        t = k / 200
        force = sign * 6.0 * math.exp(-(((t - centre) / 0.03) ** 2)) + dice.gauss(0.0, 0.02)
        rows.append(f"{t:.3f},{force:.4f}")
    return "\n".join([f"Time (s),{name} (N)", *rows])


@pytest.mark.parametrize("second", [1.9, 0.4, 1.05])
def test_two_files_that_each_begin_at_zero_are_set_by_the_push(second: float) -> None:
    measured = read_measured([file(0.8, -1.0, 1), file(second, 1.0, 2)])
    found = third_law(measured)
    assert found.set == pytest.approx(second - 0.8, abs=0.002)
    assert abs(found.ratio - 1.0) <= 2 * found.ratio_half
    said = told(measured)
    assert "The second clock is set by the contact itself" in said
    assert "At every instant" not in said and "not tested by these readings" in said


def test_one_file_and_two_files_with_one_clock_are_not_moved() -> None:
    both = read_measured([file(0.8, -1.0, 1), file(0.8, 1.0, 2)])
    assert both.two_files and third_law(both).set is None
    assert "At every instant" in told(both)
    late = sensors().tracks[1]
    late = replace(late, value=late.value[200:] + late.value[:200])
    measured = replace(sensors(), tracks=(sensors().tracks[0], late))
    assert third_law(measured).set is None and "scatter too much" in told(measured)


def test_two_files_without_a_push_are_refused_by_what_they_lack() -> None:
    with pytest.raises(FitError, match="shows no push"):
        third_law(read_measured([file(9.0, 1.0, 1), file(9.0, 1.0, 2)]))


def rounded(seed: int, noise: float = 0.005) -> Measured:
    """Sensors that tell tenths of a newton, their zeros anywhere between two of them."""
    dice = Random(seed)
    zeros = dice.uniform(-0.05, 0.05), dice.uniform(-0.05, 0.05)
    made = sensors(noise=noise, zeros=zeros, seed=seed)
    tracks = [replace(one, value=tuple(STEP * round(v / STEP) for v in one.value))
              for one in made.tracks]  # fmt: skip
    return replace(made, tracks=(tracks[0], tracks[1]))


def test_rounded_forces_are_no_surer_than_their_steps() -> None:
    found = third_law(rounded(3))
    assert min(found.noise) >= 0.99 * EVEN
    assert found.ratio_half > 1e-3
    assert min(found.impulse_sd) > EVEN * 0.05  # a pulse of some 0.15 s, its zero unknown
    said = told(rounded(3))
    assert "± 0.000000" not in said and "1.000000" not in said


def test_intervals_of_rounded_forces_hold_the_truth_as_often_as_promised() -> None:
    found = [third_law(rounded(seed)) for seed in range(60)]
    truth = 0.54  # N s, as in test_third_law
    assert sum(abs(one.ratio - 1.0) <= one.ratio_half for one in found) >= 55
    near = [abs(abs(value) - truth) <= 2.0 * sd
            for one in found for value, sd in zip(one.impulses, one.impulse_sd, strict=True)
            ]  # fmt: skip
    assert sum(near) >= 0.9 * len(near)


@pytest.mark.parametrize(("distance", "words"), [
    (None, "the marks are taken to be 0 m apart (give the distance)"),
    (0.0, "the marks are 0 m apart"), (0.25, "the marks are 0.25 m apart"),
])  # fmt: skip
def test_a_distance_of_the_marks_that_nobody_gave_is_called_taken(
    distance: float | None, words: str
) -> None:
    story = story_of(read_measured([sensor_carts(LOGGED)]), Hints(distance=distance))
    assert story.frames is not None
    assert words in " ".join(story.frames.sentences)
