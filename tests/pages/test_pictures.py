"""A `picture` block: one instant of a scene, drawn when the site is built; it tells nothing."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sim.pages.blocks.extension import Page
from sim.pages.blocks.makers import made
from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.checks.lessons import check_lesson
from sim.pages.text.fence_scan import scan
from sim.pages.text.lesson_places import scene_folders
from tests.conftest import ROOT

LESSON = Lesson("docs/index.md", scene_folders(ROOT / "docs" / "index.md", ROOT))
WALL = "of: newtons-third-law.md\nscene: third-wall\n"
HITS = "file: light-meets-heavy.yml\n"


def drawn(body: str) -> tuple[str, Page]:
    (block,) = scan(f"```picture\n{body}```".splitlines())
    page = Page(LESSON)
    return made(block, page), page


def codes(body: str) -> set[str]:
    text = f"# A page\n\n```picture\n{body}```\n"
    return {finding.code for finding in check_lesson(text, LESSON, SiteIds())}


def place_of(name: str, html: str) -> float:
    found = re.search(
        rf'<g transform="translate\(([-\d.]+) [^>]*carts-cart[^>]*data-body="{name}"', html
    )
    assert found, html[:2000]
    return float(found[1])


def test_the_carts_stand_where_they_are_at_that_instant() -> None:
    """Light meets heavy: A at 0.6 m/s from 0.3 m until it touches at 1 s; B stands until then."""
    start, later = drawn(HITS)[0], drawn(HITS + "at: 0.5 s\n")[0]
    moved = [place_of(name, later) - place_of(name, start) for name in "AB"]
    assert moved[0] > 10
    assert moved[1] == 0
    assert drawn(HITS + "at: 500 ms\n")[0] == later


def test_a_picture_gives_no_force_away_unless_it_is_asked_to() -> None:
    """A card on the way to a lesson on the third law stands there before the prediction."""
    told = "on A by B"
    assert told not in drawn(HITS + "at: 1.05 s\n")[0]
    assert told in drawn(HITS + "at: 1.05 s\nforces: shown\n")[0]
    assert codes(HITS + "forces: perhaps\n") == {"not-a-choice"}
    hidden = "of: newtons-third-law.md\nscene: third-light-into-heavy\nforces: shown\n"
    assert codes(hidden) == {"tells-the-answer"}


def test_a_picture_shows_no_tool_that_nobody_can_work() -> None:
    ruled = "of: newtons-first-law.md\nscene: after-the-hand\n"
    assert "carts-tape" not in drawn(ruled)[0]


def test_a_picture_calls_for_no_script_and_no_python() -> None:
    html, page = drawn(WALL)
    assert "<script" not in html
    assert page.scenes == 0
    assert not page.packages


def test_two_pictures_of_one_scene_share_no_id() -> None:
    page = Page(LESSON)
    (block,) = scan(f"```picture\n{WALL}```".splitlines())
    ids = [set(re.findall(r' id="([^"]+)"', made(block, page))) for _ in range(2)]
    assert ids[0]
    assert not ids[0] & ids[1]


def test_it_has_a_name_for_those_who_do_not_see_it() -> None:
    assert re.search(r'role="img" aria-label="[^"]+"', drawn(WALL)[0])


@pytest.mark.parametrize(
    ("body", "code"),
    [
        ("at: 1 s\n", "missing"),
        (WALL + HITS, "missing"),
        ("of: newtons-fourth-law.md\nscene: x\n", "no-such-file"),
        ("of: ../../etc/passwd\nscene: x\n", "no-such-file"),
        ("of: newtons-third-law.md\nscene: x\n", "no-such-scene"),
        (HITS + "at: 5 kg\n", "not-a-time"),
        (HITS + "at: 9 s\n", "out-of-range"),
        (HITS + "when: 9 s\n", "unknown-key"),
        ("file: no-such.yml\n", "no-such-file"),
        ("of: newtons-third-law.md\nscene: third-heavy-into-light\nat: 1 s\n", "tells-the-answer"),
    ],
)
def test_a_picture_that_makes_no_sense_is_refused(body: str, code: str) -> None:
    assert codes(body) == {code}


def test_every_scene_of_the_gallery_is_a_picture_that_leads_to_it() -> None:
    folder = ROOT / "docs" / "gallery"
    index = (folder / "index.md").read_text(encoding="utf-8")
    pictures = re.findall(r"^ +file: (\S+)$", index, re.M)
    shown = [
        name
        for page in sorted(Path(folder).glob("*.md"))
        if page.name != "index.md"
        for name in re.findall(r"^file: (\S+)$", page.read_text(encoding="utf-8"), re.M)
    ]
    assert sorted(pictures) == sorted(shown)
