"""A list under a wrong name is the one that its question needs. Before, `items:` in an ordering was
answered “did you mean minutes?”. And what a hint shows can be copied.
"""

from __future__ import annotations

import pytest
import yaml

from sim.lesson.problems import LessonError
from sim.lesson.read import KINDS, read_question
from sim.scene.problem import Problem


def hints(**keys: object) -> list[str]:
    with pytest.raises(LessonError) as caught:
        read_question({"id": "q", "ask": "?", **keys})
    return [p.hint for p in caught.value.problems if p.code == "unknown-key"]


def missing(question: dict[str, object]) -> tuple[Problem, ...]:
    try:
        read_question(question)
    except LessonError as error:
        return error.problems
    return ()


@pytest.mark.parametrize("name", ["items", "lines", "steps", "ordering"])
def test_a_list_is_the_one_that_is_missing_whatever_it_is_called(name: str) -> None:
    assert hints(type="ordering", **{name: ["a", "b", "c"]}) == ["did you mean “order”?"]


def test_so_are_answers_and_pairs() -> None:
    options = [{"text": "a", "correct": True}, {"text": "b"}]
    assert hints(type="single", answers=options) == ["did you mean “options”?"]
    pairs = [{"left": "a", "right": "b"}, {"left": "c", "right": "d"}]
    assert hints(type="matching", items=pairs) == ["did you mean “pairs”?"]


def test_where_the_list_is_there_another_one_is_a_misspelt_key() -> None:
    assert hints(type="ordering", order=["a", "b", "c"], hint=["x"]) == ["did you mean “hints”?"]
    assert hints(type="long", minute=["a"]) == ["did you mean “minutes”?"]


@pytest.mark.parametrize("kind", KINDS)
def test_what_the_hints_show_makes_a_question_without_a_mistake(kind: str) -> None:
    """Also of a kind that needs no key of its own, as that of the developers' guide."""
    question: dict[str, object] = {"id": "q", "ask": "?", "type": kind}
    for problem in missing(question):
        question |= yaml.safe_load(problem.hint)
    assert kind == read_question(question).KIND
