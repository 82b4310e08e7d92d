"""A number whose unit does not fit the others of its question is told at the number itself."""

from __future__ import annotations

from typing import Any

import pytest

from sim.lesson.problems import LessonError
from sim.lesson.read import read_question

FORCE: dict[str, Any] = {
    "id": "force",
    "type": "number",
    "ask": "How large?",
    "answer": "0 N",
    "tolerance": "0 N",
    "wrong": [{"value": "0.40 N", "feedback": "That is its velocity."}],
}


@pytest.mark.parametrize(
    ("answer", "given"), [("5 kg", "in kg"), ("0", "a plain number"), (3, "a plain number")]
)
def test_an_answer_in_another_unit_than_all_others_is_the_mistake(
    answer: object, given: str
) -> None:
    with pytest.raises(LessonError) as caught:
        read_question({**FORCE, "answer": answer})
    (problem,) = caught.value.problems
    assert problem.path[-1] == "answer"
    assert f"the answer is {given}" in str(problem.message)
    assert "in N" in str(problem.message)


def test_one_wrong_answer_in_another_unit_is_the_mistake_itself() -> None:
    with pytest.raises(LessonError) as caught:
        read_question({**FORCE, "wrong": [*FORCE["wrong"], {"value": "0.4 m/s"}]})
    assert [problem.path[-1] for problem in caught.value.problems] == ["value"]


def test_numbers_that_do_not_agree_among_themselves_are_told_one_by_one() -> None:
    with pytest.raises(LessonError) as caught:
        read_question({**FORCE, "answer": "5 kg", "tolerance": 0.1})
    assert [problem.path[-1] for problem in caught.value.problems] == ["value"]


@pytest.mark.parametrize(
    ("answer", "tolerance", "meant"),
    [(50, "5 %", 2.5), ("2.5", "10 %", 0.25), ("2 N", "10 %", 0.2), ("50 %", "2 %", 2.0)],
)
def test_a_tolerance_in_percent_is_of_the_answer_unless_that_is_in_percent_itself(
    answer: object, tolerance: str, meant: float
) -> None:
    plain = {"id": "q", "type": "number", "ask": "How large?"}
    facts = read_question({**plain, "answer": answer, "tolerance": tolerance}).data(key=True)
    assert facts["key"]["tolerance"] == pytest.approx(meant)


def test_a_tolerance_without_a_unit_beside_an_answer_in_cm_per_second_is_refused() -> None:
    plain = {"id": "q", "type": "number", "ask": "How fast?", "tolerance": "1"}
    with pytest.raises(LessonError) as caught:
        read_question({**plain, "answer": "50 cm/s"})
    assert [problem.path[-1] for problem in caught.value.problems] == ["tolerance"]
    assert read_question({**plain, "answer": "50 m/s"}).data(key=True)["key"]["tolerance"] == 1


SPEED: dict[str, Any] = {"id": "q", "type": "number", "ask": "How fast?", "answer": "70 cm/s"}


@pytest.mark.parametrize("tolerance", [".5", "1e-1", "+5", "5.", 0.5])
def test_a_tolerance_without_a_unit_is_refused_however_its_number_is_written(
    tolerance: object,
) -> None:
    with pytest.raises(LessonError) as caught:
        read_question({**SPEED, "tolerance": tolerance})
    (problem,) = caught.value.problems
    assert (problem.path[-1], problem.code) == ("tolerance", "wrong-unit")
    assert problem.hint == f"tolerance: {tolerance} cm/s"


@pytest.mark.parametrize("value", [60, "0.6", "+60", ".6"])
def test_a_wrong_answer_without_a_unit_beside_an_answer_in_cm_per_second_is_refused(
    value: object,
) -> None:
    question = {**SPEED, "tolerance": "1 cm/s", "wrong": [{"value": value}]}
    with pytest.raises(LessonError) as caught:
        read_question(question)
    (problem,) = caught.value.problems
    assert (problem.path[-3:], problem.code) == (("wrong", 0, "value"), "wrong-unit")
    assert problem.hint == f"value: {value} cm/s"
    assert read_question({**question, "wrong": [{"value": 0}]}).KIND == "number"


@pytest.mark.parametrize(("answer", "hint"), [("0 m/s", "0.01 m/s"), ("0", "0.01")])
def test_percent_of_nought_is_no_tolerance(answer: str, hint: str) -> None:
    with pytest.raises(LessonError) as caught:
        read_question({**SPEED, "answer": answer, "tolerance": "5 %"})
    (problem,) = caught.value.problems
    assert problem.path[-1] == "tolerance"
    assert problem.message == "5 % of 0 is 0: no other number would be right"
    assert problem.hint == f"give it as a number: tolerance: {hint}"
    assert read_question({**SPEED, "answer": answer, "tolerance": "0 %"}).KIND == "number"


def test_percent_of_an_answer_is_no_unit_of_its_own() -> None:
    assert read_question({**FORCE, "answer": "2 N", "tolerance": "1 %"}).KIND == "number"


def test_a_wrong_ratio_beside_an_answer_in_percent_needs_no_unit() -> None:
    ratio = {**SPEED, "answer": "50 %", "tolerance": "1 %", "wrong": [{"value": 0.2}]}
    assert read_question(ratio).data(key=True)["key"]["wrong"][0]["value"] == pytest.approx(20)


@pytest.mark.parametrize("answer", ["abc", "0 apples"])
def test_a_tolerance_in_percent_of_an_answer_that_cannot_be_read_is_no_mistake_of_its_own(
    answer: str,
) -> None:
    table = {"columns": ["a", "b"], "rows": [["1", {"answer": answer, "tolerance": "5 %"}]]}
    for question in (
        {**SPEED, "answer": answer, "tolerance": "5 %"},
        {"id": "q", "type": "table", "ask": "How large?", **table},
    ):
        with pytest.raises(LessonError) as caught:
            read_question(question)
        assert {problem.path[-1] for problem in caught.value.problems} == {"answer"}


def test_percent_of_a_wrong_nought_is_exactly_nought() -> None:
    wrong = [{"value": "0 N", "tolerance": "5 %", "feedback": "There is one."}]
    question = read_question({**FORCE, "answer": "2 N", "wrong": wrong})
    assert question.data(key=True)["key"]["wrong"][0]["tolerance"] == 0


@pytest.mark.parametrize(("answer", "hint"), [("0.5 N", "2 %"), ("0.5", "2 %"), ("0 N", "0.01 N")])
def test_a_tolerance_that_is_missing_is_answered_with_a_narrow_one(answer: str, hint: str) -> None:
    """The example of a force, 0.5 N, would let any answer pass."""
    with pytest.raises(LessonError) as caught:
        read_question({"id": "f", "type": "number", "ask": "How large?", "answer": answer})
    (problem,) = caught.value.problems
    assert (str(problem.message), problem.hint) == (
        "tolerance is missing", f"tolerance: {hint}",
    )  # fmt: skip


@pytest.mark.parametrize(
    ("answer", "tolerance", "told"),
    [
        ("0.66667 m/s", "0.0001 m/s", "no number of 3 figures lies within the tolerance"),
        ("12.34 cm/s", "0.01 %", "no number of 3 figures lies within the tolerance"),
        ("0.667 m/s", "0.0001 m/s", ""),
        ("0.5 m/s", "0.5 m/s", "with this tolerance 0 is right too"),
        ("0 m/s", "5 %", "5 % of 0 is 0"),
    ],
)
def test_a_cell_of_a_table_asks_for_a_number_as_a_question_of_its_own_does(
    answer: str, tolerance: str, told: str
) -> None:
    """Else a student's 0.667 in a cell was wrong, beside 0.66667 that nobody types."""
    right = {"answer": answer, "tolerance": tolerance}
    of_number = problems_of({**SPEED, **right})
    of_cell = problems_of(
        {"id": "q", "type": "table", "ask": "How fast?", "columns": ["a", "b"],
         "rows": [["1", right]]}
    )  # fmt: skip
    assert of_cell == of_number
    assert len(of_cell) == bool(told)
    assert told in "".join(str(message) for _, message, _ in of_cell)


def problems_of(question: dict[str, Any]) -> list[tuple[object, object, str]]:
    try:
        read_question(question)
    except LessonError as error:
        return [(p.path[-1], p.message, p.hint) for p in error.problems]
    return []


@pytest.mark.parametrize(
    ("value", "reached"), [("2.1 N", False), ("1.9 N", False), ("2.11 N", True), ("1.89 N", True)]
)
def test_a_known_wrong_answer_lies_beyond_the_edge_of_the_tolerance(
    value: str, reached: bool
) -> None:
    """At the edge itself an answer is right: its feedback would never be shown."""
    question = {**FORCE, "answer": "2 N", "tolerance": "0.1 N", "wrong": [{"value": value}]}
    if reached:
        assert read_question(question).KIND == "number"
        return
    with pytest.raises(LessonError) as caught:
        read_question(question)
    assert [problem.code for problem in caught.value.problems] == ["unreachable"]


@pytest.mark.parametrize("tolerance", ["-0.01 N", "-5 %", "−0.2 N"])
def test_a_negative_tolerance_is_refused_however_small_it_is(tolerance: str) -> None:
    with pytest.raises(LessonError) as caught:
        read_question({**FORCE, "answer": "2 N", "tolerance": tolerance})
    (problem,) = caught.value.problems
    assert (problem.path[-1], problem.code) == ("tolerance", "out-of-range")
