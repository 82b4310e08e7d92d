"""Short answers: what is accepted, how it is compared, how it is written down and told again."""

from __future__ import annotations

import random
from typing import Any

import pytest

from sim.classroom.files.keyed import keyed_item
from sim.classroom.handouts.answered import right_words
from sim.lesson.key_file import item_key
from sim.lesson.kinds.plain_words import plain
from sim.lesson.problems import LessonError
from sim.lesson.read import read_question
from sim.pages.question.key_page import answer_words
from sim.scene.problem import Problem
from tests.web.scene.given.widget_site import in_node

SHORT: dict[str, Any] = {"id": "q", "type": "short", "ask": "How large?"}
ALIKE = [
    ("0 N", "0N"),
    ("0 N", "０ Ｎ"),
    ("1.5 N", "1,5n."),
    (".5", "0,5"),
    ("A", "Ａ"),
    ("F = m·a", "f=m · A"),
    ("50 %", "50%"),
    ("5 m/s²", "5m/s^2"),
    ("cart 1", "Cart1"),
    ("-5", "− 5"),
    ("Newton's law", "newton´s LAW!"),
    ("1, 2, 3", "1,2,3"),
    ("no. 5", "No.5"),
    ("", " ?!… "),
    ("5", "(5.)"),
]
OTHERS = [
    ("5", ".5"), ("5", "5,5"), ("1.5", "1:5"), ("1.5", "15"), ("1.5", "1 5"), ("10²", "102"),
    ("1 2", "12"), ("a b", "ab"), ("5", "-5"), ("1.2.3", "1.23"), ("5 N", "5 m"), ("=", ""),
]  # fmt: skip


def problems(**more: Any) -> tuple[Problem, ...]:
    with pytest.raises(LessonError) as caught:
        read_question({**SHORT, **more})
    return tuple(caught.value.problems)


@pytest.mark.parametrize(("one", "other"), ALIKE)
def test_capitals_blanks_and_punctuation_do_not_count(one: str, other: str) -> None:
    assert plain(one) == plain(other)


@pytest.mark.parametrize(("one", "other"), OTHERS)
def test_the_point_of_a_number_its_sign_and_its_digits_count(one: str, other: str) -> None:
    assert plain(one) != plain(other)


def test_the_page_compares_as_the_program_does() -> None:
    draw = random.Random(2026)
    signs = [*"019.,-:;!?'’´`“()=+·/*^% \t\u00a0\u2003\ufeff\x85\x1cabNµμΩİΣς"]
    signs += [*"０９Ａ，。、！：（＝−–‐²⁻¹½℃°ﬁ小车क्षا٥", "\U0001d400", "\U0001f600", "\ue000"]
    texts = [text for pair in (*ALIKE, *OTHERS) for text in pair]
    texts += ["".join(draw.choices(signs, k=draw.randint(0, 12))) for _ in range(4000)]
    said = in_node(
        """const { plain } = await import(source + "/question/marking/plain.js");
        give(data.map(plain));""",
        texts,
    )
    for text, found in zip(texts, said, strict=True):
        assert found == plain(text), ascii(text)


@pytest.mark.parametrize("text", ["?", " … ", "()", "。"])
def test_an_accepted_text_that_is_nothing_but_punctuation_is_refused(text: str) -> None:
    (problem,) = problems(accept=["zero", text])
    assert problem.path[-2:] == ("accept", 1)
    assert "nothing but punctuation" in problem.message
    (problem,) = problems(accept=["zero"], wrong=[{"text": text}])
    assert problem.path[-1] == "text"


@pytest.mark.parametrize("text", ["zero, 0, 0 N", "zero,0", "零、0"])
def test_one_accepted_text_with_commas_is_asked_about(text: str) -> None:
    (problem,) = problems(accept=text)
    assert problem.path[-1] == "accept"
    assert "several: accept: [" in problem.hint
    assert f'one: accept: ["{text}"]' in problem.hint
    assert read_question({**SHORT, "accept": [text]}).KIND == "short"


@pytest.mark.parametrize("text", ["zero", "0,5 N", 0, "1,5"])
def test_one_accepted_text_with_a_decimal_comma_needs_no_brackets(text: object) -> None:
    assert read_question({**SHORT, "accept": text}).KIND == "short"


def test_marks_that_differ_from_the_rubric_are_told() -> None:
    rubric = {0: "nothing", 1: "one", 2: "both"}
    for kind in ("short", "long"):
        (problem,) = problems(type=kind, rubric=rubric, marks=1)
        assert problem.path[-1] == "marks"
        assert problem.message == "marks is 1, and the rubric gives up to 2"
        read_question({**SHORT, "type": kind, "rubric": rubric, "marks": 2})


def test_the_right_answer_is_told_as_its_author_wrote_it() -> None:
    accept = ["1.5 N", "Newton's law F = m·a"]
    question = read_question({**SHORT, "accept": accept})
    row = item_key(question)
    assert right_words(keyed_item(row)) == "1.5 N"
    assert answer_words(question, row["key"]) == "1.5 N / Newton's law F = m·a"


def test_true_and_false_are_accepted_as_they_were_written() -> None:
    question = read_question({**SHORT, "accept": True})
    assert question.key()["accept"] == ["true"]
    assert question.mark("True.").verdict == "right"


def test_a_key_file_of_an_earlier_version_marks_as_before() -> None:
    row = item_key(
        read_question({**SHORT, "accept": ["1.5 N", "zero"], "wrong": [{"text": "2,5"}]})
    )
    del row["as_written"]
    row["key"]["accept"] = ["1 5 n", "zero"]
    row["key"]["wrong"][0]["texts"] = ["2 5"]
    question = keyed_item(row).question
    for answer in ("1.5 N", "1,5n", "Zero!"):
        assert question.mark(answer).verdict == "right", answer
    assert question.mark("5 n").verdict == "wrong"


@pytest.mark.parametrize(
    ("text", "others"), [("2 000 N", ("2.000 N", "2,000 N")), ("1 2", ("1.2", "1,2"))]
)
def test_class_results_mark_a_number_with_a_gap_as_the_page_does(
    text: str, others: tuple[str, ...]
) -> None:
    question = read_question({**SHORT, "accept": [text], "wrong": [{"text": f"{text} m"}]})
    keyed = keyed_item(item_key(question)).question
    for answer in (text, *others, *(f"{other} m" for other in others)):
        assert keyed.mark(answer) == question.mark(answer), answer
    assert keyed.mark(others[0]).verdict == "wrong"
