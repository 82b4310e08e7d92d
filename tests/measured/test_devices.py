"""What devices write is read with its troubles named; what happened is found and told."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from random import Random
from typing import Any

import pytest

from sim.measured.analysis import Analysis, analysed
from sim.measured.events.story import Hints, story_of
from sim.measured.same_ratio import same_ratio
from sim.measured.tracks import read_measured
from tests.measured.device_reports import LOGGED, known, lost_at_the_touch, report
from tests.measured.devices import Motion, motion_capture, sensor_carts, tracker_project

FILMED = 2e-4
"""m. Ten standard deviations of the noise that the makers add."""

EXPLOSION = Motion(v=(0.0, 0.0), apart=0.6, ratio=1.5, touch=0.8, until=1.8, brake=0.0)
STICK = Motion(e=0.0, v=(0.2, 0.0))


def random_motion(seed: int) -> Motion:
    r = Random(seed)
    return Motion(
        v=(r.uniform(0.1, 0.4), r.choice([0.0, -r.uniform(0.02, 0.1)])),
        ratio=r.uniform(0.6, 2.0),
        e=r.uniform(0.25, 0.95),
        lasts=r.uniform(0.06, 0.15),
        brake=r.uniform(0.0, 0.02),
    )


def test_a_track_that_lies_askew_in_the_room_is_found_by_its_motion() -> None:
    made = Motion()
    found = read_measured([motion_capture(made)])
    assert any("(0.800, 0.600, " in note for note in found.notes)
    times = list(found.tracks[0].t)
    for cart, track in enumerate(found.tracks):
        wanted = made.places(cart, times)
        shift = wanted[0] - track.value[0]
        assert track.value == pytest.approx([x - shift for x in wanted], abs=FILMED)


def test_hidden_frames_and_markers_that_change_names_are_mended_and_named() -> None:
    plain = read_measured([motion_capture(Motion())])
    text = motion_capture(Motion(), hidden=(40, 41, 42), swapped=600)
    found = read_measured([text])
    assert any("3 of 750 frames hidden" in note for note in found.notes)
    assert any("change their names 1 times" in note for note in found.notes)
    assert [len(track.t) for track in found.tracks] == [747, 750]
    assert found.tracks[1].value == pytest.approx(plain.tracks[1].value, abs=1e-5)


def test_frames_in_which_no_marker_is_seen_take_their_time_too() -> None:
    """Their lines are empty; left out without it, carts ran 3 % too fast where 3 % are missing."""
    whole = read_measured([motion_capture(Motion())])
    text = motion_capture(Motion(), empty=(40, 41, 300, 500, 501, 502))
    for gone in (text, text.replace("\t\t\t\t\t", "")):  # an editor takes spaces at the ends away
        found = read_measured([gone])
        for track, same in zip(found.tracks, whole.tracks, strict=True):
            assert len(same.t) - len(track.t) == 6
            assert track.t[-1] == same.t[-1]
            assert set(track.t) < set(same.t)
    spread = read_measured([text.replace("\n", "\n\n")])
    assert spread.tracks[0].t[-1] < whole.tracks[0].t[-1]  # more lines than frames: not counted


def test_the_mass_ratio_of_a_motion_capture_lies_in_its_interval(
    request: pytest.FixtureRequest,
) -> None:
    inside, halves = 0, []
    runs = 30 if request.config.getoption("--fuzz") else 15
    for seed in range(runs):
        made = random_motion(seed)
        told = report(motion_capture(made, seed))
        assert told["outcome"] == "bounce", (seed, told.get("refused"))
        one = known(told)["mass_ratio"]
        inside += one["low"] <= made.ratio <= one["high"]
        halves.append(0.5 * (one["high"] - one["low"]) / one["value"])
        e = known(told)["e"]
        assert 0.0 <= e["low"] < e["high"] <= 1.0
    assert inside >= math.floor(0.9 * runs)
    assert sorted(halves)[runs // 2] < 0.04


def test_residuals_that_are_alike_do_not_make_an_interval_narrow() -> None:
    told = report(motion_capture(Motion()))
    one = known(told)["mass_ratio"]
    assert 0.5 * (one["high"] - one["low"]) / one["value"] > 0.01
    reasons = {one["key"]: one["reason"] for one in told["untold"]}
    assert "not random" in reasons["w0"]


@pytest.mark.parametrize("seed", range(4))
def test_carts_that_stick_have_a_common_velocity_and_no_bounciness(seed: int) -> None:
    told = report(motion_capture(STICK, seed))
    assert told["outcome"] == "stick"
    found = known(told)
    assert "e" not in found
    half = found["v_common"]["high"] - found["v_common"]["value"]
    during = STICK.brake * 0.5 * STICK.lasts  # the instant is known to half of the contact
    assert found["v_common"]["value"] == pytest.approx(STICK.after[0], abs=half + during)
    lost = 0.5 * (STICK.v[0] - STICK.v[1]) ** 2
    assert found["energy_lost"]["low"] <= lost <= found["energy_lost"]["high"]


@pytest.mark.parametrize("seed", range(4))
def test_an_explosion_releases_energy_and_has_no_bounciness(seed: int) -> None:
    told = report(sensor_carts(EXPLOSION, seed, stop=1.4))
    assert told["outcome"] == "explosion"
    found = known(told)
    assert "e" not in found
    assert found["mass_ratio"]["low"] <= 1.5 <= found["mass_ratio"]["high"]
    assert found["energy_released"]["value"] == pytest.approx(0.5 * 0.6**2, rel=0.05)
    assert told["sensors"]["1"] == {"sign": 1, "zero": 0.0}
    assert told["sensors"]["2"]["sign"] == -1


def test_two_sensors_are_joined_by_the_contact_and_it_is_said() -> None:
    measured = read_measured([sensor_carts(LOGGED)])
    story = story_of(measured, Hints(distance=0.1))
    assert story.outcome == "bounce"
    assert story.frames is not None and story.frames.joined and story.speeds
    left, right = story.measured.tracks
    near = min(b - a for a, b in zip(left.value, right.value, strict=True))
    assert near == pytest.approx(0.1, abs=0.02)  # pressed in a little
    assert any("joined by the contact" in one for one in story.frames.sentences)
    e = (story.speeds.v[3] - story.speeds.v[2]) / (story.speeds.v[0] - story.speeds.v[1])
    assert e == pytest.approx(LOGGED.e, abs=0.06)


def test_two_sensors_with_two_scales_are_not_read_by_the_model_however_well_it_fits() -> None:
    found = analysed(read_measured([sensor_carts(LOGGED)]))
    assert found.fit and found.story.frames and found.story.frames.joined
    perfect = replace(found.fit, noise=0.0)
    assert not same_ratio(found.story, perfect, None)
    one_scale = replace(found.story, frames=replace(found.story.frames, joined=False))
    assert same_ratio(one_scale, perfect, None)


def test_a_reader_s_signs_and_zeros_are_kept() -> None:
    measured = read_measured([sensor_carts(LOGGED)])
    story = story_of(measured, Hints(flips=("2",), zeros={"2": 0.25, "1": 0.0}))
    assert story.frames is not None
    assert [(axis.sign, axis.zero) for axis in story.frames.axes] == [(1, 0.0), (-1, 0.25)]


@pytest.mark.parametrize("given", [{"1": 0.1}, {"2": -0.3}, {"1": 0.1, "2": -0.3}, {}])
@pytest.mark.parametrize("distance", [0.0, 0.25])
def test_marks_are_as_far_apart_in_the_contact_as_is_said(
    given: dict[str, float], distance: float
) -> None:
    """One zero is the reader's: the other follows. Both are: they tell the distance."""
    story = story_of(read_measured([sensor_carts(LOGGED)]), Hints(zeros=given, distance=distance))
    assert story.frames is not None and story.speeds
    for axis, name in zip(story.frames.axes, ("1", "2"), strict=True):
        assert axis.zero == given.get(name, axis.zero)
    (told,) = re.findall(r"the marks are (\S+) m apart", " ".join(story.frames.sentences))
    places = story.speeds.places
    assert 0.5 * (places[1] + places[3] - places[0] - places[2]) == pytest.approx(
        float(told), abs=1e-3
    )
    if len(given) < 2:
        assert float(told) == distance


def test_hands_coasting_and_stops_are_told_apart() -> None:
    told = report(sensor_carts(LOGGED, stop=2.0))
    kinds = [(s["cart"], s["kind"]) for s in told["segments"]]
    a = [kind for cart, kind in kinds if cart == "1"]
    assert a.index("hand") < a.index("contact")
    assert kinds[-1] == ("2", "rest")
    assert ("2", "hand") not in kinds
    begin, end = next((s["from"], s["until"]) for s in told["segments"] if s["kind"] == "contact")
    assert begin < LOGGED.touch < end < LOGGED.touch + 0.35


def test_a_sensor_that_loses_its_cart_is_named() -> None:
    told = report(lost_at_the_touch(1.0, after=0.1))
    assert told["refused"]["code"] in ("lost-after", "perhaps-lost", "not-in-step")
    assert "sensor" in told["refused"]["sentence"]
    assert told["known"] == []


def test_momentum_of_weighed_carts_agrees_and_that_of_wrong_masses_does_not() -> None:
    told = report(motion_capture(Motion()), A=0.2, B=0.26)
    p = told["momentum"]
    assert p["before"] == pytest.approx(0.2 * 0.15 - 0.26 * 0.02, abs=2 * p["before_half"] + 1e-4)
    assert p["agree"]
    assert any("They agree" in one for one in told["sentences"])
    wrong = report(motion_capture(Motion()), A=0.2, B=0.35)
    assert not wrong["momentum"]["agree"]


def every_number(told: Any) -> list[float]:
    if isinstance(told, dict):
        return [x for value in told.values() for x in every_number(value)]
    if isinstance(told, list):
        return [x for value in told for x in every_number(value)]
    return [told] if isinstance(told, float) else []


IMPOSSIBLE = re.compile(r"\binf\b|\bnan\b|± 0(\.0*)?(?!\.?\d)")


@pytest.mark.parametrize("seed", range(12))
def test_no_impossible_number_is_ever_told(seed: int) -> None:
    r = Random(seed)
    made = Motion(
        v=(r.choice([0.05, 0.3, 0.8]), r.choice([0.0, -0.3, 0.04])),
        e=r.choice([0.0, 0.03, 0.3, 1.0, 1.2]),
        ratio=r.choice([0.05, 1.0, 8.0]),
        lasts=r.choice([0.02, 0.1, 0.5]),
        brake=r.choice([0.0, 0.05]),
    )
    for text in (motion_capture(made, seed), sensor_carts(made, seed), tracker_project(made, seed)):
        told = report(text)
        assert all(map(math.isfinite, every_number(told)))
        for one in told["known"]:
            assert one["low"] < one["high"]
            assert not IMPOSSIBLE.search(one["text"]), one["text"]
            if one["key"] == "e":
                assert 0.0 <= one["low"] < one["high"] <= 1.0
        assert bool(told.get("refused")) == (told["outcome"] is None)


def test_readings_without_a_contact_are_refused_with_a_code() -> None:
    made = Motion(touch=99.0)
    found: Analysis = analysed(read_measured([motion_capture(made)]))
    assert found.refused is not None
    assert found.report["refused"]["code"] in ("no-contact", "no-change", "no-approach")
    assert found.report["refused"]["sentence"]
