"""Grades of a whole course, and answers whose students say themselves when they took the test."""

from __future__ import annotations

import pytest

from sim.classroom.tables.cells import TableError
from sim.classroom.tables.read import read_table

PRE, POST = (5, 9, 7), (11, 12, 7)
GRADES = (
    "First name,Last name,ID number,Institution,Department,Email address,{columns},"
    "Last downloaded from this course\n"
)


def marks(text: str) -> dict[str, list[float]]:
    """The totals of each test."""
    found: dict[str, list[float]] = {}
    for row in read_table("t.csv", text.encode()).taken:
        found.setdefault(row.form, []).append(float(row.marks))
    return found


def grades(columns: str, *rows: str) -> str:
    people = (
        f"F{k},S{k},{1040 + k},,,f{k}@x.example,{row},1714000000" for k, row in enumerate(rows)
    )
    return GRADES.format(columns=columns) + "\n".join(people) + "\n"


BOTH = [f"{a}.00,{b}.00,{a + b}.00" for a, b in zip(PRE, POST, strict=True)]


@pytest.mark.parametrize(
    "columns",
    [
        "Quiz: Before (Real),Quiz: After (Real),Course total (Real)",
        "Quiz: Pre-test on forces (Real),Quiz: Post-test on forces (Real),Course total (Real)",
        "Test: Vortest (Punkte),Test: Nachtest (Punkte),Kurs gesamt (Punkte)",
    ],
)
def test_the_grades_of_a_moodle_course_are_two_tests_and_the_number_of_a_person_is_no_mark(
    columns: str,
) -> None:
    assert marks(grades(columns, *BOTH)) == {"pre": list(PRE), "post": list(POST)}


def test_the_one_quiz_of_a_course_is_the_test() -> None:
    columns = "Quiz: Forces (Real),Course total (Real)"
    rows = [f"{a}.00,{a}.00" for a in PRE]
    assert list(marks(grades(columns, *rows)).values()) == [list(PRE)]


def test_two_quizzes_that_say_nothing_of_before_and_after_are_asked_about() -> None:
    columns = "Quiz: Unit 1 (Real),Quiz: Unit 2 (Real),Course total (Real)"
    with pytest.raises(TableError, match=r"which of these tests is before.*Unit 1.*Unit 2"):
        marks(grades(columns, *BOTH))


@pytest.mark.parametrize(
    ("before", "after"), [("Before", "After"), ("Before the lessons", "After the lessons"),
                          ("Pre-test", "Post-test")]
)  # fmt: skip
@pytest.mark.parametrize("head", ["Which test?", "When do you take it"])
def test_students_who_say_when_they_take_a_form_are_believed(
    head: str, before: str, after: str
) -> None:
    rows = [f"1.2.2026 9:0{k},{m} / 18,CODE-{k},{before}" for k, m in enumerate(PRE)]
    rows += [f"1.3.2026 9:0{k},{m} / 18,CODE-{k},{after}" for k, m in enumerate(POST)]
    google = "\n".join([f"Timestamp,Total score,Code word,{head}", *rows]) + "\n"
    assert marks(google) == {"pre": list(PRE), "post": list(POST)}
    own = "\n".join(",".join(row.split(",")[1:]) for row in rows).replace(" / 18", "")
    assert marks(f"marks,code word,{head}\n{own}\n") == {"pre": list(PRE), "post": list(POST)}


@pytest.mark.parametrize("number", ["ID number", "Index No.", "Matric No.", "Matrikelnummer"])
def test_the_number_of_a_person_is_no_mark_and_a_name_goes_before_it(number: str) -> None:
    rows = [f"{k + 1},Kim {k},{a},{b}" for k, (a, b) in enumerate(zip(PRE, POST, strict=True))]
    text = f"{number},Name,Pre,Post\n" + "\n".join(rows) + "\n"
    assert marks(text) == {"pre": list(PRE), "post": list(POST)}
    assert {row.student for row in read_table("t.csv", text.encode()).taken} == {
        "Kim 0", "Kim 1", "Kim 2",
    }  # fmt: skip


CANVAS = """Student,ID,SIS User ID,SIS Login ID,Section,{before} (91234567),{after} (124),\
Assignments Current Points,Current Score
,,,,,,Manual Posting,,
    Points Possible,,,,,10.00,12.00,(read only),(read only)
"Müller, Anna",17,s17,anna,7A,3.00,7.00,10.00,45.45
"Müller, Jan",18,s18,jan,7B,4.00,EX,4.00,40.00
"Student, Test",19,,0f3a,7A,,,,
"""


def test_the_number_that_canvas_gives_a_test_is_not_the_most_marks() -> None:
    text = CANVAS.format(before="Force pre", after="Post-test on forces")
    table = read_table("t.csv", text.encode())
    assert {(row.student, row.form, float(row.marks), row.of) for row in table.taken} == {
        ("Müller, Anna", "pre", 3.0, 10),
        ("Müller, Anna", "post", 7.0, 12),
        ("Müller, Jan", "pre", 4.0, 10),  # excused from the other
    }
    assert not table.refused
    assert table.classes


def test_two_tests_of_canvas_that_say_nothing_of_before_and_after_are_asked_about() -> None:
    with pytest.raises(TableError, match=r"which of these tests is before.*Unit 1.*Unit 2"):
        marks(CANVAS.format(before="Unit 1", after="Unit 2"))
