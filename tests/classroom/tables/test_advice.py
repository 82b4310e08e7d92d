"""What a report advises fits what it was made from: files, a table, or summaries of schools."""

from __future__ import annotations

from typing import Any

import pytest

from sim.classroom.show.report_page import report_html
from sim.classroom.summary.document import Read, document
from sim.classroom.summary.handed_on import handed_on
from sim.cli.classroom.text import report_as_text
from tests.classroom.given.exported_tables import WIDE
from tests.classroom.given.tables import csv, judged, reported

LETTERS = csv(("student", "Q1", "Q2"), [[f"s{k}", "AB"[k % 2], "CD"[k % 2]] for k in range(8)])
ROW = "nothing is marked. A row KEY in the table gives the right answers."


def shown(report: dict[str, Any]) -> list[str]:
    return [report_html(report), report_as_text(report, {})]


def of_summary(table: bytes) -> dict[str, Any]:
    found = judged(table)
    whole = handed_on([found.lesson], found.groups)
    return document(whole.lessons, whole.groups, Read(unit="summaries", read=1, counted=1))


def test_a_table_of_letters_is_told_of_the_row_key_and_of_no_file() -> None:
    for text in shown(reported(LETTERS)):
        assert ROW in text
        assert "--key" not in text
        assert "key file" not in text


@pytest.mark.parametrize("table", [LETTERS, WIDE])
def test_a_summary_is_told_of_nothing_that_it_cannot_be_given(table: bytes) -> None:
    for text in shown(of_summary(table)):
        for word in ("--key", "row KEY", "key file", "--max", "row MAX"):
            assert word not in text


def test_the_page_speaks_of_no_option_of_the_command() -> None:
    page, terminal = shown(reported(WIDE))
    assert "“pre (30)”, or in a row MAX" in page
    assert "--" not in page
    assert "--max N" in terminal
