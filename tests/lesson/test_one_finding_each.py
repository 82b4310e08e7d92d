"""One mistake of an author is one finding: what follows from it is not told beside it."""

from __future__ import annotations

from typing import Any

import pytest
import yaml

from sim.lesson.problems import LessonError
from sim.lesson.read import read_question
from sim.scene import SceneError, read_fence
from sim.scene.problem import Problem

CHOICE = """
id: q
type: single
ask: Which force is larger?
options:
  - {{text: They are equal., {right}}}
  - {{text: {wrong}}}
"""


def found(right: str = "correct: true", wrong: str = "The one on B.") -> list[Problem]:
    with pytest.raises(LessonError) as caught:
        read_question(yaml.safe_load(CHOICE.format(right=right, wrong=wrong)))
    return list(caught.value.problems)


@pytest.mark.parametrize("kind", ["single", "multiple"])
@pytest.mark.parametrize(
    ("right", "hint"),
    [
        ("Correct: true", "did you mean “correct”?"),
        ("corect: true", "did you mean “correct”?"),
        ("correct: richtig", "correct: true"),
    ],
)
def test_a_right_answer_that_is_marked_wrongly_is_none_that_is_missing(
    kind: str, right: str, hint: str
) -> None:
    question: dict[str, Any] = yaml.safe_load(CHOICE.format(right=right, wrong="B."))
    with pytest.raises(LessonError) as caught:
        read_question(question | {"type": kind})
    (problem,) = caught.value.problems
    assert problem.hint == hint


def test_where_no_answer_is_marked_that_is_told() -> None:
    (problem,) = found(right="feedback: Look again.")
    assert problem.code == "no-correct-option"


@pytest.mark.parametrize(
    ("wrong", "whole"),
    [
        ("They cancel, always.", "text: “They cancel, always.”"),
        ("First A, then B", "text: “First A, then B”"),
        ("Neither, never", "text: “Neither, never”"),
    ],
)
def test_a_text_that_a_comma_cuts_in_two_is_shown_in_quotes(wrong: str, whole: str) -> None:
    (problem,) = found(wrong=wrong)
    assert problem.hint.endswith(whole.replace("“", '"').replace("”", '"'))


def test_a_misspelt_key_behind_a_text_is_no_part_of_it() -> None:
    (problem,) = found(wrong="They cancel, feedbak")
    assert problem.hint == "did you mean “feedback”?"


def test_a_key_with_no_space_behind_its_colon_is_not_missing_too() -> None:
    carts = {"A": {"mass:0.5 kg": None, "position": 0.5}}
    with pytest.raises(SceneError) as caught:
        read_fence({"carts": carts}, named=False)
    (problem,) = caught.value.problems
    assert problem.hint == "write a space after the colon: mass: 0.5 kg"


@pytest.mark.parametrize(
    "asked",
    [
        {"type": "single", "options": [{"text": "{}", "correct": True}, "{}", "c"]},
        {"type": "idea", "options": ["{}", "{}"]},
        {"type": "ordering", "order": ["{}", "b", "{}"]},
        {"type": "matching", "pairs": [{"left": "{}", "right": "a"}, {"left": "{}", "right": "b"}]},
        {"type": "matching", "pairs": [{"left": "a", "right": "{}"}, {"left": "b", "right": "c"}],
         "others": ["{}"]},
    ],
)  # fmt: skip
def test_pictures_to_choose_from_differ_in_their_words(asked: dict[str, Any]) -> None:
    """Who hears them, a slip and the report have nothing else: “You answered: a cart.”"""
    plain = yaml.safe_dump({"id": "q", "ask": "Which?"} | asked, sort_keys=False)

    def written(first: str, second: str) -> dict[str, Any]:
        made = plain.replace("{}", first, 1).replace("{}", second, 1)
        return dict(yaml.safe_load(made))

    read_question(written("![a cart](a.png)", "![a wall](b.png)"))
    read_question(written("a  cart", "a cart with ![a wall](b.png)"))
    with pytest.raises(LessonError) as caught:
        read_question(written("![a cart](a.png)", "![a cart](b.png)"))
    (problem,) = caught.value.problems
    assert problem.code == "alike"
