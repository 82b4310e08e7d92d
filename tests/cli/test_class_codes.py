"""`carts class --codes`: to which group typed codes belong, and which line is named."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from sim.lesson.handin import encode
from tests.classroom.given.makers import bank, form, keys, random_class, sources
from tests.cli.called import carts_class as carts

BANK = bank(6)
GROUPS = ("--group", "new=7a/*", "--group", "usual=7b/*")


def code(name: str, *chosen: int) -> str:
    return encode([4] * 6, chosen or [1] * 6, f"{name}:{form(name, BANK).hash}")


@pytest.fixture
def school(tmp_path: Path) -> Path:
    """Two classes of six that took the test before; the test after was written on paper."""
    for folder in ("7a", "7b"):
        (tmp_path / folder).mkdir()
        for source in sources(random_class(BANK, 6, prefix=folder)):
            if ".pre." in source.name:
                (tmp_path / folder / source.name).write_bytes(source.content)
    (tmp_path / "key.json").write_text(keys(BANK), encoding="utf-8")
    return tmp_path


def after(report: dict[str, Any]) -> dict[str, list[str]]:
    (post,) = [form for form in report["lessons"][0]["forms"] if form["form"] == "post"]
    groups: dict[str, list[str]] = {}
    for row in post["students"]:
        groups.setdefault(row["group"], []).append(row["student"])
    return groups


def typed(school: Path, name: str, *lines: str) -> Path:
    path = school / name
    path.write_text("\n".join(lines), encoding="utf-8")
    return path


def test_a_typed_code_is_in_the_group_of_its_students_other_file(school: Path) -> None:
    codes = typed(school, "codes.txt", *(f"{name}-{k} {code('post')}" for name in ("7a", "7b")
                                         for k in range(6)))  # fmt: skip
    result = carts(school, *GROUPS, "--codes", codes, "--json")
    made = json.loads(result.stdout)
    assert result.exit_code == 0, result.stderr
    assert after(made) == {name: [f"{folder}-{k}" for k in range(6)]
                           for name, folder in (("new", "7a"), ("usual", "7b"))}  # fmt: skip
    assert [row["n"] for row in made["lessons"][0]["gains"]] == [6, 6]


def test_a_file_of_codes_is_in_a_group_as_any_other_file(school: Path) -> None:
    files = [typed(school, f"{name}/codes.txt", f"BEE-{name} {code('post')}")
             for name in ("7a", "7b")]  # fmt: skip
    words = [word for path in files for word in ("--codes", path)]
    made = json.loads(carts(school / "key.json", *words, *GROUPS, "--json").stdout)
    assert after(made) == {"new": ["BEE-7a"], "usual": ["BEE-7b"]}
    lone = ("--group", "new=*/7a/codes.txt", "--group", "usual=7b")
    assert after(json.loads(carts(school / "key.json", *words, *lone, "--json").stdout)) == {
        "new": ["BEE-7a"], "usual": ["BEE-7b"]
    }  # fmt: skip


def test_a_code_of_nobody_else_is_refused_by_file_and_line(school: Path) -> None:
    codes = typed(
        school, "codes.txt", "", f"BEE {code('post')}", "", "OWL 7K2M", f"7a-1 {code('post')}"
    )
    result = carts(school, *GROUPS, "--codes", codes, "--json")
    assert result.exit_code == 1
    place = codes.as_posix()
    assert f"{place}/line 2: BEE post: this code is in none of the groups" in result.stderr
    assert f"{place}/line 4: OWL 7K2M: a line is: code word, form" in result.stderr
    assert after(json.loads(result.stdout)) == {"new": ["7a-1"]}
