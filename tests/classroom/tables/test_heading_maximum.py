"""A number in a heading is the most marks where nothing speaks against it, and is always named."""

from __future__ import annotations

import pytest

from sim.classroom.tables.heading_maximum import with_most
from sim.classroom.tables.read import read_table
from tests.classroom.given.exported_tables import WIDE
from tests.classroom.given.tables import csv, reported

NO_MOST = ["pre (2024)", "Test 3/2025", "Klausur 12/05", "Test 31/1", "Quiz (12.05)", "vor 25/26",
           "Klausur 12/05/26", "post [1999]"]  # fmt: skip
MOST = {"pre (30)": 30, "pre /2": 2, "Q1/5": 5, "Q. 1 /1.00": 1, "Task 1/40": 40, "post (7,5)": 7.5,
        "pre (max 2000)": 2000, "pre [of 1950]": 1950}  # fmt: skip


@pytest.mark.parametrize("heading", NO_MOST)
def test_a_year_or_a_day_in_a_heading_is_no_number_of_marks(heading: str) -> None:
    assert with_most(heading) == (heading, None)
    rows = [[f"s{k}", 2 * k] for k in range(12)]
    table = read_table("m.csv", csv(("student", heading), rows))
    assert table.refused == ()
    assert [(row.of, {*row.most}) for row in table.taken] == [(None, set())] * 12
    (note,) = table.notes
    assert f"not taken for the most marks: “{heading}”" in note


@pytest.mark.parametrize("heading", MOST)
def test_any_other_number_in_a_heading_is_the_most_marks(heading: str) -> None:
    assert with_most(heading)[1] == MOST[heading]


def test_tests_with_a_year_behind_their_names_are_before_and_after() -> None:
    rows = [[f"s{k}", k, k + 3] for k in range(9)]
    lesson = reported(csv(("student", "pre (2024)", "post (2025)"), rows), most=20)["lessons"][0]
    assert [(form["form"], form["of"], form["n"]) for form in lesson["forms"]] == [
        ("pre", 20, 9), ("post", 20, 9),
    ]  # fmt: skip
    assert lesson["gains"][0]["n"] == 9


def test_a_number_below_the_marks_of_its_column_is_not_the_most() -> None:
    rows = [[f"s{k}", k % 8, k % 7] for k in range(12)]
    table = read_table("m.csv", csv(("student", "Quiz (1)", "Quiz (2)"), rows))
    assert table.refused == ()
    assert [*table.taken[7].items.items()] == [("Quiz (1)", 7), ("Quiz (2)", 0)]
    assert "“Quiz (1)”, “Quiz (2)”" in table.notes[0]


def test_a_single_mark_above_the_most_is_a_slip_and_its_row_is_refused() -> None:
    rows = [[f"s{k}", k] for k in range(10)]
    table = read_table("m.csv", csv(("student", "pre (9)"), [*rows, ["s10", 90]]))
    assert [reason for _, reason in table.refused] == ["pre (9): “90” is more than the most marks"]
    assert {row.of for row in table.taken} == {9}


def test_the_numbers_that_are_taken_for_the_most_marks_are_named() -> None:
    rows = [[f"s{k}", k, k] for k in range(9)]
    (note,) = reported(csv(("student", "pre (30)", "post /30"), rows))["notes"]
    assert note == "The headings tell the most marks: “pre (30)”, “post /30”."
    told = reported(csv(("student", "pre (30)", "post (30)"), [["MAX", 40, 40], *rows]))
    assert not any("headings" in one for one in told["notes"])


def test_marks_that_a_table_does_not_tell_are_asked_for() -> None:
    report = reported(WIDE)
    gain = report["lessons"][0]["gains"][0]
    assert gain["gain"] is None
    assert gain["refusals"][0] == "gain: the most marks of this test are not known"
    assert any("“pre (30)”, or in a row MAX" in note for note in report["notes"])
    assert reported(WIDE, most=10)["lessons"][0]["gains"][0]["gain"] is not None
    head, line = ("student", "pre", "post"), ["MAX", 10, 10]
    told = csv(head, [line, *([f"s{k}", k % 5, k % 7] for k in range(14))])
    assert reported(told)["lessons"][0]["gains"][0]["of"] == 10
