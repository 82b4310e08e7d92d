"""A mean says how much of the test nobody answered."""

from __future__ import annotations

import csv
from typing import Any

from sim.classroom.files.reading import Reading, Source
from sim.classroom.handouts.class_sheet import sheet_html
from sim.classroom.report.report import Asked, class_report
from sim.classroom.report.sentences import left_open
from sim.classroom.show.class_csv import students_csv
from sim.classroom.show.report_page import report_html
from sim.cli.classroom.text import report_as_text
from tests.classroom.given.makers import answers, bank, keys, sources

BANK = bank(10)


def report_of_six() -> dict[str, Any]:
    """Six students, who answered the first question and no other."""
    students = [answers(BANK, f"FOX-{k}", "pre", {"item-0": "a"}, start=5 * k) for k in range(6)]
    reading = Reading.of([*sources(students), Source("key.json", keys(BANK).encode())])
    return class_report([(file, "class") for file in reading.files], reading.keys, [], Asked())


def test_a_mean_says_how_much_was_left_open() -> None:
    """Optional questions and those that give no marks are not missing."""
    row = {"worth": 1, "n": 12, "empty": 0}
    assert left_open([row, row]) == ""
    assert left_open([row, row | {"empty": 1}]) == (
        "1 of 24 answers was left open: it gives no marks."
    )
    assert left_open([row, row | {"empty": 3}, row | {"empty": 2}, row | {"worth": 0, "empty": 9},
                      row | {"optional": True, "empty": 9}]) == (
        "5 of 36 answers were left open: they give no marks."
    )  # fmt: skip
    report = report_of_six()
    (one,) = report["lessons"][0]["forms"]
    told = f"{6 * (one['of'] - 1)} of {6 * one['of']} answers were left open"
    for text in (report_html(report), report_as_text(report, {}), sheet_html(report, str)):
        assert told in text


def test_the_table_of_students_names_an_open_question_by_its_column() -> None:
    """Of the questions' ids a spreadsheet knows nothing."""
    rows = [*csv.DictReader(students_csv(report_of_six()).lstrip("\ufeff").splitlines())]
    assert len(rows) == 6
    for row in rows:
        assert row["question 1"] == "1"
        assert [row[f"question {number}"] for number in row["open"].split()] == ["0"] * 9
