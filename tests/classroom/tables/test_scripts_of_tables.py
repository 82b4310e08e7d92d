"""Tables typed on keyboards for Chinese, Arabic, Hindi or Tamil, and saved by a Windows of Taiwan.
Before, each mark of such a table was “no mark”, and its headings were signs that mean nothing.
"""

from __future__ import annotations

import pytest

from sim.classroom.tables.read import read_table

TABLE = "student,pre,post\nAnna,12.5,20\nBala,9,25\nChen,10,22\n"
WANTED = [
    ("Anna", "pre", 12.5), ("Anna", "post", 20), ("Bala", "pre", 9), ("Bala", "post", 25),
    ("Chen", "pre", 10), ("Chen", "post", 22),
]  # fmt: skip
TAIWAN = "姓名,前測,後測\n王小明,12.5,20\n陳怡君,9,25\n林志豪,10,22\n"


def taken(content: bytes) -> list[tuple[str, str, float]]:
    return [(t.student, t.form, float(t.marks)) for t in read_table("m.csv", content).taken]


@pytest.mark.parametrize("zero", "０٠۰०௦")
def test_figures_of_any_script_are_marks(zero: str) -> None:
    figures = str.maketrans({str(k): chr(ord(zero) + k) for k in range(10)})
    assert taken(TABLE.translate(figures).encode()) == WANTED


@pytest.mark.parametrize("point", "．٫")
def test_a_point_of_another_keyboard_is_a_point(point: str) -> None:
    assert taken(TABLE.replace(".", point).encode()) == WANTED


@pytest.mark.parametrize("comma", "，；،")
def test_a_comma_of_another_keyboard_parts_columns(comma: str) -> None:
    assert taken(TABLE.replace(",", comma).encode()) == WANTED


@pytest.mark.parametrize("comma", "，；،")
def test_such_a_comma_within_a_cell_parts_nothing(comma: str) -> None:
    text = TABLE.replace("Anna", f"Ann{comma} A").replace("Bala", f"Bala{comma} B")
    assert [name for name, *_ in taken(text.encode())][:4] == [f"Ann{comma} A"] * 2 + [
        f"Bala{comma} B"
    ] * 2


@pytest.mark.parametrize("encoding", ["big5", "cp950", "utf-8", "utf-16"])
def test_headings_and_names_of_a_taiwanese_windows_are_read(encoding: str) -> None:
    found = taken(TAIWAN.encode(encoding))
    assert [name for name, *_ in found][::2] == ["王小明", "陳怡君", "林志豪"]
    assert [row[1:] for row in found] == [row[1:] for row in WANTED]
