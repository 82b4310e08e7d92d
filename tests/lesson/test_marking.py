"""Marking: what each kind of question says to an answer, the same in Python and in the page.

The vectors in tests/marking were written by hand; both programs must give exactly them.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim.lesson import read_question
from sim.lesson.mark import is_empty
from sim.lesson.read import KINDS
from sim.lesson.typed import read_typed
from tests.web.widget_site import in_node

VECTORS = Path(__file__).parents[1] / "marking"
NUMBERS = json.loads((VECTORS / "typed-numbers.json").read_text(encoding="utf-8"))
SETS = {
    path.stem: json.loads(path.read_text(encoding="utf-8"))
    for path in sorted(VECTORS.glob("*.json"))
    if path.stem != "typed-numbers"
}


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


def test_python_reads_typed_numbers_as_written_by_hand() -> None:
    for case in NUMBERS["cases"]:
        found = read_typed(case["typed"], NUMBERS["units"])
        if case["value"] is None:
            assert isinstance(found, str), case
            assert found
        else:
            assert found == case["value"], case


def test_the_page_reads_typed_numbers_in_the_same_way_and_words() -> None:
    made = in_node(
        """const { readNumber } = await import(source + "/question/marking/typed-number.js");
        give(data.cases.map(({ typed }) => readNumber(typed, data.units)));""",
        NUMBERS,
    )
    for case, found in zip(NUMBERS["cases"], made, strict=True):
        ours = read_typed(case["typed"], NUMBERS["units"])
        assert found == ({"problem": ours} if isinstance(ours, str) else {"value": ours}), case


ANSWERS = st.recursive(
    st.none() | st.booleans() | st.floats() | st.integers() | st.text(max_size=8),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=3), inner),
    max_leaves=6,
)


@given(ANSWERS, st.none() | st.floats(allow_nan=False, allow_infinity=False))
def test_no_answer_whatever_breaks_the_marking(value: Any, own: float | None) -> None:
    for vectors in SETS.values():
        mark = read_question(vectors["question"]).mark(value, own)
        assert (mark.verdict == "empty") == is_empty(value)
        assert mark.marks is None or 0 <= mark.marks <= mark.of
        assert mark.verdict != "right" or mark.marks == mark.of
