"""A table is saved as the reader's spreadsheet opens it, and what reads tables here takes both."""

from __future__ import annotations

from typing import Any

import pytest

from sim.classroom.tables.read import read_table as read_marks
from sim.cli.classroom.spreadsheet import parted_by
from sim.measured.sheet.table import read_table
from tests.web.scene.given.widget_site import in_node

SAVE = """const { forSpreadsheet } = await import(source + "/shared/spreadsheet.js");
give(data.languages.map((language) => forSpreadsheet(data.text, language)));"""
READINGS = "t (s),x_A (m),x_B (m)\r\n0,0.4,1.2\r\n0.04,0.4241,1.2\r\n0.08,-0.0000012,1.5e-7\r\n"


def saved(text: str, *languages: str) -> Any:
    return in_node(SAVE, {"text": text, "languages": languages})


def test_where_numbers_have_a_comma_cells_are_parted_by_semicolons() -> None:
    here, german, french, malay, unknown = saved(READINGS, "en-GB", "de", "fr-CA", "ms", "x!")
    assert here == malay == unknown == READINGS
    assert german == french
    assert german.split("\r\n")[:3] == [
        "t (s);x_A (m);x_B (m)", "0;0,4;1,2", "0,04;0,4241;1,2",
    ]  # fmt: skip


def test_a_text_stays_as_it_was_written() -> None:
    text = '\ufeffname,said,n\r\n"1.5","a, ""b"", 2.5",2.5\r\nv.A;w,"=1+1",\r\n'
    (german,) = saved(text, "de-AT")
    assert german == '\ufeffname;said;n\r\n"1.5";"a, ""b"", 2.5";2,5\r\n"v.A;w";"=1+1";\r\n'


@pytest.mark.parametrize("text", [READINGS, '\ufeffa,"b;c"\n"1.5",v;w\n-1.5e+3,1.5.2\n,\n', ""])
def test_the_command_writes_a_table_as_the_page_does(text: str) -> None:
    assert [parted_by(sign, text) for sign in ",;"] == saved(text, "en", "de")


@pytest.mark.parametrize("language", ["en", "de", "id"])
def test_readings_and_marks_are_read_as_they_were_saved(language: str) -> None:
    (text,) = saved(READINGS, language)
    assert [c.values for c in read_table(text).columns] == [
        c.values for c in read_table(READINGS).columns
    ]
    marks = "student,pre,post\r\nASTER-1,1.5,2\r\nBIRCH-2,0,2.5\r\n"
    (text,) = saved(marks, language)
    assert read_marks("m.csv", text.encode()) == read_marks("m.csv", marks.encode())
