"""How sure a class was is told as what was asked: nobody is another thing than not asked."""

from __future__ import annotations

from typing import Any

from sim.classroom.show.predictions import predictions_html
from sim.classroom.show.questions import _overview


def tell(text: object) -> str:
    return str(text)


def prediction(asked: bool) -> dict[str, Any]:
    return {
        "id": "s", "ask": "Which?", "n": 5, "again": 0, "locked": 5, "more": 0, "curves": [],
        "reasons": [], "asked_sure": asked, "answers": [{"said": "A", "count": 5, "sure": 0}],
    }  # fmt: skip


def test_of_a_prediction_nobody_was_sure_of_the_number_is_nought() -> None:
    """It was a dash, as where nobody was asked."""
    told = [predictions_html([prediction(asked)], tell) for asked in (True, False)]
    assert ["<td>0</td>" in one for one in told] == [True, False]


def test_who_was_sure_of_what_is_neither_right_nor_wrong_is_counted_in_all() -> None:
    """Five that were sure of their first idea were “0 / 0”."""
    choices = [{"label": "a", "count": 3, "sure": 3}, {"label": "b", "count": 2, "sure": 2}]
    row = {
        "label": "Question 1", "worth": 0, "choices": choices, "unread": 0, "empty": 0, "right": 0,
        "n": 5, "answered": 5, "sure": {"right": 0, "wrong": 0}, "difficulty": None,
        "discrimination": None, "point_biserial": None,
    }  # fmt: skip
    assert "5 in all" in _overview([row], tell)
    assert "3 / 2" in _overview([{**row, "worth": 1, "sure": {"right": 3, "wrong": 2}}], tell)
