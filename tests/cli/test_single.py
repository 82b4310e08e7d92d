"""`carts single`: the scene behaves as it does where it stands."""

from __future__ import annotations

from pathlib import Path

import pytest

from sim.cli.scene_of_lesson import scene_in

SCENE = "carts: {A: {mass: 1 kg, position: 0.4 m, velocity: 0.5 m/s}}\n"
LESSON = f"```scene\nid: one\n{SCENE}%s```\n"


@pytest.mark.parametrize(
    ("name", "more", "watch"),
    [
        ("worksheets/a.md", "", "first"),
        ("worksheets/ms/a.md", "", "first"),
        ("worksheets/a.md", "watch: free\n", "free"),
        ("docs/a.md", "", ""),
    ],
)
def test_a_scene_of_a_lesson_is_watched_before_it_is_known(
    tmp_path: Path, name: str, more: str, watch: str
) -> None:
    path = tmp_path / name
    path.parent.mkdir(parents=True)
    path.write_text(LESSON % more, encoding="utf-8")
    assert scene_in(path, None, tmp_path, "").fence.watch == watch


def test_a_folder_above_the_site_says_nothing_of_its_pages(tmp_path: Path) -> None:
    """A site may lie in somebody's folder of worksheets; its docs are no lessons."""
    site = tmp_path / "worksheets" / "my-site"
    for place in ("docs", "worksheets"):
        (site / place).mkdir(parents=True)
        (site / place / "a.md").write_text(LESSON % "", encoding="utf-8")
    (site / "mkdocs.yml").touch()
    assert scene_in(site / "docs" / "a.md", None, tmp_path, "").fence.watch == ""
    assert (
        scene_in(site / "worksheets" / "a.md", None, tmp_path / "else", "").fence.watch == "first"
    )


@pytest.mark.parametrize("name", ["one.yml", "crash #2.yml", "[a].yml", "a: b.yml"])
def test_a_scene_file_is_shown_at_once(tmp_path: Path, name: str) -> None:
    path = tmp_path / "worksheets" / "scenes" / name
    path.parent.mkdir(parents=True)
    path.write_text(SCENE, encoding="utf-8")
    assert scene_in(path, None, tmp_path, "").fence.watch == ""
