"""`carts fit`: from Tracker's text to numbers, a scene and Tracker's text again."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path
from typing import Any

import pytest

from sim.cli.measured.printed import strip
from sim.measured.events.stretch import Segment
from tests.cli.called import carts
from tests.measured.devices import Motion, motion_capture, phone, tracker_project
from tests.measured.force_sensors import sensors
from tests.measured.makers import as_text, film, truth

MADE = truth()


@pytest.fixture
def tracker(tmp_path: Path) -> Path:
    path = tmp_path / "carts.txt"
    path.write_text(as_text(film(MADE)).replace(".", ","), encoding="utf-8")
    return path


def known(*words: object) -> dict[str, dict[str, Any]]:
    result = carts("fit", *words, "--json")
    assert result.exit_code == 0, result.output
    return {one["key"]: one for one in json.loads(result.stdout)["known"]}


def test_a_tracker_file_gives_e_with_its_interval(tracker: Path) -> None:
    found = known(tracker)
    assert found["e"]["low"] <= MADE.e <= found["e"]["high"]
    assert found["mass_ratio"]["low"] <= MADE.ratio <= found["mass_ratio"]["high"]
    said = carts("fit", tracker)
    assert said.exit_code == 0
    assert "bounciness e" in said.stdout
    assert "decimal comma" in said.stdout
    assert "x in m" in said.stdout
    assert "Not printed: mass of each cart in kg; stiffness k in N/m: " in said.stdout


def test_what_one_cause_hides_is_told_together(tmp_path: Path) -> None:
    few = tmp_path / "few.txt"
    few.write_text(as_text(film(MADE, rate=20)), "utf-8")
    untold = json.loads(carts("fit", few, "--json").stdout)["untold"]
    reasons = {one["reason"] for one in untold}
    lines = [line for line in carts("fit", few).stdout.splitlines() if "Not printed" in line]
    assert len(untold) > len(reasons) == len(lines)
    assert all(any(one["name"] in line for line in lines) for one in untold)


def test_a_weighed_cart_gives_k_and_the_other_mass(tracker: Path) -> None:
    found = known(tracker, "--mass", "A=500 g")
    assert found["mass"]["low"] <= 1.0 <= found["mass"]["high"]
    assert "They agree" in carts("fit", tracker, "--mass", "A=500 g", "--mass", "B=1kg").stdout


def test_the_scene_and_the_models_run_are_written(tracker: Path, tmp_path: Path) -> None:
    scene, text = tmp_path / "fitted.yml", tmp_path / "model.txt"
    assert carts("fit", tracker, "--scene", scene, "--tracker", text).exit_code == 0
    assert carts("run", scene).exit_code == 0
    assert known(text)["e"]["value"] == pytest.approx(known(tracker)["e"]["value"], abs=1e-6)


def test_a_file_is_read_from_standard_input(tracker: Path) -> None:
    result = carts("fit", "-", "--json", input=tracker.read_text(encoding="utf-8"))
    assert json.loads(result.stdout)["kind"] == "motion"


def test_two_force_sensors_are_compared(tmp_path: Path) -> None:
    measured = sensors()
    path = tmp_path / "forces.csv"
    rows = zip(measured.tracks[0].t, *(track.value for track in measured.tracks), strict=True)
    lines = ["t (s),F_A (N),F_B (N)", *(",".join(f"{v:.6f}" for v in row) for row in rows)]
    path.write_text("\n".join(lines), encoding="utf-8")
    said = carts("fit", path)
    assert said.exit_code == 0
    assert "equal in size and opposite" in said.stdout
    assert carts("fit", path, "--scene", tmp_path / "no.yml").exit_code == 2


def test_a_bad_line_is_named_and_nothing_is_printed(tracker: Path) -> None:
    text = tracker.read_text(encoding="utf-8").splitlines()
    text[9] = text[8]
    tracker.write_text("\n".join(text), encoding="utf-8")
    result = carts("fit", tracker, "--json")
    assert result.exit_code == 1
    assert result.stdout == ""
    assert f"{tracker}:10:1: error: the time" in result.stderr


def test_of_two_files_the_bad_one_is_named(tracker: Path, tmp_path: Path) -> None:
    bad = tmp_path / "bad.txt"
    bad.write_text("t x\n1 2\n", encoding="utf-8")
    result = carts("fit", tracker, bad)
    assert result.exit_code == 1
    assert f"{bad}:2:1: error:" in result.stderr


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (("--mass", "A"), "write NAME=MASS"),
        (("--mass", "C=1kg"), "there is no cart “C”"),
        (("--mass", "A=-1kg"), "more than 0"),
        (("--mass", "A=1 m"), "not a unit of mass"),
        (("--touch", "wide"), "not a number"),
        (("--from", "2", "--until", "1 s"), "--from 2 is not before --until 1 s"),
        (("--law", "hertz"), "'bumper', 'paper'"),
    ],
)
def test_a_wrong_call_says_how_it_should_look(
    tracker: Path, words: tuple[str, ...], reason: str
) -> None:
    result = carts("fit", tracker, *words)
    assert result.exit_code == 2
    assert reason in result.stderr


def test_a_file_that_is_not_there_is_a_wrong_call() -> None:
    result = carts("fit", "nowhere.txt")
    assert result.exit_code == 2
    assert "There is no file" in result.stderr


def test_a_span_without_enough_readings_is_refused(tracker: Path) -> None:
    result = carts("fit", tracker, "--until", "0.02 s")
    assert result.exit_code == 1
    assert "choose a longer span" in result.stderr


@pytest.fixture
def capture(tmp_path: Path) -> Path:
    path = tmp_path / "capture.tsv"
    path.write_text(motion_capture(Motion(e=0.0, v=(0.2, 0.0))), encoding="utf-8")
    return path


def test_carts_that_stick_are_told_so_with_their_segments(capture: Path) -> None:
    told = json.loads(carts("fit", capture, "--json").stdout)
    assert told["outcome"] == "stick"
    assert told["sensors"]["New 0000"] == {"sign": 1, "zero": 0.0}
    assert {"from", "until", "cart", "kind"} == set(told["segments"][0])
    assert all(one["low"] < one["high"] for one in told["known"])
    assert "refused" not in told
    said = carts("fit", capture).stdout
    assert "The carts stick" in said
    assert "New 0000: coasting 0.00" in said or "New 0000: friction 0.00" in said
    assert carts("fit", capture, "--scene", capture.parent / "no.yml").exit_code == 2


def test_a_refusal_has_a_code_a_sentence_and_what_was_seen(tmp_path: Path) -> None:
    path = tmp_path / "alone.tsv"
    path.write_text(motion_capture(Motion(touch=99.0)), encoding="utf-8")
    result = carts("fit", path, "--json")
    assert result.exit_code == 1
    told = json.loads(result.stdout)
    assert told["outcome"] is None
    assert told["refused"]["code"]
    assert told["refused"]["sentence"] in result.stderr
    assert told["segments"]


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (("--flip", "C"), "there is no cart “C”"),
        (("--zero", "C=1cm"), "there is no cart “C”"),
        (("--zero", "New 0000"), "write NAME=LENGTH"),
        (("--contact", "soon"), "not a number"),
    ],
)
def test_a_wrong_axis_says_how_it_should_look(
    capture: Path, words: tuple[str, ...], reason: str
) -> None:
    result = carts("fit", capture, *words)
    assert result.exit_code == 2
    assert reason in result.stderr


def test_a_zip_and_a_project_are_read_as_they_are(tmp_path: Path) -> None:
    project, packed = tmp_path / "film.trk", tmp_path / "film.trz"
    project.write_text(tracker_project(Motion(v=(0.5, -0.1), touch=1.0, until=2.0)), "utf-8")
    with zipfile.ZipFile(packed, "w") as pack:
        pack.write(project, "film.trk")
    first, second = (carts("fit", path, "--json").stdout for path in (project, packed))
    assert json.loads(first)["outcome"] == "bounce"
    assert first == second


def test_two_phones_are_compared(tmp_path: Path) -> None:
    made = Motion(v=(0.6, 0.0), ratio=1.5, touch=1.2, lasts=0.2, until=2.5)
    paths = [tmp_path / f"{k}.csv" for k in (0, 1)]
    for k, path in enumerate(paths):
        path.write_text(phone(made, k, seed=k, clock=2.0 * k), encoding="utf-8")
    said = carts("fit", *paths).stdout
    assert "Acceleration of phone 2 ÷ acceleration of phone 1: 0.6" in said
    assert "set by the contact itself" in said


def test_times_of_what_happened_have_no_minus_before_nought() -> None:
    segments = tuple(
        Segment(begin, end, 0, "rest", (0.0, 0.0)) for begin, end in ((-1e-17, 0.5), (-1.0, -0.05))
    )
    assert strip(segments, ("A", "B")) == ["A: rest 0.00–0.50 s, rest −1.00 to −0.05 s"]
