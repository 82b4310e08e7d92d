"""Segments that a reader sets: what is given counts, and the rest makes room."""

from __future__ import annotations

import itertools
import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.bridge.measured_answer import measured_answer
from sim.cli.measured.fit import command
from sim.measured.events.by_hand import Given
from sim.measured.events.story import Hints, Story, story_of
from sim.measured.events.stretch import KINDS
from sim.measured.tracks import read_measured
from tests.measured.devices import Motion, motion_capture, sensor_carts
from tests.measured.heard import heard

TEXT = motion_capture(Motion())
FOUND = story_of(read_measured([TEXT]))
CELL = 0.01
"""s. Boundaries lie on cells of the grid."""


def story(*given: Given) -> Story:
    return story_of(read_measured([TEXT]), Hints(segments=given))


def spans(found: Story, cart: int) -> list[tuple[str, float, float]]:
    return [(one.kind, one.begin, one.end) for one in found.segments if one.cart == cart]


def test_a_contact_that_is_set_is_taken_and_bounds_both_carts() -> None:
    found = story(Given("contact", 1.40, 1.62))
    assert found.contact
    assert (found.contact.begin, found.contact.end) == pytest.approx((1.40, 1.62), abs=CELL)
    for cart in (0, 1):
        (push,) = [one for one in spans(found, cart) if one[0] == "contact"]
        assert push[1:] == pytest.approx((1.40, 1.62), abs=CELL)
    assert found.outcome == "bounce" and found.speeds and FOUND.speeds
    assert found.speeds.v == pytest.approx(FOUND.speeds.v, abs=0.01)


def test_a_segment_that_is_set_makes_the_others_give_way() -> None:
    found = story(Given("hand", 0.0, 0.7, 0))
    names = spans(found, 0)
    assert names[0][0] == "hand" and names[0][2] == pytest.approx(0.7)
    for (_, _, end), (_, begin, _) in itertools.pairwise(names):
        assert begin == pytest.approx(end, abs=1e-9)
    assert spans(found, 1) == spans(FOUND, 1)
    assert found.speeds and found.speeds.v[0] == pytest.approx(0.15, abs=0.01)


def test_what_is_set_over_a_contact_ends_where_it_begins() -> None:
    found = story(Given("coasting", 0.5, 1.6, 0))
    assert FOUND.contact
    push = [one for one in spans(found, 0) if one[0] == "contact"]
    assert push[0][1] == pytest.approx(FOUND.contact.begin)
    assert any(one[0] == "coasting" and one[1] == pytest.approx(0.5) for one in spans(found, 0))


def test_a_hand_set_by_the_reader_frees_a_fit_that_was_refused_or_wrong() -> None:
    """A cart is held until just before the contact: with all readings its velocity is wrong."""
    made = Motion(v=(0.5, 0.0), ratio=1.6, e=0.9, push=0.6, touch=1.3, lasts=0.2, until=3.0)
    measured = read_measured([sensor_carts(made)])
    found = story_of(measured, Hints(segments=(Given("hand", 0.3, 0.75, 0),)))
    assert found.outcome == "bounce" and found.speeds
    assert found.speeds.v[0] == pytest.approx(0.5, abs=0.03)


def test_a_contact_outside_of_the_readings_is_refused() -> None:
    found = story(Given("contact", 9.0, 9.5))
    assert found.refused and found.refused.code == "outside"


def test_the_page_and_the_command_set_the_same(tmp_path: Path) -> None:
    file = tmp_path / "log.tsv"
    file.write_text(TEXT, encoding="utf-8")
    first = read_measured([TEXT]).names[0]
    options = ["--segment", "contact=1.40..1.62", "--segment", f"{first}:hand=0..0.5"]
    told = json.loads(CliRunner().invoke(command, [str(file), "--json", *options]).output)
    rows = [{"kind": "contact", "from": 1.40, "until": 1.62, "cart": None},
            {"kind": "hand", "from": 0.0, "until": 0.5, "cart": first},
            {"kind": "hand", "from": 0.0, "until": 0.5, "cart": "nobody"}]  # fmt: skip
    asked = {"kind": "measured", "do": "fit", "texts": [TEXT], "compare": True, "segments": rows}
    report = heard(measured_answer(asked)[0])["report"]
    assert report["segments"] == told["segments"]
    assert report["known"] == told["known"]


def test_a_refused_fit_still_shows_what_was_found() -> None:
    rows = [{"kind": "hand", "from": 0.0, "until": 1.45, "cart": None}]
    asked = {"kind": "measured", "do": "fit", "texts": [TEXT], "segments": rows}
    answer = measured_answer(asked)[0]
    assert answer["refused"] and answer["names"] and answer["segments"]


WRONG = ["contact", "contact=2..1", "sleep=1..2", "New 0000:contact=1..2", "C:hand=1..2", "hand=1"]


@pytest.mark.parametrize("option", WRONG)
def test_a_wrong_segment_is_a_wrong_call(option: str, tmp_path: Path) -> None:
    file = tmp_path / "log.tsv"
    file.write_text(TEXT, encoding="utf-8")
    result = CliRunner().invoke(command, [str(file), "--segment", option])
    assert result.exit_code == 2
    assert "--segment" in result.output or any(kind in result.output for kind in KINDS)
