"""Scenes that can be run and that nobody meant: `carts check` warns, or gives a hint."""

from __future__ import annotations

import pytest

from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.checks.lessons import check_lesson
from sim.pages.checks.off_track import off_track
from sim.scene import read_scene

ARROWS = """# A lesson

```scene
id: arrows
carts:
  A: {mass: 0.5 kg, position: 0.40 m, velocity: %s}
  B: {mass: 1 kg, position: 1.2 m}
track: {length: 2.4 m}
until: %s
%s
```
"""


@pytest.mark.parametrize(
    ("velocity", "until", "more", "warned"),
    [
        ("0.6 m/s", "3 s", "predict: {arrows: [A-B]}", ""),
        ("0.6 m/s", "0.5 s", "predict: {arrows: [A-B]}", "A and B never push each other"),
        ("-0.1 m/s", "3 s", "predict: {arrows: [A-B]}", "A and B never push each other"),
        ("0.6 m/s", "0.5 s", "predict: {curve: F.B}", "nothing touches B"),
        ("0.6 m/s", "0.5 s", "predict: {curve: v.B}", ""),
        (
            "0",
            "0.5 s",
            "effects: [{magnets: {between: [A, B], strength: 1e-4}}]\npredict: {arrows: [A-B]}",
            "",
        ),
    ],
)
def test_forces_to_predict_that_never_act_are_a_warning(
    velocity: str, until: str, more: str, warned: str
) -> None:
    found = check_lesson(ARROWS % (velocity, until, more), Lesson("a.md", (), ()), SiteIds())
    told = [(f.code, f.severity, warned in f.message) for f in found]
    assert told == ([("no-force-to-predict", "warning", True)] if warned else []), found


@pytest.mark.parametrize(
    ("position", "off"), [(0, False), (-1e-9, True), (2, False), (2 + 1e-9, True), (1, False)]
)
def test_a_cart_may_begin_at_either_end_of_its_track_and_not_beyond(
    position: float, off: bool
) -> None:
    carts = {"A": {"mass": 1, "position": position}}
    found = off_track(read_scene({"carts": carts, "track": {"length": 2}, "until": 1}))
    assert [one.code for one in found] == ["off-track"] * off
    assert off_track(read_scene({"carts": carts, "until": 1})) == []


@pytest.mark.parametrize(
    ("velocity", "length", "hinted"),
    [
        ("0.6", "2.4", []),
        ("60 m/s", "240 m", []),
        ("60", "2.4 m", ["velocity: 60 cm/s"]),
        ("-60", "240", ["velocity: -60 cm/s", "length: 240 cm"]),
    ],
)
def test_a_plain_number_that_was_meant_in_cm_is_a_hint(
    velocity: str, length: str, hinted: list[str]
) -> None:
    text = ARROWS.replace("2.4 m", length) % (velocity, "3 s", "")
    found = check_lesson(text, Lesson("a.md", (), ()), SiteIds(), hints=True)
    told = [finding for finding in found if finding.code == "large-number"]
    assert {finding.severity for finding in told} <= {"hint"}
    assert [w for w in hinted if any(f"write {w};" in f.message for f in told)] == hinted
    assert len(told) == len(hinted)


@pytest.mark.parametrize(
    "more",
    [
        "with: [free-body]",
        "with: [lens]\nforces: hidden\nshow: [x]",
        "with: [bars]\ncontact: {law: velcro}",
        "with: [lens]\ncontact: {law: instant}\n"
        "effects: [{magnets: {between: [A, B], strength: 1e-4, active: false}}]",
    ],
)
def test_a_view_of_forces_that_are_there_or_may_be_is_no_mistake(more: str) -> None:
    assert check_lesson(ARROWS % ("0.6 m/s", "3 s", more), Lesson("a.md", (), ()), SiteIds()) == []
