"""The report on a table has the numbers of the report on its files, on every backend."""

from __future__ import annotations

import json
import shutil
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import pytest

from sim.country.schema import LATER
from sim.lesson.handin import encode
from tests.classroom.given.class_reports import WHO, without
from tests.classroom.given.makers import bank, form, keys
from tests.cli.called import as_json as reported
from tests.country.class_command import carts, table
from tests.country.school import KEY, lay, school_files

SMALL = bank(4)
NOT_IN_A_TABLE = ("words", "curves", "reasons", "comparisons", "clustered", "typed")
"""What is one student's, and what only reports on sums hold."""


def numbers(report: dict[str, Any]) -> Any:
    """All that can be equal: no names; without a key a report on files counts nobody as sure."""
    lessons = without(report, (*WHO, *NOT_IN_A_TABLE))["lessons"]
    for lesson in lessons:
        for part in lesson["forms"]:
            for item in part["items"]:
                item["choices"] = [
                    {k: v for k, v in choice.items() if k != "sure" or part["has_key"]}
                    for choice in item["choices"]
                ]
    return lessons


GROUPS = ("--group", "usual=b*/*", "--group", "new=a*/*")


@pytest.mark.slow
@pytest.mark.parametrize("words", [(), GROUPS, (*GROUPS[:2], "--group", "new=a1/*")])
def test_the_numbers_of_a_table_are_those_of_its_files(
    school: Path, words: tuple[str, ...]
) -> None:
    whole = json.loads(carts(school, *words, "--json").stdout)
    target = school.parent / "grouped"
    carts(school, *words, "--parquet", target)
    mine = reported("--table", target)
    assert numbers(mine) == numbers(whole)
    assert mine["groups"] == whole["groups"]
    assert (mine["files"]["read"], mine["files"]["counted"]) == (
        whole["files"]["read"], whole["files"]["counted"])  # fmt: skip
    assert any(lesson["gains"] for lesson in mine["lessons"])


@pytest.mark.parametrize("seed", range(8))
def test_whatever_happens_to_files_the_numbers_are_equal(seed: int, tmp_path: Path) -> None:
    files = school_files(seed, 6 + 3 * seed)
    place = lay(tmp_path / "files", [*files, *([KEY] if seed % 4 else [])])
    whole = json.loads(carts(place, "--json").stdout)
    assert numbers(reported("--table", table(place))) == numbers(whole)


@pytest.mark.slow
def test_tables_of_many_schools_are_one_report(school: Path, school_report: dict[str, Any]) -> None:
    parts = []
    for name in ("a1", "a2", "b1", "b2"):
        lay(school.parent / name / "x", [])
        shutil.copytree(school / name, school.parent / name / "files")
        shutil.copy(school / "key.json", school.parent / name / "key.json")
        parts.append(table(school.parent / name))
    words = [word for part in parts for word in ("--table", part)]
    assert numbers(reported(*words)) == numbers(school_report)


def test_a_single_part_and_a_key_by_hand_are_the_folder(
    school: Path, school_table: Path, school_report: dict[str, Any], tmp_path: Path
) -> None:
    lone = tmp_path / "lone"
    lone.mkdir()
    shutil.copy(school_table / "answers-0001.parquet", lone / "x.parquet")
    mine = reported("--table", lone / "x.parquet", "--key", school / "key.json")
    assert mine == school_report


@pytest.mark.slow
def test_without_its_key_a_table_still_has_all_marks(
    school_table: Path, school_report: dict[str, Any]
) -> None:
    whole = school_report
    for path in school_table.glob("key-*.json"):
        path.unlink()
    mine = reported("--table", school_table)
    for ours, theirs in zip(mine["lessons"][0]["forms"], whole["lessons"][0]["forms"], strict=True):
        assert [g.get("mean") for g in ours["groups"]] == [g.get("mean") for g in theirs["groups"]]
        for one, other in zip(ours["items"], theirs["items"], strict=True):
            for name in ("id", "label", "n", "right", "wrong", "empty", "difficulty",
                         "discrimination", "point_biserial"):  # fmt: skip
                assert one[name] == other[name], name


def test_the_sums_of_a_table_can_be_handed_on(school: Path, school_table: Path) -> None:
    sums = [school.parent / "files.json", school.parent / "table.json"]
    carts(school, "--summary", sums[0])
    carts("--table", school_table, "--summary", sums[1])
    one, other = (reported("--merge", path)["lessons"] for path in sums)
    assert one == other


def test_a_table_of_which_a_part_is_missing_is_refused(school_table: Path) -> None:
    part = school_table / "answers-0001.parquet"
    rows = pq.read_table(part)
    pq.write_table(rows.slice(0, rows.num_rows - 3), part)
    result = carts("--table", part)
    assert result.exit_code == 1
    assert "rows are there" in result.stderr


def test_a_table_from_before_a_column_was_added_is_read(
    school_table: Path, school_report: dict[str, Any]
) -> None:
    for part in school_table.glob("*.parquet"):
        pq.write_table(pq.read_table(part).drop_columns(list(LATER)), part)
    older = reported("--table", school_table)
    for one, other in zip(older["lessons"], school_report["lessons"], strict=True):
        for then, today in zip(one["forms"], other["forms"], strict=True):
            (row,), (now,) = then["predictions"], today["predictions"]
            assert (row["n"], row["again"]) == (now["n"] + now["again"], 0)
            assert now["again"]


@pytest.mark.parametrize("older", ["a-older", "z-older"])
def test_older_and_newer_parts_in_one_folder_are_one_table(
    older: str, school_table: Path, school_report: dict[str, Any]
) -> None:
    """Whichever of them is read first."""
    (part,) = school_table.glob("*.parquet")
    rows = pq.read_table(part)
    newer = {one["sheet"] for one in rows.to_pylist() if one["again"]}
    of_newer = [sheet in newer for sheet in rows["sheet"].to_pylist()]
    part.unlink()
    pq.write_table(rows.filter(of_newer), school_table / "m-newer.parquet")
    early = rows.filter([not one for one in of_newer]).drop_columns(list(LATER))
    pq.write_table(early, school_table / f"{older}.parquet")
    assert reported("--table", school_table) == school_report


def test_one_table_given_twice_is_refused(school_table: Path, tmp_path: Path) -> None:
    shutil.copytree(school_table, tmp_path / "again")
    result = carts("--table", school_table, "--table", tmp_path / "again")
    assert result.exit_code == 1
    assert "does it stand here twice?" in result.stderr


def test_another_backend_by_its_address_gives_the_same(
    school: Path, school_table: Path, school_report: dict[str, Any], tmp_path: Path
) -> None:
    import duckdb

    file = tmp_path / "warehouse.duckdb"
    with duckdb.connect(str(file)) as warehouse:
        warehouse.execute(
            f"create table answers as select * from '{school_table.as_posix()}/*.parquet'"
        )
    mine = reported("--table", "answers", "--backend", f"duckdb://{file}",
                    "--key", school / "key.json")  # fmt: skip
    assert mine == school_report


@pytest.mark.parametrize("name", ["answers [2025]", "what? all*", "a [b"])
def test_a_table_is_read_from_the_folder_that_it_was_written_to(
    school_table: Path, name: str
) -> None:
    """Brackets and stars in its name are no pattern."""
    named = school_table.rename(school_table.with_name(name))
    mine = reported("--table", named)
    assert mine["files"]["counted"] > 0


SPARK = "" if find_spec("pyspark") and shutil.which("java") else "pyspark or Java is not installed"


@pytest.mark.slow
@pytest.mark.skipif(bool(SPARK), reason=SPARK)
def test_spark_gives_the_same(school: Path) -> None:
    target = table(school, *GROUPS)
    assert numbers(reported("--table", target, "--backend", "spark://local")) == numbers(
        reported("--table", target)
    )


def test_two_codes_under_one_code_word_are_not_counted_from_a_table_either(tmp_path: Path) -> None:
    pre = form("pre", SMALL)
    lines = [f"FOX {encode([4] * 4, [k] * 4, f'pre:{pre.hash}')}" for k in (1, 2)]
    lines.append(f"OWL {encode([4] * 4, [3] * 4, f'pre:{pre.hash}')}")
    (tmp_path / "codes.txt").write_text("\n".join(lines))
    (tmp_path / "key.json").write_text(keys(SMALL, ["pre"]))
    carts(tmp_path / "key.json", "--codes", tmp_path / "codes.txt", "--parquet", tmp_path / "table")
    report = reported("--table", tmp_path / "table", "--key", tmp_path / "key.json")
    assert report["files"]["counted"] == 1
    assert [flag["code"] for flag in report["flags"]] == ["doubled-id"]
