"""Readings are fitted with what they call for; a fit without it says so above its numbers."""

from __future__ import annotations

from typing import Any

import pytest

from sim.bridge.measured_answer import measured_answer
from sim.measured.analysis import Wanted, analysed
from sim.measured.tracks import read_measured
from tests.measured.heard import heard
from tests.measured.makers import as_text, film, truth

MU = 0.01
BRAKED = as_text(film(truth(
    v=(0.5, 0.0), gap=0.6, after=1.5, effects=({"friction": {"coefficient": MU}},),
), rate=60))  # fmt: skip
FREE = as_text(film(truth(), rate=60))


def asked(text: str, **more: Any) -> dict[str, Any]:
    header, _ = measured_answer({"do": "fit", "texts": [text], **more})
    assert "refused" not in header, header
    made: dict[str, Any] = heard(header)
    return made


def known(report: dict[str, Any], key: str) -> dict[str, Any]:
    return next(one for one in report["known"] if one["key"] == key)


@pytest.fixture(scope="module")
def own() -> dict[str, Any]:
    """The page's answer to a reader who brought the film and chose nothing."""
    return asked(BRAKED, effect="called", own=True)


def test_the_page_prints_of_own_carts_what_the_command_prints(own: dict[str, Any]) -> None:
    command = analysed(read_measured([BRAKED]), Wanted()).report
    assert own["report"]["known"] == command["known"]
    assert own["report"]["sentences"] == command["sentences"]
    assert own["report"]["added"] == command["added"]
    e = known(command, "e")
    assert e["low"] <= 0.8 <= e["high"] and e["high"] - e["low"] < 0.05


def test_what_was_added_stands_above_the_numbers(own: dict[str, Any]) -> None:
    assert own["report"]["added"].startswith("Friction on each cart was added")
    assert own["report"]["doubt"] == ""
    free = asked(FREE, effect="called", own=True)["report"]
    assert free["added"].startswith("Nothing was added")
    assert free["effect"] == "none"


@pytest.mark.parametrize("effect", ["none", "tilt"])
def test_without_what_own_readings_call_for_the_numbers_are_doubted_by_name(effect: str) -> None:
    report = asked(BRAKED, effect=effect, own=True)["report"]
    assert not known(report, "e")["low"] <= 0.8 <= known(report, "e")["high"]
    assert report["doubt"].startswith("These readings call for friction on each cart")
    assert report["added"] == ""


def test_of_a_lessons_readings_the_effect_is_named_on_request_only() -> None:
    report = asked(BRAKED)["report"]
    assert report["effect"] == "none" and report["calls_for"] is None
    assert "does not fit these readings" in report["doubt"]
    said = " ".join([report["doubt"], report["added"]])
    assert "riction" not in said and "tilt" not in said
    assert "call for" not in " ".join([said, *report["sentences"]])
    assert "call for friction" in asked(BRAKED, compare=True)["report"]["doubt"]


@pytest.mark.parametrize("effect", ["none", "friction"])
def test_readings_that_call_for_nothing_are_not_doubted(effect: str) -> None:
    assert asked(FREE, effect=effect)["report"]["doubt"] == ""


def test_friction_is_told_as_a_coefficient_too(own: dict[str, Any]) -> None:
    for cart in "ab":
        mu, brake = (known(own["report"], f"{key}_{cart}") for key in ("mu", "friction"))
        assert mu["low"] <= MU <= mu["high"] and mu["unit"] == ""
        assert mu["high"] * 9.81 == pytest.approx(brake["high"])
        assert "coefficient of friction" in mu["name"]


def test_the_picture_and_the_comparison_tell_residuals_in_one_measure(own: dict[str, Any]) -> None:
    row = next(one for one in own["report"]["compared"] if one["effect"] == "friction")
    assert own["spread"] == row["rms"]
    assert f"with friction on each cart: {1e3 * own['spread']:.2f} mm" in " ".join(
        own["report"]["sentences"]
    )
    assert own["counted"] <= sum(map(len, own["residuals"]))
