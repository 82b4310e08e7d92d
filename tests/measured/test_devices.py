"""What devices write is read with its troubles named; what happened is found and told."""

from __future__ import annotations

import io
import math
import re
import zipfile
from collections.abc import Callable, Sequence
from random import Random
from typing import Any

import pytest

from sim.measured.analysis import Analysis, Wanted, analysed
from sim.measured.events.story import Hints, story_of
from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured
from sim.measured.units import Units
from sim.measured.zipped import texts_of
from tests.measured.devices import Motion, motion_capture, phone, sensor_carts, tracker_project

FILMED = 2e-4
"""m. Ten standard deviations of the noise that the makers add."""

EXPLOSION = Motion(v=(0.0, 0.0), apart=0.6, ratio=1.5, touch=0.8, until=1.8, brake=0.0)
STICK = Motion(e=0.0, v=(0.2, 0.0))
LOGGED = Motion(v=(0.5, 0.0), ratio=1.6, e=0.9, push=0.6, touch=1.3, lasts=0.2, until=3.0)


def report(text: str, **masses: float) -> dict[str, Any]:
    measured = read_measured([text])
    names = dict(zip("AB", measured.names, strict=True))
    found = analysed(measured, Wanted(masses={names[k]: m for k, m in masses.items()}))
    return found.report


def known(told: dict[str, Any]) -> dict[str, dict[str, Any]]:
    return {one["key"]: one for one in told["known"]}


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


def test_the_mass_ratio_of_a_motion_capture_lies_in_its_interval() -> None:
    inside, halves = 0, []
    runs = 30
    for seed in range(runs):
        made = random_motion(seed)
        told = report(motion_capture(made, seed))
        assert told["outcome"] == "bounce", (seed, told.get("refused"))
        one = known(told)["mass_ratio"]
        inside += one["low"] <= made.ratio <= one["high"]
        halves.append(0.5 * (one["high"] - one["low"]) / one["value"])
        e = known(told)["e"]
        assert 0.0 <= e["low"] < e["high"] <= 1.0
    assert inside >= 0.9 * runs
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
    assert any("joined by the contact" in one for one in story.frames.said)
    e = (story.speeds.v[3] - story.speeds.v[2]) / (story.speeds.v[0] - story.speeds.v[1])
    assert e == pytest.approx(LOGGED.e, abs=0.06)


def test_a_reader_s_signs_and_zeros_are_kept() -> None:
    measured = read_measured([sensor_carts(LOGGED)])
    story = story_of(measured, Hints(flips=("2",), zeros={"2": 0.25, "1": 0.0}))
    assert story.frames is not None
    assert [(axis.sign, axis.zero) for axis in story.frames.axes] == [(1, 0.0), (-1, 0.25)]


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
    sticks = Motion(v=(0.6, 0.0), e=0.0, ratio=1.0, push=0.6, touch=1.3, lasts=0.1, until=2.6)
    places = sticks.places(0, [0.05 * (k + 1) for k in range(28)])
    reach = places[-1] - places[0]  # as far as A is 0.1 s after the touch
    told = report(sensor_carts(sticks, lost=reach))
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


def test_a_tracker_project_holds_places_times_and_scale() -> None:
    made = Motion(v=(0.5, -0.1), until=2.0, touch=1.0)
    found = read_measured([tracker_project(made)])
    assert found.names == ("A", "B")
    times = list(found.tracks[0].t)
    assert times[0] == pytest.approx(0.0)
    for cart, track in enumerate(found.tracks):
        assert track.value == pytest.approx(made.places(cart, times), abs=3e-3)
    told = report(tracker_project(made))
    assert told["outcome"] == "bounce"
    one = known(told)["mass_ratio"]
    assert one["low"] <= made.ratio <= one["high"]


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (("</object>\n", ""), "damaged"),
        (('"delta_t"', '"other"'), "frame to frame"),
        (("800.0", "1.0"), "no length scale"),
        (('type="double">2.0<', 'type="double">two<'), "no number"),
        (("<object class", "<!DOCTYPE a [<!ENTITY b 'c'>]><object class"), "document type"),
        (("PointMass", "Else"), "no point mass"),
    ],
)
def test_a_project_that_says_too_little_is_refused(change: tuple[str, str], reason: str) -> None:
    text = tracker_project(Motion()).replace(*change)
    with pytest.raises(ReadingError) as caught:
        read_measured([text])
    fault = caught.value.faults[0]
    assert reason in fault.reason
    assert 1 <= fault.line <= text.count("\n") + 1


def test_phones_are_read_along_the_way_they_are_pushed_also_from_a_zip() -> None:
    texts = [phone(Motion(), k, seed=k) for k in (0, 1)]
    found = read_measured(texts)
    assert found.kind == "acceleration"
    assert any("(0.6" in note and "0.8" in note for note in found.notes)
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as pack:
        pack.writestr("meta/device.csv", "property,value\n")
        pack.writestr("Raw Data.csv", texts[0])
    assert texts_of(packed.getvalue()) == [texts[0].removeprefix("\ufeff")]
    with pytest.raises(ReadingError, match="damaged"):
        texts_of(packed.getvalue()[:300])


def test_one_phone_is_refused_by_name() -> None:
    with pytest.raises(ReadingError, match="1 phones: two are needed"):
        read_measured([phone(Motion(), 0)])


def test_runs_side_by_side_and_below_each_other_are_told_and_one_is_read() -> None:
    text = sensor_carts(LOGGED).removeprefix("\ufeff")
    lines = text.splitlines()
    below = "\n".join([*lines, *lines[1:]])
    found = read_measured([below])
    assert any("the time starts anew in line" in note for note in found.notes)
    assert len(found.tracks[0].t) == len(lines) - 1
    heads = lines[0].strip('"').split('","')
    both = [",".join(f'"Run {n}: {h}"' for n in (1, 2) for h in heads)]
    both += [f"{line},{line}" for line in lines[1:]]
    found = read_measured(["\n".join(both)])
    assert any("other runs in the file: 2" in note for note in found.notes)
    assert len(found.tracks) == 2


def test_a_lost_cart_leaves_a_gap_that_is_named() -> None:
    lines = sensor_carts(LOGGED).splitlines()
    for k in range(30, 36):
        cells = lines[k].split(",")
        lines[k] = ",".join([cells[0], "", "", "", *cells[4:]])
    found = read_measured(["\n".join(lines)])
    assert any("6 rows without a reading" in note for note in found.notes)
    assert any("no reading from" in note for note in found.notes)


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


def beside(texts: Sequence[str]) -> str:
    """Logs of equal length as runs side by side, as loggers export them."""
    lines = [text.removeprefix("\ufeff").splitlines() for text in texts]
    heads = [",".join(f"{name.strip(chr(34))} Run #{k}" for name in rows[0].split(","))
             for k, rows in enumerate(lines, 1)]  # fmt: skip
    rows = [",".join(parts) for parts in zip(*(one[1:] for one in lines), strict=True)]
    return "\n".join([",".join(heads), *rows]) + "\n"


def below(texts: Sequence[str]) -> str:
    """Logs one under the other: the time starts anew."""
    first, *others = [text.splitlines() for text in texts]
    return "\n".join([*first, *(line for one in others for line in one[1:])]) + "\n"


@pytest.mark.parametrize("together", [beside, below], ids=["side by side", "below each other"])
def test_of_several_runs_the_one_that_is_asked_for_is_read(
    together: Callable[[Sequence[str]], str],
) -> None:
    texts = [sensor_carts(Motion(), seed=k) for k in (1, 2, 3)]
    text = together(texts)
    for k, one in enumerate(texts, 1):
        found, alone = read_measured([text], Units(run=k)), read_measured([one])
        assert found.runs == ("1", "2", "3")
        assert [track.t for track in found.tracks] == [track.t for track in alone.tracks]
        assert [track.value for track in found.tracks] == [t.value for t in alone.tracks]
    assert read_measured([text]).tracks[0].value == read_measured([texts[0]]).tracks[0].value
    with pytest.raises(ReadingError, match="there is no run 4: this file has 3"):
        read_measured([text], Units(run=4))
    assert read_measured([texts[0]]).runs == ()
