"""The model set by hand, what the page is answered, and the lesson's own readings."""

from __future__ import annotations

import json
import math
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import yaml

from sim.bridge.protocol import answer
from sim.measured import lesson_set
from sim.measured.model.fit import fit
from sim.measured.model.motion import Motion
from sim.measured.overlay import by_hand, first_try, frequency, overlay
from sim.scene import read_scene
from tests.measured.force_sensors import sensors
from tests.measured.heard import heard
from tests.measured.makers import as_text, film, truth

MADE = truth()
TEXT = as_text(film(MADE))
WORKSHEETS = Path(__file__).parents[2] / "worksheets"


def asked(do: str, **more: Any) -> dict[str, Any]:
    request = {"id": 3, "kind": "measured", "do": do, "texts": [TEXT], **more}
    header, numbers = answer(json.loads(json.dumps(request)))
    assert header["ok"]
    assert not numbers
    json.dumps(header, allow_nan=False)
    made: dict[str, Any] = heard(header)
    return made


@pytest.mark.parametrize("law", ["bumper", "paper"])
def test_a_contact_set_by_its_length_lasts_that_long(law: Any) -> None:
    made = first_try(film(MADE), law)
    for duration, e in ((0.05, 0.3), (0.2, 0.9)):
        p = type(made)(
            touch=0.4, x=0.8, distance=0.2, v=(0.8, 0.0), ratio=2.0, e=e,
            w0=frequency(law, e, duration),
        )  # fmt: skip
        assert Motion(p, law).duration == pytest.approx(duration, rel=1e-9)


def test_by_hand_the_lines_lie_on_the_points_before_the_touch() -> None:
    measured = film(MADE)
    made = by_hand(measured, first_try(measured, "bumper"), "bumper")
    for track, residuals in zip(measured.tracks, made.residuals, strict=True):
        before = [r for t, r in zip(track.t, residuals, strict=True) if t < made.parameters.touch]
        assert abs(sum(before) / len(before)) < 1e-12
    assert made.spread > 0.01  # and after it they do not: that is for the student


def test_the_fitted_model_laid_over_leaves_the_residuals_of_the_fit() -> None:
    measured = film(MADE)
    found = fit(measured)
    made = overlay(measured, found.parameters, "bumper")
    for ours, theirs in zip(made.residuals, found.residuals, strict=True):
        assert ours == pytest.approx(theirs, abs=1e-12)
    inside = [t for t in made.t if 0 <= t - found.parameters.touch <= found.duration]
    assert len(inside) >= 40


def test_numbers_beyond_all_sense_are_refused_in_words() -> None:
    hand = asked("read")["parameters"]
    answers = [
        asked("model", hand=hand | {"touch": 1e308}),
        asked("model", hand=hand | {"v": [1e200, 0.0]}),
        asked("fit", masses={"A": 1e-300, "B": 1e300}),
    ]
    for one in answers:
        assert "cannot be computed" in one["refused"][0]["reason"]


def test_the_page_reads_sets_and_fits() -> None:
    read = asked("read")
    assert read["kind"] == "length"
    assert [len(track["t"]) for track in read["tracks"]] == [len(film(MADE).tracks[0].t)] * 2
    hand = read["parameters"] | {"e": MADE.e, "ratio": MADE.ratio, "duration": MADE.contact}
    better = asked("model", hand=hand)
    assert better["spread"] < read["spread"]
    found = asked("fit", effect="none", compare=True, masses={"A": 0.5})
    known = {one["key"]: one for one in found["report"]["known"]}
    assert known["e"]["low"] <= MADE.e <= known["e"]["high"]
    assert {"k", "mass"} <= set(known)
    assert found["report"]["calls_for"] == "none"
    assert found["spread"] < 1.2e-3
    assert asked("tracker")["text"].startswith("#multi:")


def test_the_page_is_told_lines_and_reasons() -> None:
    (fault,) = asked("read", texts=[TEXT.replace("E-1", "E-x", 1)])["refused"]
    assert fault["line"] == 4
    assert "not a number" in fault["reason"]
    (fault,) = asked("fit", **{"from": 0.0, "until": 0.3})["refused"]
    assert fault["line"] is None


def test_the_page_compares_two_sensors_without_a_fit() -> None:
    measured = sensors()
    rows = zip(measured.tracks[0].t, *(track.value for track in measured.tracks), strict=True)
    text = "t;F_A;F_B\n" + "\n".join(";".join(f"{v:.5f}" for v in row) for row in rows)
    read = asked("read", texts=[text])
    assert read["kind"] == "force"
    assert abs(read["report"]["ratio"] - 1.0) <= read["report"]["ratio_half"]
    assert asked("fit", texts=[text])["refused"]


def test_the_lessons_readings_are_those_that_the_truth_makes() -> None:
    for name, text in (
        (lesson_set.FILM, lesson_set.film()),
        (lesson_set.FORCES, lesson_set.forces()),
    ):
        kept = (WORKSHEETS / "data" / name).read_text(encoding="utf-8")
        # The last digits may differ between the mathematics libraries of two systems.
        assert len(kept) == pytest.approx(len(text), abs=20)
        first, second = (t.replace(";", "\t").split() for t in (kept, text))
        for a, b in zip(first, second, strict=True):
            if a != b:
                assert float(a) == pytest.approx(float(b), abs=2e-3)


def test_the_lesson_says_what_its_readings_say() -> None:
    from sim.measured.model.effects import rms_residual
    from sim.measured.model.fit import Asked
    from sim.measured.tracks import read_measured

    text = (WORKSHEETS / "real-carts.md").read_text(encoding="utf-8")
    measured = read_measured([lesson_set.film()])
    plain, braked = fit(measured), fit(measured, Asked(effect="friction"))
    for found, e, half in ((plain, "0.741", "0.017"), (braked, "0.839", "0.011")):
        assert f"{found.parameters.e:.3f}" == e
        assert f"{found.factor * found.sd('e'):.3f}" == half
        assert f"{e} ± {half}" in text
    assert f"{1e3 * rms_residual(plain):.2f} mm" in text
    assert f"{1e3 * rms_residual(braked):.2f} mm" in text
    assert f"{plain.parameters.ratio:.2f}" in text
    truth_e = float(lesson_set.TRUTH["contact"]["restitution"])
    assert abs(braked.parameters.e - truth_e) <= braked.factor * braked.sd("e")
    assert abs(plain.parameters.e - truth_e) > 5 * plain.factor * plain.sd("e")
    assert math.isclose(braked.parameters.friction[0], 0.058, abs_tol=0.001)


def test_the_sensors_read_the_bump_that_the_lesson_shows() -> None:
    """The lesson says “here is such a bump” and opens the readings when it was watched."""
    text = (WORKSHEETS / "real-carts.md").read_text(encoding="utf-8")
    shown = re.search(r"```scene\n(id: real-forces-bump\n.*?)```", text, re.S)
    assert shown
    drawn = {"id", "title", "show", "forces", "predict"}
    scene = {key: value for key, value in yaml.safe_load(shown[1]).items() if key not in drawn}
    assert read_scene(scene) == read_scene(lesson_set.BUMP)


def test_readings_that_a_program_made_are_called_evidence_of_no_law() -> None:
    """A model that has the third law built in agrees with itself: no finding."""
    masses = {"A": 0.5, "B": 1.0}
    forces = (WORKSHEETS / "data" / "real-carts-forces.csv").read_text("utf-8")
    for synthetic in (False, True):
        told = asked("fit", masses=masses, synthetic=synthetic)["report"]["sentences"]
        pair = asked("read", texts=[forces], synthetic=synthetic)["report"]["sentences"]
        film_said, forces_said = " ".join(told), " ".join(pair)
        assert ("was told the third law" in film_said) == synthetic
        assert ("was told the third law" in forces_said) == synthetic
        assert ("your carts have confirmed it" in film_said) != synthetic
        assert ("changed the other's motion as Newton's third law says" in film_said) != synthetic
        assert ("read off the readings alone" in forces_said) != synthetic


def test_where_a_reader_starts_by_hand_is_found_in_time_that_grows_with_the_readings() -> None:
    """The readings that are looked at, counted: four times as many of them for four times as many,
    and not sixteen times."""
    looks = []
    for rate in (100.0, 400.0):
        measured = film(MADE, rate=rate)
        tracks = [replace(one, t=Counted(one.t)) for one in measured.tracks]
        first_try(replace(measured, tracks=(tracks[0], tracks[1])), "bumper")
        looks.append(sum(one.t.looks for one in tracks))
    assert looks[1] < 6 * looks[0]


class Counted(tuple[float, ...]):
    """Times that count how often one of them is looked up."""

    looks = 0

    def __getitem__(self, k: Any) -> Any:
        self.looks += 1
        return super().__getitem__(k)
