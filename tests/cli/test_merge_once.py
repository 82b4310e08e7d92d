"""`carts class --merge`: no student counts twice, whatever files are named."""

from __future__ import annotations

import json
import shutil
from itertools import permutations
from pathlib import Path
from typing import Any

import pytest
from click.testing import Result

from tests.cli.called import carts_class as carts


def school(folder: Path, name: str, step: int, *more: str, lesson: str = "force") -> Path:
    table, target = folder / f"{name}.csv", folder / f"{name}.json"
    rows = "".join(f"{name}{k},{k % 4},{(step * k) % 6},{k % 2}\n" for k in range(8 + step))
    table.write_text(f"student,pre (9),post (9),later (9)\n{rows}", encoding="utf-8")
    made = carts("--table", table, "--lesson", lesson, "--summary", target, *more)
    assert made.exit_code == 0, made.output
    return target


@pytest.fixture
def schools(tmp_path: Path) -> dict[str, Path]:
    found = {name: school(tmp_path, name, step) for step, name in enumerate("abc", 1)}
    for whole in ("ab", "bc"):
        found[whole] = tmp_path / f"{whole}.json"
        assert carts("--merge", *map(found.get, whole), "--summary", found[whole]).exit_code == 0
    return found


def students(result: Result) -> int:
    report: dict[str, Any] = json.loads(result.stdout)
    return int(report["lessons"][0]["forms"][0]["n"])


def test_the_same_summary_twice_counts_once(schools: dict[str, Path], tmp_path: Path) -> None:
    again = tmp_path / "again.json"
    shutil.copy(schools["a"], again)
    result = carts("--merge", schools["a"], schools["b"], again, "--json")
    assert (result.exit_code, students(result)) == (1, 9 + 10)
    assert result.stderr == (
        f"{again.as_posix()}: force: the same sums as in {schools['a'].as_posix()}; "
        "they count once\n"
    )
    assert json.loads(result.stdout)["files"]["counted"] == 2


def test_a_summary_with_marks_by_total_is_the_same_summary(
    schools: dict[str, Path], tmp_path: Path
) -> None:
    schools["a"].rename(plain := tmp_path / "plain.json")
    detailed = school(tmp_path, "a", 1, "--by-total")
    result = carts("--merge", plain, detailed, "--json")
    assert (result.exit_code, students(result)) == (1, 9)


@pytest.mark.parametrize("names", list(permutations(("a", "ab", "c"))))
def test_an_old_sum_among_its_parts_counts_and_its_parts_do_not(
    schools: dict[str, Path], names: tuple[str, ...]
) -> None:
    result = carts("--merge", *map(schools.get, names), "--json")
    assert (result.exit_code, students(result)) == (1, 9 + 10 + 11)
    assert f"a.json: force: {schools['ab'].as_posix()} is a sum that holds it" in result.stderr


def test_of_two_sums_with_a_school_in_common_one_counts(schools: dict[str, Path]) -> None:
    result = carts("--merge", schools["ab"], schools["bc"], "--json")
    assert (result.exit_code, students(result)) == (1, 9 + 10)
    assert "holds some of the same schools; not counted" in result.stderr


def test_a_sum_beside_others_counts_and_is_named(schools: dict[str, Path], tmp_path: Path) -> None:
    whole = tmp_path / "abc.json"
    result = carts("--merge", schools["ab"], schools["c"], "--json", "--summary", whole)
    assert (result.exit_code, students(result)) == (0, 9 + 10 + 11)
    (note,) = (one for one in json.loads(result.stdout)["notes"] if "sum of" in one)
    assert note.startswith(
        f"{schools['ab'].as_posix()} is a sum of 2 summaries. If one of them was made anew"
    )
    again = carts("--merge", whole, schools["b"], "--json")
    assert (again.exit_code, students(again)) == (1, 9 + 10 + 11)


def test_another_lesson_of_the_same_school_counts(schools: dict[str, Path], tmp_path: Path) -> None:
    other = school(tmp_path, "other", 1, lesson="energy")
    assert carts("--merge", schools["a"], other, "--json").exit_code == 0
