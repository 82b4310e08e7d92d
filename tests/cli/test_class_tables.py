"""`carts class --table`: exit codes, what is named, and which options do not go together."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main
from tests.classroom.given.makers import bank, random_class, sources
from tests.cli.called import carts_class as carts

TABLE = "student,group,pre,post\n" + "\n".join(
    f"s{k},{'ab'[k % 2]},{k % 5},{2 + k % 7}" for k in range(16)
)


@pytest.fixture
def marks(tmp_path: Path) -> Path:
    path = tmp_path / "mechanics.csv"
    path.write_text(TABLE, encoding="utf-8")
    return path


def test_a_table_gives_the_report_of_a_lesson_with_its_name(marks: Path) -> None:
    result = carts("--table", marks, "--max", 10, "--json")
    assert result.exit_code == 0, result.output
    report = json.loads(result.stdout)
    assert report["lessons"][0]["lesson"] == "mechanics"
    assert report["groups"] == ["a", "b"]
    assert report["files"]["counted"] == 16
    assert {"alpha", "delta"} <= report["lessons"][0]["forms"][0].keys()


def test_people_get_text_and_files(marks: Path, tmp_path: Path) -> None:
    html, table = tmp_path / "r.html", tmp_path / "r.csv"
    result = carts("--table", marks, "--max", 10, "--html", html, "--csv", table)
    assert result.exit_code == 0, result.output
    assert "16 of 16 rows of the table are counted." in result.stdout
    assert "Adjusted for the start (ANCOVA)" in html.read_text(encoding="utf-8")
    assert table.read_text(encoding="utf-8-sig").count("\n") == 33


def test_a_bad_row_is_named_and_the_rest_is_reported(marks: Path) -> None:
    marks.write_text(f"{TABLE}\nlast,a,many,3\n", encoding="utf-8")
    result = carts("--table", marks, "--json")
    assert result.exit_code == 1
    assert result.stderr.strip() == "mechanics.csv, line 18: pre: “many” is no mark"
    assert json.loads(result.stdout)["files"]["counted"] == 16


def test_two_tables_are_before_and_after(tmp_path: Path) -> None:
    for name, step in (("quiz-1", 1), ("quiz-2", 3)):
        lines = [f"s{k},{k * step % 8}" for k in range(9)]
        (tmp_path / f"{name}.csv").write_text("\n".join(["student,total (9)", *lines]))
    result = carts("--table", f"pre={tmp_path / 'quiz-1.csv'}", "--table",
                   f"post={tmp_path / 'quiz-2.csv'}", "--json")  # fmt: skip
    assert result.exit_code == 0, result.output
    lesson = json.loads(result.stdout)["lessons"][0]
    assert (lesson["lesson"], lesson["gains"][0]["n"]) == ("quiz-1", 9)


def test_tables_of_one_name_are_told_apart_by_their_folders(tmp_path: Path) -> None:
    for folder, mark in (("7a", 1), ("7b", 0)):
        rows = "".join(f"S{folder}{k},{mark},{k % 2}\n" for k in range(8))
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "quiz.csv").write_text(f"student,pre Q1,post Q1\n{rows}")
    result = carts("--table", str(tmp_path / "7a/quiz.csv"), "--table",
                   str(tmp_path / "7b/quiz.csv"), "--group", "new=7a/*", "--group", "usual=7b/*",
                   "--json")  # fmt: skip
    assert result.exit_code == 0, result.output
    (before, _) = json.loads(result.stdout)["lessons"][0]["forms"]
    assert {row["group"]: row["total"] for row in before["students"]} == {"new": 1, "usual": 0}


def test_rows_without_a_name_in_tables_of_one_name_are_no_pairs(tmp_path: Path) -> None:
    for folder in ("before", "after"):
        (tmp_path / folder).mkdir()
        named = "".join(f"S{k},{k % 2}\n" for k in range(6))
        (tmp_path / folder / "quiz.csv").write_text(f"student,Q1\n{named},1\n,0\n")
    result = carts("--table", f"pre={tmp_path}/before/quiz.csv", "--table",
                   f"post={tmp_path}/after/quiz.csv", "--json")  # fmt: skip
    assert result.exit_code == 0, result.output
    (gain,) = json.loads(result.stdout)["lessons"][0]["gains"]
    assert gain["n"] == 6


def test_tables_without_groups_are_put_into_them_by_name(tmp_path: Path) -> None:
    for name in ("7a", "7b"):
        lines = [f"{name}-{k},{k % 4},{k % 6}" for k in range(9)]
        (tmp_path / f"{name}.csv").write_text("\n".join(["student,pre,post", *lines]))
    result = carts("--table", tmp_path / "7a.csv", "--table", tmp_path / "7b.csv", "--max", 9,
                   "--group", "new=7a*", "--group", "usual=7b*", "--json")  # fmt: skip
    assert result.exit_code == 0, result.output
    assert json.loads(result.stdout)["lessons"][0]["comparison"]["groups"] == ["new", "usual"]


def test_what_is_no_table_is_named(tmp_path: Path) -> None:
    book = tmp_path / "marks.xlsx"
    book.write_bytes(b"PK\x03\x04and so on")
    result = carts("--table", book)
    assert result.exit_code == 1
    assert "save it as CSV" in result.stderr


@pytest.mark.parametrize(
    "words",
    [
        ("--table", "MARKS", "MARKS"),
        ("--table", "MARKS", "--key", "MARKS"),
        ("--table", "no-such.csv"),
        ("--table", "MARKS", "--max", "much"),
        ("--max", "9", "MARKS"),
        (),
    ],
)
def test_calls_that_cannot_be_meant_end_with_2(marks: Path, words: tuple[str, ...]) -> None:
    assert carts(*(str(marks) if word == "MARKS" else word for word in words)).exit_code == 2


def test_a_table_in_a_folder_of_answer_files_is_not_passed_over_in_silence(tmp_path: Path) -> None:
    for source in sources(random_class(bank(6), 6)):
        (tmp_path / source.name).write_bytes(source.content)
    (tmp_path / "marks.csv").write_text("student,pre\nANNA,3\n", encoding="utf-8")
    told = CliRunner().invoke(main, ["class", str(tmp_path)])
    assert f"{tmp_path.as_posix()}/marks.csv is a table, and read by --table alone" in told.stderr
    assert told.exit_code == 0


def test_a_sentence_of_a_group_says_which_form_and_group_it_is_of(tmp_path: Path) -> None:
    """Four lines “2 students: no statistics for fewer than 5.” could not be told apart."""
    table = tmp_path / "marks.csv"
    rows = "\n".join(f"S{k},a,{k},{k + 1}" for k in range(2))
    table.write_text(f"student,group,pre (10),post (10)\n{rows}\n", encoding="utf-8")
    told = CliRunner().invoke(main, ["class", "--table", str(table)]).stdout
    assert "- pre, " in told and "- post, " in told
