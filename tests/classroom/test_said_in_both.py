"""What the page says of a class the terminal says too, and no heading stands there alone."""

from __future__ import annotations

import re
from html import unescape
from typing import Any

from sim.classroom.report.sentences import FEW_QUESTIONS
from sim.classroom.show.report_page import report_html
from sim.cli.classroom.text import report_as_text
from tests.classroom.given.everything import of_everything
from tests.classroom.given.tables import csv, reported


def in_both(report: dict[str, Any]) -> list[str]:
    """The report as the page and as the terminal shows it, without marks and line breaks."""
    page = unescape(re.sub(r"<[^>]+>", " ", report_html(report)))
    return [" ".join(text.split()) for text in (page, report_as_text(report, {}))]


def of_a_later_test(rows: int) -> dict[str, Any]:
    """Two groups on three tests, of which the third is in no pair."""
    made = [[f"s{k}", "ab"[k % 2], 3, 6 + k % 3, 5 + k % 4] for k in range(rows)]
    head = ("student", "group", "pre (9)", "post (9)", "later (9)")
    return reported(csv(head, made))


def test_topics_are_told_in_both() -> None:
    report = of_everything()
    (lesson,) = (one for one in report["lessons"] if one["topics"])
    says = [row["sentence"] for row in lesson["topic_differences"]]
    assert len(says) == 2
    for text in in_both(report):
        assert "By topic" in text
        for sentence in (*says, FEW_QUESTIONS):
            assert sentence in text


def test_answers_that_wait_for_the_teacher_are_told_in_both() -> None:
    for text in in_both(of_everything()):
        assert "Form pre, to be read by you and in no total yet: Question 11, Question 12." in text


def test_two_groups_on_a_later_test_are_told_in_both() -> None:
    report = of_a_later_test(24)
    (row,) = report["lessons"][0]["later"]
    assert row["sentences"]
    for text in in_both(report):
        assert all(sentence in text for sentence in row["sentences"])


def test_where_a_later_test_has_no_number_the_reason_stands_below_its_heading() -> None:
    report = of_a_later_test(4)
    (row,) = report["lessons"][0]["later"]
    assert row["refusals"]
    assert row["sentences"] == []
    for text in in_both(report):
        assert all(reason in text for reason in row["refusals"])
