"""Marking: what each kind of question says to an answer, the same in Python and in the page.

The vectors in tests/marking were written by hand; both programs must give exactly them.
"""

from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim.lesson import read_question
from sim.lesson.mark import is_empty
from sim.lesson.problems import LessonError
from sim.lesson.read import KINDS
from sim.scene.notation import same_unit
from tests.lesson.marking_vectors import SETS, VECTORS
from tests.web.scene.given.widget_site import in_node

NUMBERS = json.loads((VECTORS / "typed-numbers.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", SETS)
def test_python_marks_as_written_by_hand(name: str) -> None:
    question = read_question(SETS[name]["question"])
    for case in SETS[name]["cases"]:
        made = question.mark(case["value"], case.get("own")).as_row()
        assert made == case["mark"], (case, made)


def test_every_kind_of_question_has_vectors() -> None:
    assert {vectors["question"]["type"] for vectors in SETS.values()} == set(KINDS)


def test_the_page_marks_as_written_by_hand() -> None:
    data = [
        {"facts": read_question(vectors["question"]).data(key=True), "cases": vectors["cases"]}
        for vectors in SETS.values()
    ]
    marked = in_node(
        """const { mark } = await import(source + "/question/marking/mark.js");
        give(data.map(({ facts, cases }) =>
          cases.map(({ value, own }) => mark(facts, value, own ?? null))));""",
        data,
    )
    for vectors, marks in zip(SETS.values(), marked, strict=True):
        for case, made in zip(vectors["cases"], marks, strict=True):
            assert made == case["mark"], (vectors["says"], case, made)


def test_the_page_reads_typed_numbers_as_written_by_hand() -> None:
    made = in_node(
        """const { readNumber } = await import(source + "/question/marking/typed-number.js");
        give(data.cases.map(({ typed }) => readNumber(typed, data.units)));""",
        NUMBERS,
    )
    for case, found in zip(NUMBERS["cases"], made, strict=True):
        if case["value"] is None:
            assert found.get("problem"), case
        else:
            assert found == {"value": case["value"]}, case


def test_a_unit_that_most_people_write_with_a_capital_is_read() -> None:
    """As in “0.3 Kg m/s.”: what is asked for is the number."""
    made = in_node(
        """const { readNumber } = await import(source + "/question/marking/typed-number.js");
        give(data.map((typed) => readNumber(typed, { "kg m/s": 1, "kg": 1 })));""",
        ["0.3 Kg m/s.", "0.3 KG", "0.3 kG m/s", "0.3 K"],
    )
    assert made[:2] == [{"value": 0.3}] * 2
    assert all("problem" in one for one in made[2:])


NOTATIONS = [
    ["m/s²", "m/s^2", "m s⁻²", "m s^-2", "m·s-2", "m s−2", "m/s/s", "m s**-2", "m s2/s⁴"],
    ["kg m/s", "kg m s⁻¹", "kg·m·s^-1", "m kg/s"],
    ["N/m^1.5", "N/m^(3/2)", "N m^-1.5"],
    ["cm/s", "cm s⁻¹"], ["m/s", "m s⁻¹"], ["ms"], ["m s"], ["s⁻²"], ["%"], ["°"],
    ["m/"], ["/s"], [""], ["m//s"], ["7"], ["kg" * 40],
]  # fmt: skip


def test_a_unit_is_the_same_however_it_is_written_in_python_and_in_the_page() -> None:
    written = [(unit, k) for k, row in enumerate(NOTATIONS) for unit in row]
    pairs = [(a, b, j == k) for a, j in written for b, k in written]
    in_page = in_node(
        """const { sameUnit } = await import(source + "/question/marking/notation.js");
        give(data.map(([one, other]) => sameUnit(one, other)));""",
        [list(pair) for pair in pairs],
    )
    for (one, other, same), page in zip(pairs, in_page, strict=True):
        assert (one, other, same_unit(one, other)) == (one, other, same)
        assert (one, other, page) == (one, other, same)


def test_a_schools_own_way_of_writing_units_is_that_of_its_hints() -> None:
    question = {"id": "v", "type": "number", "ask": "How fast?", "answer": "0.30 m s⁻¹"}
    facts = read_question({**question, "tolerance": "0.01 m s⁻¹"}).data(key=True)
    assert list(facts["units"])[:2] == ["m s⁻¹", "cm s⁻¹"]
    assert facts["units"]["cm s⁻¹"] == 0.01


@pytest.mark.parametrize(
    ("answer", "typed"),
    [("2 N", "2 kg m/s²"), ("2 N", "2 kg m s^-2"), ("2 N", "2 kg*m/s/s"), ("3 J", "3 N m"),
     ("2 N", "2 kgm/s^2"), ("3 J", "3 Nm"), ("4 kg m/s", "4 kgm/s"), ("4 kg m/s", "4kgms^-1"),
     ("4 kg m s⁻¹", "4 kgm s-1"), ("4 N s", "4 kgm/s")],
)  # fmt: skip
def test_a_unit_with_a_name_of_its_own_may_be_written_in_those_it_is_made_of(
    answer: str, typed: str
) -> None:
    question = {"id": "f", "type": "number", "ask": "?", "answer": answer, "tolerance": "1 %"}
    facts = read_question(question).data(key=True)
    read = """const { readNumber } = await import(source + "/question/marking/typed-number.js");
        give(readNumber(data[0], data[1]));"""
    assert in_node(read, [typed, facts["units"]]) == {"value": float(answer[0])}


ANSWERS = st.recursive(
    st.none() | st.booleans() | st.floats() | st.integers() | st.text(max_size=8),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=3), inner),
    max_leaves=6,
)


def test_an_idea_takes_no_right_answer_and_no_feedback() -> None:
    with pytest.raises(LessonError, match="an idea is never marked"):
        read_question({"id": "i", "type": "idea", "ask": "?", "options": [
            {"text": "Ana", "correct": True}, "Ben"]})  # fmt: skip
    typed = read_question({"id": "i", "type": "idea", "ask": "?"})
    assert typed.mark("anything at all").verdict == "open"


@given(ANSWERS, st.none() | st.floats(allow_nan=False, allow_infinity=False))
def test_no_answer_whatever_breaks_the_marking(value: Any, own: float | None) -> None:
    for vectors in SETS.values():
        mark = read_question(vectors["question"]).mark(value, own)
        assert (mark.verdict == "empty") == is_empty(value)
        assert mark.marks is None or 0 <= mark.marks <= mark.of
        # A question without marks waits for a person, who can read only what is open.
        assert mark.marks is not None or mark.verdict == "open" or not mark.of
        assert mark.verdict != "right" or mark.marks == mark.of
