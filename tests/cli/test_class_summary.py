"""`carts class --summary` and `--merge`: schools hand on sums, and somebody adds them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from tests.classroom.given.makers import bank, keys, random_class, sources
from tests.cli.called import carts_class as carts

BANK = bank(6)


@pytest.fixture
def schools(tmp_path: Path) -> Path:
    for name, seed in (("a", 1), ("b", 2), ("c", 3)):
        (tmp_path / name).mkdir()
        for source in sources(random_class(BANK, 9, seed=seed, prefix=name)):
            (tmp_path / name / source.name).write_bytes(source.content)
    (tmp_path / "key.json").write_text(keys(BANK), encoding="utf-8")
    return tmp_path


def summaries(schools: Path, *more: str) -> list[Path]:
    paths = [schools / f"{name}.json" for name in "abc"]
    for path in paths:
        made = carts(path.with_suffix(""), "--key", schools / "key.json", "--summary", path, *more)
        assert made.exit_code == 0, made.output
    return paths


def test_merged_summaries_are_the_report_on_all_files(schools: Path) -> None:
    result = carts("--merge", *summaries(schools, "--by-total"), "--json")
    assert result.exit_code == 0, result.output
    mine = json.loads(result.stdout)
    folders = [schools / name for name in "abc"]
    whole = json.loads(carts(*folders, "--key", schools / "key.json", "--json").stdout)
    assert mine["files"] | {"read": 3, "counted": 3} == mine["files"]
    for ours, theirs in zip(mine["lessons"][0]["forms"], whole["lessons"][0]["forms"], strict=True):
        for name in ("form", "n", "of", "alpha", "delta", "groups"):
            assert ours[name] == theirs[name]
        for one, other in zip(ours["items"], theirs["items"], strict=True):
            assert {k: one[k] for k in other} == other
    gain, theirs_ = mine["lessons"][0]["gains"][0], whole["lessons"][0]["gains"][0]
    for name in ("n", "pre", "post", "gain", "gain_of_students", "change", "wilcoxon", "d"):
        assert gain[name] == theirs_[name]


def test_sums_of_sums_are_the_same_again(schools: Path) -> None:
    a, b, c = summaries(schools)
    two = schools / "two.json"
    assert carts("--merge", a, b, "--summary", two).exit_code == 0
    at_once, in_steps = (
        json.loads(carts("--merge", *paths, "--json").stdout)["lessons"]
        for paths in ([a, b, c], [c, two])
    )
    assert at_once == in_steps


def test_people_read_the_sum_as_any_report(schools: Path) -> None:
    html = schools / "r.html"
    result = carts("--merge", *summaries(schools), "--html", html)
    assert "3 of 3 summaries are counted." in result.stdout
    assert "Hake" in html.read_text(encoding="utf-8")


def test_small_groups_are_withheld_and_said_to_be(schools: Path) -> None:
    path = schools / "s.json"
    result = carts(schools, "--key", schools / "key.json", "--summary", path,
                   "--group", "few=a/*-1.carts.json", "--group", "rest=b/*",
                   "--group", "rest=c/*", "--group", "left=a/*")  # fmt: skip
    assert "too small and withheld" in result.stderr
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    assert found["groups"] == ["rest", "left"]


def test_a_table_hands_on_sums_too(tmp_path: Path) -> None:
    for name, step in (("a", 1), ("b", 5)):
        lines = [f"{name}{k},{k % 4},{step * k % 6}" for k in range(9)]
        (tmp_path / f"{name}.csv").write_text("\n".join(["student,pre (9),post (9)", *lines]))
        assert carts("--table", tmp_path / f"{name}.csv", "--lesson", "force", "--summary",
                     tmp_path / f"{name}.json").exit_code == 0  # fmt: skip
    result = carts("--merge", tmp_path / "a.json", tmp_path / "b.json", "--json")
    (lesson,) = json.loads(result.stdout)["lessons"]
    assert (lesson["lesson"], lesson["gains"][0]["n"]) == ("force", 18)


def test_the_name_of_a_table_is_not_handed_on(tmp_path: Path) -> None:
    table, target = tmp_path / "7a-of-a-teacher.csv", tmp_path / "a.json"
    table.write_text("student,Q1\n" + "".join(f"s{k},{k % 2}\n" for k in range(9)))
    result = carts("--table", table, "--summary", target)
    assert result.exit_code == 2
    assert "--lesson NAME" in result.stderr
    assert not target.exists()


def test_what_is_no_summary_is_named_and_the_others_are_added(schools: Path) -> None:
    a, b, _ = summaries(schools)
    b.write_text("[]", encoding="utf-8")
    result = carts("--merge", a, b, "--json")
    assert result.exit_code == 1
    assert result.stderr.startswith(f"{b.as_posix()}: this is no summary")
    assert json.loads(result.stdout)["files"]["counted"] == 1


@pytest.mark.parametrize(
    "words",
    [("--merge",), ("--merge", "KEY", "--key", "KEY"), ("KEY", "--by-total"),
     ("--merge", "KEY", "--table", "KEY"), ("KEY", "--lesson", "x")],
)  # fmt: skip
def test_calls_that_cannot_be_meant_end_with_2(schools: Path, words: tuple[str, ...]) -> None:
    key = str(schools / "key.json")
    assert carts(*(key if word == "KEY" else word for word in words)).exit_code == 2


def test_students_whose_class_keeps_them_out_of_the_gains_are_counted(tmp_path: Path) -> None:
    classes = ["7a"] * 9 + ["7b"] * 3 + [""]
    rows = "".join(f"s{k},{name},{k % 5},{k % 7}\n" for k, name in enumerate(classes))
    (tmp_path / "m.csv").write_text(f"student,class,pre (9),post (9)\n{rows}")
    target = tmp_path / "s.json"
    result = carts("--table", tmp_path / "m.csv", "--lesson", "x", "--summary", target)
    assert "s.json: 3 students with both tests are in no gain: fewer than 5" in result.stderr
    assert "s.json: 1 student with both tests is in no gain: no class is given" in result.stderr
    (lesson,) = json.loads(carts("--merge", target, "--json").stdout)["lessons"]
    assert (lesson["forms"][0]["n"], lesson["gains"][0]["n"]) == (13, 9)
