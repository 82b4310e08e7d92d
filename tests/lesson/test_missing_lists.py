"""A list under a wrong name is the one that its question needs. Before, `items:` in an ordering was
answered “did you mean minutes?”. And what a hint shows can be copied.
"""

from __future__ import annotations

import pytest
import yaml

from sim.lesson.problems import LessonError
from sim.lesson.read import KINDS, read_question


def hints(**keys: object) -> list[str]:
    with pytest.raises(LessonError) as caught:
        read_question({"id": "q", "ask": "?", **keys})
    return [p.hint for p in caught.value.problems if p.code == "unknown-key"]


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


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind not in {"confidence", "idea"}])
def test_what_the_hints_show_makes_a_question_without_a_mistake(kind: str) -> None:
    bare = {"id": "q", "ask": "?", "type": kind}
    with pytest.raises(LessonError) as caught:
        read_question(bare)
    for problem in caught.value.problems:
        bare |= yaml.safe_load(problem.hint)
    assert kind == read_question(bare).KIND
