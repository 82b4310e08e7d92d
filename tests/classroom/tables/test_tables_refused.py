"""Rows and files that are no marks are named, and never break or run."""

from __future__ import annotations

import json
import random

import pytest

from sim.classroom.show.class_csv import items_csv, students_csv
from sim.classroom.show.report_page import report_html
from sim.classroom.tables.cells import TableError
from sim.classroom.tables.read import read_table
from sim.pages.language import words
from sim.pages.translate.catalogues import OTHERS
from tests.classroom.given.exported_tables import (
    GOOGLE,
    GOOGLE_ITEMS,
    MICROSOFT,
    MOODLE,
    MOODLE_GERMAN,
    WIDE,
)
from tests.classroom.given.tables import csv, reported


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("s1,a,four,3", "pre: “four” is no mark"),
        ("s1,a,=1+1,3", "pre: “=1+1” is no mark"),
        ("s1,a,-2,3", "pre: “-2” is below 0"),
        ("s1,a,1e3,3", "pre: “1e3” is no mark"),
        ("s1,a,Ⅲ,3", "pre: “Ⅲ” is no mark"),
        ("s1,a,12 / 10,3", "pre: “12 / 10” is more than the most marks"),
        ("s1,a,1,2,3", "5 cells under 4 headings"),
        ('s1,a,"1"x,3', "a quotation mark opens"),
        ("s1,,1,3", "no group is given"),
        ("x" * 200 + ",a,1,3", "the name of the student has 200 characters"),
        ("s2,b,1,3", "this student is in another group or class (marks.csv, line 3)"),
    ],
)
def test_a_bad_row_is_named_by_its_line_and_the_others_are_read(line: str, reason: str) -> None:
    text = f"student,group,pre,post\n{line}\n" + "\n".join(f"s{k},a,{k},{k}" for k in range(2, 9))
    if line.startswith("s2"):
        text = "student,group,pre,post\nx,a,1,1\n" + text.partition("\n")[2].partition("\n")[2]
        text = f"{text}\n{line}"
    report = reported(text.encode(), group_of=lambda row: row.group)
    (bad,) = report["files"]["refused"]
    assert bad["reason"].startswith(reason)
    assert bad["name"] == f"marks.csv, line {10 if line.startswith('s2') else 2}"
    assert report["lessons"][0]["gains"][0]["n"] == 7 + line.startswith("s2")


def test_a_student_twice_waits_for_the_teacher() -> None:
    twice = WIDE + b"\r\ns3,b,1,1\r\ns4,a,4,4"
    report = reported(twice)
    assert {flag["code"] for flag in report["flags"]} == {"doubled-id", "same-file"}
    assert "s3" not in report["lessons"][0]["gains"][1]["students"]
    assert "s4" in report["lessons"][0]["gains"][0]["students"]


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"", "no row"),
        (b"PK\x03\x04rest", "workbook"),
        (b"\x00\x01\x02", "no file of text"),
        (b"name,comment\nfox,hello there\n", "no column of marks"),
        (b"student,item\nfox,Q1\n", "one of marks"),
    ],
)
def test_what_is_no_table_of_marks_is_refused_in_words(content: bytes, reason: str) -> None:
    with pytest.raises(TableError, match=reason):
        read_table("x.csv", content)


def test_no_cell_reaches_a_spreadsheet_as_a_formula_or_a_page_as_a_tag() -> None:
    evil = ["=HYPERLINK(1)", "+1+1", "@SUM(1)", "-2+3", "<img src=x onerror=alert(1)>"]
    head = ["student", "group", *(f"{cell} Q{k}" for k, cell in enumerate(evil))]
    rows_ = [[f"{evil[k % 5]}{k}", evil[k % 5], *(dice % 2 for dice in range(k, k + 5))]
             for k in range(25)]  # fmt: skip
    report = reported(csv(head, rows_))
    for table in (students_csv(report), items_csv(report)):
        for line in table.splitlines()[1:]:
            for cell in line.split('","'):
                assert cell.strip('"')[:1] not in ("=", "+", "@", "-"), line
    assert "<img" not in report_html(report)


def test_mutated_tables_are_read_or_refused_and_never_break() -> None:
    dice = random.Random(19)
    texts = (MOODLE, MOODLE_GERMAN, GOOGLE, GOOGLE_ITEMS, MICROSOFT)
    seeds = [WIDE, *(text.encode() for text in texts)]
    words = [
        '"',
        ",",
        ";",
        "KEY",
        "MAX",
        "/",
        "pre",
        "post",
        "time",
        "item",
        "-",
        "−",
        "1/0",
        "=cmd()",
    ]
    parts = [*(word.encode() for word in words), b"\n", b"\r", b"\0", b"\xff\xfe", b"9" * 30]
    read = 0
    for _ in range(2_000):
        content = bytearray(dice.choice(seeds))
        for _ in range(dice.randint(1, 6)):
            at = dice.randrange(len(content))
            end = at + dice.choice((0, 1, 1, 4, 30))
            content[at:end] = dice.choice(parts)
        try:
            report = reported(bytes(content))
        except TableError as error:
            assert str(error)
            continue
        read += 1
        json.dumps(report, allow_nan=False)
        report_html(report)
        assert all(", line " in row["name"] for row in report["files"]["refused"])
    assert read > 500


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ("bad,a,3,12", "post (10): “12” is more than the most marks"),
        ("bad,a,3,many", "post (10): “many” is no mark"),
        ("bad,a,12,3", "pre (10): “12” is more than the most marks"),
    ],
)
def test_a_row_that_cannot_be_right_counts_in_no_test(row: str, reason: str) -> None:
    good = "\n".join(f"s{k},a,{k},{k}" for k in range(2, 9))
    report = reported(f"student,group,pre (10),post (10)\n{good}\n{row}".encode())
    (bad,) = report["files"]["refused"]
    assert (bad["name"], bad["reason"]) == ("marks.csv, line 9", reason)
    assert report["files"]["counted"] == 7
    assert [form["groups"][0]["n"] for form in report["lessons"][0]["forms"]] == [7, 7]
    assert report["lessons"][0]["gains"][0]["without_after"] == []


def test_totals_above_the_most_marks_that_the_teacher_told_count_in_no_test() -> None:
    good = "\n".join(f"s{k},a,{k},{k}" for k in range(2, 9))
    text = f"student,group,pre,post\n{good}\nbad,a,3,12.5\nworse,a,11,12"
    report = reported(text.encode(), most=10)
    assert [(row["name"], row["reason"]) for row in report["files"]["refused"]] == [
        ("marks.csv, line 9", "“12.5” is more than the most marks"),
        ("marks.csv, line 10", "“11” is more than the most marks"),
        ("marks.csv, line 10", "“12” is more than the most marks"),
    ]
    assert [form["groups"][0]["n"] for form in report["lessons"][0]["forms"]] == [7, 7]


@pytest.mark.parametrize("saved", [students_csv, items_csv])
def test_a_table_that_the_report_saved_is_not_read_as_marks(saved) -> None:
    """Before, a student with two tests became two students of one name, and none was counted."""
    report = reported(csv(("student", "pre", "post"), [("Anna", 3, 8), ("Bala", 4, 9)]))
    with pytest.raises(TableError, match="Class results saved: give the answer files"):
        read_table("class-students.csv", saved(report).encode())


@pytest.mark.parametrize("saved", [students_csv, items_csv])
@pytest.mark.parametrize("language", OTHERS)
def test_a_table_saved_by_a_page_in_another_language_is_known_too(saved, language) -> None:
    """Before, only English headings were known; the others were read as marks, or for no reason."""
    report = reported(csv(("student", "pre", "post"), [("Anna", 3, 8), ("Bala", 4, 9)]))
    with pytest.raises(TableError, match="Class results saved: give the answer files"):
        read_table("class-students.csv", saved(report, words(language)).encode())
