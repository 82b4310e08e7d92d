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


def test_percent_of_an_answer_is_no_unit_of_its_own() -> None:
    assert read_question({**FORCE, "answer": "2 N", "tolerance": "1 %"}).KIND == "number"
