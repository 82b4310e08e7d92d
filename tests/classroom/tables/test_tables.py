"""Tables as teachers have them: each kind of export, bad rows named by line, nothing evaluated."""

from __future__ import annotations

import random

import pytest

from sim.classroom.report.notes import notes_of
from sim.classroom.show.report_page import report_html
from sim.classroom.tables.heading_maximum import with_most
from sim.classroom.tables.layout import form_of, split_form
from sim.classroom.tables.marks import mark
from sim.classroom.tables.read import read_table
from tests.classroom.given.exported_tables import (
    GOOGLE,
    GOOGLE_ITEMS,
    MICROSOFT,
    MOODLE,
    MOODLE_GERMAN,
)
from tests.classroom.given.tables import csv, judged, reported


def rows(content: str | bytes) -> list[tuple[str, dict[str, float], float]]:
    """Students with their marks and totals."""
    raw = content.encode() if isinstance(content, str) else content
    return [
        (t.student, {k: float(v) for k, v in t.items.items() if v is not None}, float(t.marks))
        for t in read_table("marks.csv", raw).taken
    ]


@pytest.mark.parametrize("text", [MOODLE, MOODLE_GERMAN])
def test_moodles_results_are_read_as_they_come(text: str) -> None:
    found = rows(text)
    assert [(row[0], row[2]) for row in found] == [
        ("fox@school.example", 7.5), ("owl@school.example", 2.5),
    ]  # fmt: skip
    first, second = read_table("m.csv", text.encode()).taken
    assert set(map(float, first.most.values())) == {5}
    assert sorted(v is None for v in second.items.values()) == [False, True]


def test_an_attempt_that_was_not_handed_in_is_named_and_the_average_is_no_student() -> None:
    table = read_table("m.csv", MOODLE.encode())
    assert table.kind == "moodle"
    assert table.refused == (("m.csv, line 4", "this attempt was not handed in"),)


def test_googles_answers_are_read_as_they_come() -> None:
    assert rows(GOOGLE) == [("BLUE-FOX", {}, 7), ("RED-OWL", {}, 2)]
    fox = read_table("g.csv", GOOGLE.encode()).taken[0]
    assert (fox.of, fox.klass) == (10, "7a")
    assert rows(GOOGLE_ITEMS) == [
        ("BLUE-FOX", {"Which force?": 1}, 1), ("RED-OWL", {"Which force?": 0}, 0),
    ]  # fmt: skip


def test_microsofts_answers_are_read_as_they_come() -> None:
    assert rows(MICROSOFT) == [
        ("BLUE-FOX", {"Which force?": 1, "Why?": 3}, 4),
        ("RED-OWL", {"Which force?": 0, "Why?": 1}, 1),
    ]  # fmt: skip


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "cp1252"])
@pytest.mark.parametrize("delimiter", [",", ";", "\t"])
def test_every_usual_way_to_save_a_table_gives_the_same_marks(
    encoding: str, delimiter: str
) -> None:
    text = csv(("Schüler", "vorher", "nachher"), [["Jörg", "3.5", "4"]], delimiter).decode()
    if delimiter != ",":
        text = text.replace("3.5", "3,5")
    found = read_table("m.csv", text.encode(encoding)).taken
    assert [(t.student, t.form, float(t.marks)) for t in found] == [
        ("Jörg", "pre", 3.5), ("Jörg", "post", 4.0),
    ]  # fmt: skip


@pytest.mark.parametrize(
    "head",
    [
        "Nom;Classe;avant (20);après (20)",
        "Élève;classe;Prétest /20;Post-test /20",
        "eleve;groupe;avant (sur 20);apres (sur 20)",
        "Nombre;Grupo;antes (20);después (20)",
        "Alumno;Clase;Antes (máx. 20);Despues (de 20)",
        "Estudiante;grupo;puntuación antes /20;puntuación después /20",
    ],
)
def test_french_and_spanish_heads_are_a_test_before_and_one_after(head: str) -> None:
    rows = "Ana;B;7,5;12\nLuc;B;8;\nMoyenne;;7,75;12\n"
    table = read_table("m.csv", f"{head}\n{rows}".encode())
    assert [(t.student, t.form, float(t.marks), float(t.of or 0)) for t in table.taken] == [
        ("Ana", "pre", 7.5, 20), ("Ana", "post", 12, 20), ("Luc", "pre", 8, 20),
    ]  # fmt: skip
    assert {t.group or t.klass for t in table.taken} == {"B"}


@pytest.mark.parametrize(
    ("head", "times"),
    [("élève;moment;question;note", ("avant", "après")),
     ("alumno;momento;pregunta;nota", ("antes", "después"))],
)  # fmt: skip
def test_french_and_spanish_tables_have_a_row_for_each_answer(
    head: str, times: tuple[str, str]
) -> None:
    rows = "".join(f"Ana;{time};Q{k};{k % 2}\n" for time in times for k in (1, 2, 3))
    table = read_table("m.csv", f"{head}\n{rows}".encode())
    assert [(t.student, t.form, t.marks) for t in table.taken] == [
        ("Ana", "pre", 2), ("Ana", "post", 2),
    ]  # fmt: skip


def test_a_note_beside_a_mark_is_a_remark() -> None:
    table = read_table("m.csv", b"student,item,note,mark\nA,Q1,late,1\nA,Q2,,0\n")
    assert [dict(t.items) for t in table.taken] == [{"Q1": 1, "Q2": 0}]
    assert table.left_out == ("note",)


@pytest.mark.parametrize(
    "head",
    ["Nom;Prénom;État;Commencé le;Note/2,00;Q. 1 /1,00;Q. 2 /1,00",
     "Apellido(s);Nombre;Estado;Comenzado el;Calificación/2,00;P. 1 /1,00;P. 2 /1,00"],
)  # fmt: skip
def test_moodle_in_french_and_in_spanish(head: str) -> None:
    rows = "Roy;Luc;Terminé;3 mai;2,00;1,00;1,00\nSol;Ana;En cours;3 mai;-;-;-\n"
    table = read_table("m.csv", f"{head}\n{rows}".encode(), form="post")
    assert [(t.student, t.form, t.marks) for t in table.taken] == [("Luc Roy", "post", 2)]
    assert len(table.refused) == 1  # not handed in


def test_wide_and_long_tables_are_the_same_table() -> None:
    dice = random.Random(1)
    marks = {(f"s{k}", form, f"Q{i}"): dice.randint(0, 1)
             for k in range(12) for form in ("pre", "post") for i in range(3)}  # fmt: skip
    names = [f"s{k}" for k in range(12)]
    forms, items = ("pre", "post"), ("Q0", "Q1", "Q2")
    wide = csv(("student", *(f"{f}_{i}" for f in forms for i in items)),
               [[s, *(marks[s, f, i] for f in forms for i in items)] for s in names])  # fmt: skip
    by_test = csv(("student", "time", *items),
                  [[s, f, *(marks[s, f, i] for i in items)]
                   for s in names for f in forms])  # fmt: skip
    by_answer = csv(("student", "time", "item", "mark"),
                    [[s, f, i, m] for (s, f, i), m in marks.items()])  # fmt: skip
    lessons = [judged(table).lesson for table in (wide, by_test, by_answer)]
    assert lessons[0] == lessons[1] == lessons[2]
    assert lessons[0].pairs["class"].n == 12


def test_two_tables_are_two_tests_of_one_lesson() -> None:
    one, other = (csv(("student", "total (9)"), [[f"s{k}", (k * step) % 8] for k in range(9)])
                  for step in (1, 3))  # fmt: skip
    lesson = judged(one, other, forms=("pre", "post")).lesson
    assert list(lesson.forms) == ["pre", "post"]
    assert lesson.pairs["class"].n == 9
    assert lesson.pairs_of == 9


def test_a_row_key_turns_letters_into_marks_and_the_curves_of_options() -> None:
    dice, students = random.Random(9), []
    for k in range(40):
        able = k / 40
        students.append(
            [f"s{k}", *(key if dice.random() < able else dice.choice("ABCD") for key in "BADCABDC")]
        )
    head = ["student", *(f"Q{k}" for k in range(8))]
    form = reported(csv(head, [["KEY", *"BADCABDC"], *students]))["lessons"][0]["forms"][0]
    assert form["of"] == 8
    assert form["n"] == 40
    by_hand = {s[0]: sum(a == b for a, b in zip(s[1:], "BADCABDC", strict=True)) for s in students}
    assert {row["student"]: row["total"] for row in form["students"]} == by_hand
    right = next(c for c in form["items"][0]["choices"] if c["correct"])
    assert right["label"] == "B"
    assert right["curve"] == form["items"][0]["curve"]
    curves = [c["curve"] for c in form["items"][0]["choices"]]
    assert [sum(quarter) for quarter in zip(*curves, strict=True)] == pytest.approx([1] * 4)
    assert form["talk"]


def test_letters_without_a_key_are_counted_and_not_marked() -> None:
    rows_ = [[f"s{k}", "AB"[k % 2], "CD"[k % 2]] for k in range(8)]
    form = reported(csv(("student", "Q1", "Q2"), rows_))["lessons"][0]["forms"][0]
    assert (form["has_key"], form["of"]) == (False, 0)
    assert [c["count"] for c in form["items"][0]["choices"]] == [4, 4]


def test_one_column_for_each_test_is_its_total_whatever_it_is_called() -> None:
    rows_ = [[f"s{k}", "MF"[k % 2], 500 + k, k % 5, k % 7] for k in range(9)]
    head = ("ID", "Gender", "Math", "FCI_pre", "FCI_post")
    lesson = reported(csv(head, rows_), most=30)["lessons"][0]
    assert [(form["form"], form["of"], form["items"]) for form in lesson["forms"]] == [
        ("pre", 30, []), ("post", 30, []),
    ]  # fmt: skip
    assert lesson["gains"][0]["n"] == 9


def test_a_column_beside_totals_is_no_question() -> None:
    rows_ = [[f"s{k}", 14 + k % 3, 600 + k, k % 5, k % 7] for k in range(9)]
    report = reported(csv(("student", "age", "entrance", "pre", "post"), rows_))
    assert [form["form"] for form in report["lessons"][0]["forms"]] == ["pre", "post"]
    assert report["lessons"][0]["forms"][0]["items"] == []
    assert report["notes"][0].startswith("Columns that are not counted as marks: “age”, “entrance”")


def test_a_test_of_very_many_marks_is_drawn_with_a_few_ticks() -> None:
    rows_ = [[f"s{k}", k, k * 2] for k in range(9)]
    report = reported(csv(("student", "pre", "post"), rows_), most=10**30)
    assert 2 <= report_html(report).count('class="tick"') <= 13


@pytest.mark.parametrize(
    ("text", "value", "most"),
    [("7", 7, None), ("7,5", 7.5, None), ("7 / 10", 7, 10), ("50 %", 50, 100), ("-", None, None),
     (".5", 0.5, None), ("3,00/5,00", 3, 5)],
)  # fmt: skip
def test_marks_are_read_as_people_write_them(
    text: str, value: float | None, most: float | None
) -> None:
    found, of = mark(text)
    assert (found, of) == (value, most)


def test_headings_tell_the_most_marks_and_the_test() -> None:
    assert with_most("Q. 1 /1.00") == ("Q. 1", 1)
    assert with_most("pre (30)") == ("pre", 30)
    assert with_most("pre [of 30]") == ("pre", 30)
    assert with_most("Question 3") == ("Question 3", None)
    assert split_form("pre_Q1") == ("pre", "Q1")
    assert split_form("Q1 (post)") == ("post", "Q1")
    assert split_form("energy 3") == ("", "energy 3")
    assert form_of("前测") == "pre"
    assert notes_of([]) == []


@pytest.mark.parametrize("nobody", ["N/A", "n/a", "NULL", "None", "–"])
def test_a_row_without_a_name_is_nobodys_however_that_is_written(nobody: str) -> None:
    plain = csv(["Student", "Form", "q1", "q2"], [[nobody, "pre", "1", "0"], ["FOX", "pre", 1, 1]])
    assert [row[0] for row in rows(plain)] == ["", "FOX"]


def test_pairs_stand_in_the_order_of_their_cards() -> None:
    """2 before 10; 02 is a name of its own, and stands where it stood the last time."""
    names = ["FOX-10", "FOX-2", "FOX-1", "FOX-02"]
    rows = [(name, 3 + k, 6 + k) for k, name in enumerate(names)]
    (gain,) = reported(csv(("student", "pre", "post"), rows))["lessons"][0]["gains"]
    assert gain["students"] == ["FOX-1", "FOX-02", "FOX-2", "FOX-10"]
