"""What an author of a question writes in a list and YAML reads in another way, and what a page
would show in another way than it was meant: one finding, where it stands, with a way out."""

from __future__ import annotations

from typing import Any

import pytest
import yaml

from sim.lesson.problems import LessonError
from sim.lesson.read import read_question
from sim.scene.problem import Path, Problem

ORDER = "type: ordering\norder:\n- {}\n- both forces grow\n- both forces fade"
CHOICE = "type: {}\noptions:\n- They are equal: always\n- A pushes harder."
PAIRS = "type: matching\npairs:\n- {left: on A, right: by B}\n- "
TABLE = "type: table\ncolumns: [push, v]\nrows: [[0.1 N, {}]]"
CELL = TABLE.format("{answer: 1, tolerance: 0}")
NUMBER = "type: number\nanswer: 0.36 m/s\n"
LINKS = "type: interactions\nobjects: [1, 2, 3]\ncontact: "
LONG = "type: long\nrubric: {1: a, 0: b}\n"


def read(text: str) -> Any:
    return read_question({"id": "q", "ask": "Which?"} | yaml.safe_load(text))


def only(text: str) -> Problem:
    with pytest.raises(LessonError) as caught:
        read(text)
    (problem,) = caught.value.problems
    return problem


@pytest.mark.parametrize(
    ("text", "path"),
    [
        (ORDER.format("A touches B: first"), ("order", 0)),
        (CHOICE.format("single"), ("options", 0)),
        (CHOICE.format("idea"), ("options", 0)),
        (NUMBER + "tolerance: 1 %\nhints:\n- Look again.\n- Note: the sign", ("hints", 1)),
        ("type: short\naccept:\n- zero\n- the force: 0 N", ("accept", 1)),
    ],
)
def test_a_text_that_a_colon_cuts_is_shown_in_quotes_where_it_stands(text: str, path: Path) -> None:
    problem = only(text)
    assert problem.path == path
    shown = problem.hint.removeprefix("a text with a colon in it goes in quotes: ")
    assert f"- {shown[1:-1]}" in text
    assert shown[0] == shown[-1] == '"'


@pytest.mark.parametrize(
    ("text", "path"),
    [
        (ORDER.format("[a, b]"), ("order", 0)),
        (ORDER.format("null"), ("order", 0)),
        (ORDER.format("both forces  grow"), ("order", 1)),
        ("type: single\noptions: [{yes: true}, {no: false}]", ("options", 0)),
        ("type: single\nchoices: [a, b]", ("choices",)),
        (PAIRS + "on B: by A", ("pairs", 1)),
        (PAIRS + "{left: on A, right: by A}", ("pairs", 1, "left")),
        (PAIRS + "{left: on B, right: by B}", ("pairs", 1, "right")),
        (PAIRS + "{left: on B, right: by A}\nothers: by B", ("others",)),
        (PAIRS + "{left: on B, right: by A}\nothers: [by C, by B]", ("others", 1)),
        (TABLE.format("null"), ("rows", 0, 1)),
        (TABLE.format('{answer: 0, "4 m/s": , tolerance: 5 %}'), ("rows", 0, 1, "answer")),
        (CELL + "\nplot: [v, v]", ("plot",)),
        (CELL.replace("[push, v]", ""), ("columns",)),
        (LINKS + "[[1, 4]]", ("contact", 0)),
        (LINKS.replace("3]", "[3]]") + "[[1, 2]]", ("objects", 2)),
        ("type: short\naccept: [zero, null]", ("accept", 1)),
        ("type: null", ("type",)),
        ("type: [single]", ("type",)),
    ],
)
def test_one_slip_is_one_finding_where_it_stands(text: str, path: Path) -> None:
    assert only(text).path == path


@pytest.mark.parametrize(
    ("text", "path"),
    [
        (CELL.replace("v]", r"'\(v\) in m/s']"), ("columns", 1)),
        (CELL.replace("0.1 N", '"**0.1** N"'), ("rows", 0, 0)),
        (LONG + "words: [pair, '![a cart](a.png)']", ("words", 1)),
        (LONG + r"start: The force \(F\) is", ("start",)),
    ],
)
def test_a_formula_that_the_page_would_show_as_it_is_typed_is_told(text: str, path: Path) -> None:
    assert only(text).path == path


def test_signs_that_stand_for_themselves_are_none() -> None:
    made = read(CELL.replace("v]", '"v * [m/s] (mean)"]'))
    assert made.columns == ("push", "v * [m/s] (mean)")


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        (NUMBER + "tolerance: 0.01 kg", "answer: 0.36 kg, or tolerance: 0.01 m/s"),
        (NUMBER.replace(" m/s", "") + "tolerance: 0.01 m/s", "answer: 0.36 m/s"),
        (NUMBER + "tolerance: ± 0.01 m/s", "tolerance: 0.01 m/s"),
        (NUMBER + "tolerance: +/- 2 %", "tolerance: 2 %"),
        (NUMBER.replace("0.36 m/s", "'2026-01-01'"), "write a plain number: answer: 0.8"),
        (NUMBER.replace("0.36 m/s", "1/3"), "write it with decimals: answer: 0.333"),
        (NUMBER.replace("0.36 m/s", "-3/4 N"), "write it with decimals: answer: -0.75 N"),
        (NUMBER.replace("m/s", "ms⁻¹"), "with a space: m s⁻¹"),
        (NUMBER.replace("m/s", "kgms^-2"), "with a space: kg m s^-2"),
        ("type: long\nrubric: {2: both, 1: one}", "add 0: anything else"),
        ("type: essay", "type: long"),
        ("type: Short answer", "type: short"),
        ("type: true/false", "type: single"),
        ("type: confidence\nmarks: 2", "remove marks"),
        ("type: confidence\nhints: [Think.]", "remove hints"),
        ("type: confidence\nsure: true", "remove sure"),
        ("type: idea\nmarks: 2", "remove marks"),
        (NUMBER + "tolerance: 1 %\npoints: 2", "did you mean “marks”?"),
        (NUMBER + "tolerance: 1 %\nunit: m/s", "a unit stands behind its number: answer: 0.25 m/s"),
        (TABLE.format("{value: 0.4 m/s, tolerance: 1 %}"), "did you mean “answer”?"),
    ],
)
def test_what_is_called_otherwise_elsewhere_is_led_here(text: str, hint: str) -> None:
    assert only(text).hint == hint


def test_objects_that_are_numbers_can_be_joined() -> None:
    (link,) = read(LINKS + "[[1, 2]]").links
    assert link.name == "1-2-contact"
