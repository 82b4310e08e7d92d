"""The page *Measured* and the badges say what one run of `make bench` found, and nothing else."""

from __future__ import annotations

import json
import re
from typing import Any

import pytest

from tests.benchmarks import _kept
from tests.benchmarks.__main__ import areas, usual
from tests.conftest import ROOT

MADE: dict[str, Any] = json.loads(_kept.FILE.read_text(encoding="utf-8"))


def test_the_page_is_what_was_measured() -> None:
    assert _kept.page(MADE) == _kept.PAGE.read_text(encoding="utf-8")


def test_every_missed_goal_is_named_before_the_tables() -> None:
    before = _kept.page(MADE).partition("| what |")[0]
    rows = [row for row in MADE["rows"] if row["goal"] is not None]
    for row in rows:
        too_much = row["value"] > row["goal"] and not row.get("at_least")
        too_little = row["value"] < row["goal"] and row.get("at_least")
        assert (f"- {row['name']}: " in before) == bool(too_much or too_little)


def test_every_area_was_measured_or_the_page_says_why_not() -> None:
    assert set(MADE["areas"]) | set(MADE["left_out"]) == set(usual(areas()))
    assert not set(MADE["areas"]) & set(MADE["left_out"])


@pytest.mark.parametrize("name", sorted(_kept.badges(MADE)))
def test_the_badges_are_those_of_the_measurement_and_the_readme_shows_them(name: str) -> None:
    badge = (_kept.BADGES / name).read_text(encoding="utf-8")
    assert badge == _kept.badges(MADE)[name]
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    (said,) = re.findall(r"<title>(.*?)</title>", badge)
    assert f"![{said}](docs/assets/badges/{name})" in readme


def test_a_missed_goal_turns_the_badge() -> None:
    worse = [{**row, "value": 1e9} if row["goal"] is not None else row for row in MADE["rows"]]
    changed = _kept.badges({**MADE, "rows": worse})
    assert changed.keys() == _kept.badges(MADE).keys()
    assert all(changed[name] != text for name, text in _kept.badges(MADE).items())
