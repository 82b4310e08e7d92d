"""Tables as spreadsheets save them: a title above the headings, two columns for a name, and the
encoding of a Chinese Windows. Before, marks were added up that belong to two tests.
"""

from __future__ import annotations

import pytest

from sim.classroom.tables.cells import TableError
from sim.classroom.tables.read import read_table

MARKS = [("Anna Ang", 12, 20), ("Bala", 9, 25), ("Chen", 15, 22)]
ROWS = "".join(f"{name},{before},{after}\n" for name, before, after in MARKS)
WANTED = [
    (name, form, mark)
    for name, *both in MARKS
    for form, mark in zip(("pre", "post"), both, strict=True)
]


def taken(text: str | bytes) -> list[tuple[str, str, float]]:
    raw = text if isinstance(text, bytes) else text.encode()
    return [(t.student, t.form, float(t.marks)) for t in read_table("m.csv", raw).taken]


@pytest.mark.parametrize(
    "above",
    [
        "Class 10b physics,,\n",
        "Class 10b physics\n",
        "Class 10b physics\n\nMarch 2026,,\n",
        "Class:,10b,\n",
        "Teacher,Mr Tan,\nRoom,12,\n",
    ],
)
@pytest.mark.parametrize("delimiter", [",", ";", "\t"])
def test_headings_are_found_below_a_title(above: str, delimiter: str) -> None:
    text = f"{above}student,pre,post\n{ROWS}".replace(",", delimiter)
    assert taken(text) == WANTED


@pytest.mark.parametrize(
    "heads",
    ["Last name,First name", "Surname,Given name", "Nachname,Vorname", "Nom,Prénom",
     "Apellidos,Nombre", "姓,名"],
)  # fmt: skip
def test_two_of_one_family_are_two_students(heads: str) -> None:
    found = taken(f"{heads},pre,post\nTan,Mei,3,8\nTan,Jun,5,9\n")
    assert [name for name, form, _ in found if form == "pre"] == ["Tan Mei", "Tan Jun"]


def test_a_table_of_answers_keeps_two_of_one_family_apart() -> None:
    text = "Vorname,Nachname,item,mark\nMei,Tan,Q1,1\nJun,Tan,Q1,0\n"
    table = read_table("m.csv", text.encode())
    assert [t.student for t in table.taken] == ["Tan Mei", "Tan Jun"]
    assert not table.refused


def test_a_first_column_of_words_names_students_whatever_it_is_called() -> None:
    assert taken(f"Schülerliste,pre,post\n{ROWS}") == WANTED
    assert taken(f",pre,post\n{ROWS}") == WANTED
    assert {name for name, *_ in taken("Age,pre,post\nnine,3,8\nten,5,9\n")} == {""}


def test_a_table_without_headings_is_refused_and_numbered_questions_are_not() -> None:
    with pytest.raises(TableError, match="name the columns"):
        read_table("m.csv", ROWS.encode())
    assert len(taken("Kind,1,2,3\nAnna,1,0,1\nBala,0,0,1\n")) == 2
    assert len(taken("Kind,2,5,9\nAnna,1,0,1\nBala,0,0,1\n")) == 2


def test_headings_and_names_of_a_chinese_windows_are_read() -> None:
    text = "姓名,前测,后测\n李雷,12,20\n韩梅梅,9,25\n王婷,15,22\n"
    assert taken(text.encode("gbk")) == taken(text)
    assert taken(text)[0] == ("李雷", "pre", 12)
