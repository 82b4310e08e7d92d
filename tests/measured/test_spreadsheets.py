"""What spreadsheets make of readings: workbooks, remarks beside them, numbers turned into dates."""

from __future__ import annotations

import io
import zipfile
from base64 import b64encode

import pytest

from sim.bridge.measured_answer import measured_answer
from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured
from sim.measured.zipped import texts_of
from tests.measured.heard import heard
from tests.measured.written_films import A, B, T


def table(heads: str, remark: str = "", at: int = 20, place: int = 3) -> str:
    lines = [heads]
    for k, row in enumerate(zip(T, A, B, strict=True)):
        cells = [f"{value:.4f}".replace(".", ",") for value in row]
        cells.insert(place, remark if k == at else "")
        lines.append(";".join(cells))
    return "\n".join(lines)


def packed(*names: str) -> bytes:
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as pack:
        for name in names:
            pack.writestr(name, "t,x_A,x_B")
    return made.getvalue()


@pytest.mark.parametrize(
    "content",
    [
        packed("[Content_Types].xml", "xl/workbook.xml", "xl/worksheets/sheet1.xml"),
        packed("mimetype", "content.xml"),
        packed("Index/Document.iwa", "preview.csv"),
        b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(600),
    ],
    ids=["xlsx", "ods", "numbers", "xls"],
)
def test_a_workbook_is_called_one_and_how_to_save_it_is_said(content: bytes) -> None:
    with pytest.raises(ReadingError) as caught:
        texts_of(content)
    (fault,) = caught.value.faults
    assert "workbook" in fault.reason and "save its sheet as CSV" in fault.hint
    header, _ = measured_answer({"do": "unzip", "zip": b64encode(content)})
    assert "workbook" in heard(header)["refused"][0]["reason"]


@pytest.mark.parametrize("at", [0, 20], ids=["in the first row", "later"])
@pytest.mark.parametrize(
    ("heads", "place"),
    [
        ("Zeit (s);x_A (m);x_B (m);Bemerkung", 3),
        ("Notes;t;x_A;x_B", 0),
        ("t;left;remark;right", 2),
    ],
)
def test_a_column_of_remarks_is_left_out(heads: str, place: int, at: int) -> None:
    found = read_measured([table(heads, "hit here", at, place)])
    assert found.tracks[0].value == pytest.approx(A, abs=1e-4)
    assert found.tracks[1].value == pytest.approx(B, abs=1e-4)


@pytest.mark.parametrize(("heads", "column"), [("t;x_A;x_B", "x_A"), ("t;left;right", "left")])
def test_a_word_among_readings_is_refused_with_its_column(heads: str, column: str) -> None:
    lines = table(heads).splitlines()
    lines[6] = "0,0833;near;0,9"
    with pytest.raises(ReadingError) as caught:
        read_measured(["\n".join(lines)])
    (fault,) = caught.value.faults
    assert fault.line == 7
    assert fault.reason == f"“near” is not a number (column {column})"


DATES = ("Jan 62", "01. Mrz", "02.Mai", "1-Feb", "3. Dez", "févr. 85", "01.02.2026", "1月2日")


@pytest.mark.parametrize("date", DATES)
def test_a_number_that_was_made_a_date_is_told_as_such(date: str) -> None:
    lines = table("t;x_A;x_B").splitlines()
    lines[6] = f"0,0833;{date};0,9"
    with pytest.raises(ReadingError) as caught:
        read_measured(["\n".join(lines)])
    (fault,) = caught.value.faults
    assert fault.line == 7 and f"“{date}” is a date" in fault.reason
    assert "as text" in fault.hint and "decimal sign" in fault.hint


def test_a_table_of_nothing_but_dates_is_told_as_such() -> None:
    rows = [f"{k % 28 + 1}. Jan;{k % 28 + 1}. Mrz;Jan {k + 30}" for k in range(40)]
    with pytest.raises(ReadingError) as caught:
        read_measured(["\n".join(["t;x_A;x_B", *rows])])
    assert caught.value.faults[0].line == 2
    assert "is a date" in caught.value.faults[0].reason
