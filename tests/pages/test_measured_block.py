"""A `measured` block: what stands in the page before Python starts, and what it keeps to itself."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.checks.lessons import check_lesson
from sim.pages.findings import AuthorError
from tests.web.figures.measured_site import BLOCKS, element

WORKSHEETS = Path(__file__).parents[2] / "worksheets"


def baked(html: str) -> dict[str, object]:
    found = re.search(r'carts-measured-baked">(.*?)</script>', html, re.DOTALL)
    assert found
    made: dict[str, object] = json.loads(found[1])
    return made


def dots(made: str) -> list[str]:
    """The paths of points in a figure."""
    return [path for path in re.findall(r"<path [^>]*>", made) if "carts-measured-dots" in path]


def test_the_readings_stand_in_the_page_and_are_carried_along() -> None:
    made = element(BLOCKS["film"])
    assert baked(made)["text"] == (WORKSHEETS / "data" / "real-carts.txt").read_text("utf-8")
    (first, second) = dots(made)
    assert first.count("h0") == second.count("h0") == 97
    assert made.count("<tr><td>") == 60
    assert "and 37 more rows" in made


def test_no_fit_stands_in_the_page() -> None:
    for body in BLOCKS.values():
        made = element(body)
        assert "0.839" not in made
        assert "0.741" not in made
        assert "±" not in made.replace("value ± half", "")


def test_without_data_there_is_an_empty_bench() -> None:
    made = baked(element(BLOCKS["empty"]))
    assert made["read"] is None
    assert made["text"] == ""


def test_every_reading_is_a_point_of_the_figure_and_numbers_stand_at_its_axes() -> None:
    made = element(BLOCKS["film"])
    places = [re.findall(r"M(\S+?) (\S+?)h0", path) for path in dots(made)]
    read: Any = baked(made)["read"]
    assert [len(one) for one in places] == [len(track["t"]) for track in read["tracks"]]
    assert all(58 <= float(x) <= 630 and 10 <= float(y) <= 250 for one in places for x, y in one)
    assert made.count('carts-tick-x"') > 3 and made.count('carts-tick-y"') > 3


def test_a_file_outside_of_the_lessons_folder_is_not_read() -> None:
    for name in ("../data/real-carts.txt", "/etc/passwd", "real-carts.yml"):
        with pytest.raises(AuthorError) as caught:
            element(f"id: x\ndata: {name}")
        assert caught.value.findings[0].code == "no-such-file"


def test_a_mistake_in_the_file_is_told_with_its_own_line(tmp_path: Path) -> None:
    (tmp_path / "data").mkdir()
    text = (WORKSHEETS / "data" / "real-carts.txt").read_text("utf-8").splitlines()
    text[11] = text[10]
    (tmp_path / "data" / "film.txt").write_text("\n".join(text), encoding="utf-8")
    lesson = "```measured\nid: x\ndata: film.txt\n```\n"
    (finding,) = check_lesson(lesson, Lesson("lesson.md", (tmp_path,)), SiteIds())
    assert finding.file.endswith("film.txt")
    assert finding.line == 12
    assert "stands in line 11 already" in finding.message
