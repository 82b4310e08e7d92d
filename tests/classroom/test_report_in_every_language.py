"""The whole report is told in the teacher's language: page, command, tables, messages."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from sim.classroom.show.class_csv import items_csv, students_csv
from sim.classroom.show.report_page import report_html
from sim.classroom.show.standalone import standalone
from sim.cli import main
from sim.cli.classroom.text import report_as_text
from sim.pages.language import words
from tests.classroom.given.everything import (
    Blanked,
    a_class,
    left_in_english,
    of_everything,
    texts_of,
)
from tests.classroom.given.tables import csv, reported


@cache
def tables() -> list[dict[str, Any]]:
    wrong = [["A-9", "z", 2], ["", 3, 4], ["A-1", 5, 6], ["A-1", 7, 8]]
    rows = [[f"A-{k}", 8 + k % 5, 12 + k % 7] for k in range(12)]
    return [
        reported(csv(["student", "pre", "post"], [*rows, *wrong])),
        reported(csv(["student", "pre"], rows), csv(["student", "t1", "t2"], wrong)),
    ]


def test_the_class_of_this_test_meets_every_part_of_a_report() -> None:
    forms = [form for lesson in of_everything()["lessons"] for form in lesson["forms"]]
    for part in ("beliefs", "talk", "predictions", "own_runs", "words", "sentences", "unread"):
        assert any(form[part] for form in forms), part
    assert any(item["tries"] for form in forms for item in form["items"])
    assert any(item["changed"] for form in forms for item in form["items"])
    assert len({flag["code"] for flag in of_everything()["flags"]}) >= 6
    assert any(lesson["topics"] for lesson in of_everything()["lessons"])
    assert any(lesson["comparison"] for lesson in of_everything()["lessons"])
    assert len(of_everything()["files"]["refused"]) == 3


@pytest.mark.parametrize("made", [report_html, report_as_text])
def test_nothing_of_a_report_is_said_outside_the_catalogues(made: Any) -> None:
    """In a language of blanks only names are left, also inside of sentences."""
    blanked = Blanked()
    for one in (of_everything(), *tables()):
        told = "\n".join(texts_of(f">{made(one, blanked)}<"))
        assert left_in_english(told) == set()


@pytest.mark.parametrize("language", ["ms", "ta", "zh-Hans"])
def test_every_sentence_of_the_report_differs_from_the_english_one(language: str) -> None:
    english, here = (
        {
            text
            for text in texts_of(standalone([of_everything()], words(one), one))
            if left_in_english(text)
        }
        for one in ("en", language)
    )
    assert len(english) > 120
    assert english & here == set()


def test_tables_of_a_spreadsheet_have_headings_in_the_language() -> None:
    for made in (students_csv, items_csv):
        english, malay = (made(of_everything(), words(one)).splitlines()[0] for one in ("en", "ms"))
        assert not {*english.split(",")} & {*malay.split(",")} - {'"item"'}


def test_the_command_tells_everything_in_the_language_that_is_asked_for(tmp_path: Path) -> None:
    for source in a_class():
        (tmp_path / source.name).write_bytes(source.content)
    page = tmp_path / "out.htm"
    call = ["class", str(tmp_path), "--group", "A=*A-*", "--group", "B=*B-*", "--html", str(page)]
    english, malay = (CliRunner().invoke(main, [*call, "--language", one]) for one in ("en", "ms"))
    assert english.exit_code == malay.exit_code == 1  # three files are refused
    told = {line for line in english.output.splitlines() if left_in_english(line)}
    assert len(told) > 40
    assert told & {*malay.output.splitlines()} == set()
    assert '<html lang="ms">' in page.read_text(encoding="utf-8")
