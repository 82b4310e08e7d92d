"""A file becomes rows and cells as the spreadsheet meant; a broken row takes no other along."""

from __future__ import annotations

import time

import pytest

from sim.classroom.tables.cells import Broken, TableRow, rows_of


def cells(text: str) -> list[tuple[str, ...]]:
    return [row.cells for row in rows_of(text.encode()) if isinstance(row, TableRow)]


@pytest.mark.parametrize("told", ["", "sep=;\n"])
def test_questions_full_of_commas_do_not_hide_the_semicolons(told: str) -> None:
    head = "Name;Which of a, b, c, d is it?;Why, and when, and where?"
    assert cells(f"{told}{head}\nAnna;1,5;0\nBen;0;1,5") == [
        tuple(head.split(";")), ("Anna", "1,5", "0"), ("Ben", "0", "1,5"),
    ]  # fmt: skip


@pytest.mark.parametrize("sign", [",", ";", "\t", "|"])
def test_the_sign_after_sep_parts_the_cells_and_its_line_counts(sign: str) -> None:
    rows = list(rows_of(f"sep={sign}\r\nname{sign}pre, post; later\r\nAnna{sign}1".encode()))
    assert [row.line for row in rows] == [2, 3]
    assert rows[1] == TableRow(3, ("Anna", "1"))


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("told", ["", "sep=;"])
def test_every_end_of_a_line_is_one(end: str, told: str) -> None:
    lines = [*([told] if told else []), "name;pre", "Anna;1", "Ben;2"]
    assert cells(end.join(lines)) == [("name", "pre"), ("Anna", "1"), ("Ben", "2")]


def test_a_quotation_mark_that_does_not_close_costs_its_own_line_only() -> None:
    for after in ("", '\n"Eva",3'):
        found = list(rows_of(f'name,pre\nA,1\n"Bob,1\nC,0\nD,1{after}'.encode()))
        assert [row.line for row in found if isinstance(row, Broken)] == [3]
        names = [row.cells[0] for row in found if isinstance(row, TableRow)]
        assert names == ["name", "A", "C", "D", *(["Eva"] if after else [])]


def test_a_cell_may_hold_lines_and_the_next_row_knows_its_own() -> None:
    rows = list(rows_of(b'name,why\n"Anna","so\nand so"\nBen,x'))
    assert rows[1:] == [TableRow(2, ("Anna", "so\nand so")), TableRow(4, ("Ben", "x"))]


def test_very_many_open_quotation_marks_are_named_in_a_short_time() -> None:
    text = "name,pre\n" + 'a","x\n' * 5_000
    begun = time.process_time()
    assert sum(isinstance(row, Broken) for row in rows_of(text.encode())) == 5_000
    assert time.process_time() - begun < 10
