"""Rows that are no students are told by the column of students alone, and each is named."""

from __future__ import annotations

from sim.classroom.tables.read import read_table
from sim.classroom.tables.taken import MarkTable
from tests.classroom.given.tables import judged, reported


def table(*lines: str) -> MarkTable:
    return read_table("m.csv", "\n".join(lines).encode())


def students(found: MarkTable) -> list[str]:
    return list(dict.fromkeys(row.student for row in found.taken))


def test_a_student_called_max_is_a_student() -> None:
    found = table("name,pre,post", "Anna,12,18", "Max,10,11", "Ben,8,20")
    assert students(found) == ["Anna", "Max", "Ben"]
    assert not found.refused
    assert "“Max” counts as a student" in found.notes[0]


def test_a_group_and_a_class_called_max_are_a_group_and_a_class() -> None:
    lines = ("Anna,Max,Key,1,2", "Ben,old,7a,2,3", "MAX,MAX,KEY,2,3")
    found = table("student,group,class,pre,post", *lines)
    assert students(found) == ["Anna", "Ben", "MAX"]
    assert {row.group for row in found.taken} == {"Max", "old", "MAX"}


def test_a_question_or_a_test_called_key_takes_no_row_away() -> None:
    found = table("no,title,student,Q1", "1,KEY,Anna,1", "2,MAX,Ben,0")
    assert students(found) == ["Anna", "Ben"]


def test_a_row_max_and_a_row_key_are_named_in_a_note() -> None:
    (most,) = reported(b"no,student,pre,post\n1,Anna,3,4\n,MAX,10,10")["notes"][:1]
    assert (
        most
        == "marks.csv, line 3: “MAX” is taken for the row of the most marks, not for a student."
    )
    found = table("student,Q1,Q2", "KEY,A,B", "Anna,A,B", "Ben,B,B")
    assert [float(row.marks) for row in found.taken] == [2, 1]
    assert "right answers" in found.notes[0]


def test_a_row_for_each_answer_has_its_key_and_its_most_marks_too() -> None:
    lines = ("KEY,1,A", "KEY,2,B", "Anna,1,A", "Anna,2,C", "Ben,1,A", "Ben,2,B")
    found = table("student,item,answer", *lines)
    assert [(row.student, float(row.marks)) for row in found.taken] == [("Anna", 1), ("Ben", 2)]
    told = judged(b"student,item,mark\nMAX,1,4\nAnna,1,2\nBen,1,3").lesson
    assert told.forms["test"].of == 4


def test_a_row_of_sums_or_means_is_no_student_and_named() -> None:
    for word in ("Mean", "average", "Durchschnitt", "Purata", "平均", "சராசரி"):
        found = table("name,pre,post", "Anna,2,5", "Ben,5,8", f"{word},3.5,6.5")
        assert students(found) == ["Anna", "Ben"], word
        assert "sums or means" in found.notes[0]
    for word in ("Total", "SUM", "Summe", "Jumlah", "总分", "மொத்தம்"):
        found = table("name,Q1,Q2", "Anna,1,1", "Ben,1,0", f"{word},2,1")
        assert (students(found), found.rows) == (["Anna", "Ben"], 2), word
    below = table("no,name,Q1", "1,Anna,1", "2,Ben,1", "Total,,2")
    assert students(below) == ["Anna", "Ben"]


def test_a_student_may_be_called_sum() -> None:
    found = table("name,pre,post", "Anna,2,5", "Sum,3,9", "Ben,5,8")  # no sum of pre
    assert students(found) == ["Anna", "Sum", "Ben"]
    found = table("name,class,pre", "Anna,7a,2", "Sum,7a,9")
    assert students(found) == ["Anna", "Sum"]


def test_the_letters_of_one_absent_student_do_not_make_marks_answers() -> None:
    found = table("name,Q1,Q2,Q3", "Anna,1,0,1", "Ben,0,1,1", "Cara,a,a,a")
    assert not found.letters
    assert [(row.student, float(row.marks)) for row in found.taken] == [("Anna", 2), ("Ben", 2)]
    assert [place for place, _ in found.refused] == ["m.csv, line 4"]


def test_a_name_is_looked_for_before_a_number_of_the_answers() -> None:
    found = table("id,name,Q1", "1,Anna,1", "2,Ben,0")
    assert students(found) == ["Anna", "Ben"]
    assert students(table("id,Q1", "7,1", "9,0")) == ["7", "9"]


def test_anonymous_answers_to_two_forms_are_not_paired_by_their_numbers() -> None:
    head = "ID,Start time,Completion time,Email,Name,Total points,Points - Why?"
    quiz = "\n".join([head, *(f"{k},x,y,anonymous,,{k % 3},{k % 3}" for k in range(1, 8))]).encode()
    found = judged(quiz, quiz, forms=("pre", "post"))
    assert not {row.student for row in found.taken} - {""}
    assert found.lesson.pairs["class"].n == 0
    assert [flag.code for flag in found.flags] == ["no-code"]


def test_a_row_without_a_name_is_counted_and_listed_once() -> None:
    (flag,) = judged(b"name,pre,post\n,1,2\n,2,3\nAnna,1,1").flags
    assert flag.sentence.startswith("2 rows have no name")
    assert flag.files == ("marks.csv, line 2", "marks.csv, line 3")


def test_a_dash_beside_key_and_max_is_no_group() -> None:
    found = table("student,group,Q1,Q2", "KEY,-,A,B", "Anna,n,A,B", "Ben,o,B,B")
    assert students(found) == ["Anna", "Ben"]
    assert [float(row.marks) for row in found.taken] == [2, 1]


def test_who_is_called_key_beside_letters_is_named_as_a_student() -> None:
    found = table("student,Q1,Q2", "Key,A,B", "Anna,A,B", "Ben,B,B")
    assert students(found) == ["Key", "Anna", "Ben"]
    assert "“Key” counts as a student" in found.notes[0]


def test_figures_below_a_table_are_known_with_their_numbers() -> None:
    for word in ("Class mean", "Durchschnitt (n=2)", "Mean %", "Stdev"):
        found = table("name,pre,post", "Anna,2,5", "Ben,5,8", f"{word},3.5,6.5")
        assert students(found) == ["Anna", "Ben"], word


def test_excels_line_of_the_separator_is_none_of_the_heads_when_it_was_saved_again() -> None:
    for line in ("sep=;", "sep=;;;", '"sep=;"', "sep=; "):
        found = table(line, "name;pre;post", "Anna;2;5", "Ben;5;8")
        assert students(found) == ["Anna", "Ben"], line


def test_a_student_called_min_is_a_student_unless_other_figures_stand_there() -> None:
    lines = ("name,pre,post", "Anna,12,18", "Min,10,11", "Ben,8,20")
    assert students(table(*lines)) == ["Anna", "Min", "Ben"]
    assert students(table(*lines, "Mean,10,16", "SD,2,4")) == ["Anna", "Ben"]
