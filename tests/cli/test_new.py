"""A new lesson has no mistakes, comes last, and takes the place of none."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.pages.checks.left_over import PLACEHOLDERS
from sim.pages.checks.lessons import check_paths
from sim.pages.text.front_matter import LAST, lesson_order


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "worksheets").mkdir()
    (tmp_path / "worksheets" / "old.md").write_text("---\norder: 7\n---\n# Old\n", encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("title", ["Two trains meet", "Trains: which wins?", "Ana's train", "力"])
def test_a_new_lesson_has_no_mistakes(folder: Path, title: str) -> None:
    result = CliRunner().invoke(main, ["new", "two-trains", "--title", title])
    assert result.exit_code == 0, result.output
    path = folder / "worksheets" / "two-trains.md"
    assert {one.code for one in check_paths([path], folder)} == {"placeholder"}
    assert "order: 8" in path.read_text(encoding="utf-8")


def test_a_lesson_that_is_there_stays_as_it_is(folder: Path) -> None:
    before = (folder / "worksheets" / "old.md").read_text(encoding="utf-8")
    result = CliRunner().invoke(main, ["new", "old"])
    assert result.exit_code == 1
    assert "there already" in result.output
    assert (folder / "worksheets" / "old.md").read_text(encoding="utf-8") == before


def test_a_name_of_one_letter_is_a_name(folder: Path) -> None:
    assert CliRunner().invoke(main, ["new", "x"]).exit_code == 0
    found = check_paths([folder / "worksheets" / "x.md"], folder)
    assert {one.code for one in found} == {"placeholder"}


def test_words_of_the_starter_that_are_left_over_are_told_and_stop_nothing(folder: Path) -> None:
    """The home page told students “What this lesson is about, in one sentence.”"""
    CliRunner().invoke(main, ["new", "x"])
    path = folder / "worksheets" / "x.md"
    told = CliRunner().invoke(main, ["check", str(path)])
    assert told.exit_code == 0, told.output
    for words in PLACEHOLDERS:
        assert words in path.read_text(encoding="utf-8")
        path.write_text(path.read_text(encoding="utf-8").replace(words, "Two trains meet."))
    assert re.search(r"x\.md:4:14: warning: students will read “What this lesson", told.output)
    assert check_paths([path], folder) == []


def test_a_new_lesson_has_a_question_that_is_marked(folder: Path) -> None:
    CliRunner().invoke(main, ["new", "x"])
    text = (folder / "worksheets" / "x.md").read_text(encoding="utf-8")
    assert re.search(r"type: single\n.*correct: true", text, re.DOTALL)


@pytest.mark.parametrize("name", ["../up", "Two Trains", "a/b", "", "1st"])
def test_a_name_that_is_none_is_refused_with_an_example(folder: Path, name: str) -> None:
    result = CliRunner().invoke(main, ["new", name])
    assert result.exit_code == 2
    assert "two-trains" in result.output
    assert [path.name for path in (folder / "worksheets").iterdir()] == ["old.md"]


def test_minutes_and_place_are_those_at_the_top_of_a_lesson_only(folder: Path) -> None:
    lesson = folder / "worksheets" / "plain.md"
    rubric = "rubric: {1: a reason, 0: none}"
    question = f"```question\nid: one\ntype: long\nask: Why?\n{rubric}\nminutes: 3\n```"
    lesson.write_text(f"---\ntitle: P\n---\n\n## One {{: data-minutes=9 }}\n\n{question}\n",
                      encoding="utf-8")  # fmt: skip
    assert check_paths([lesson], folder) == []
    assert lesson_order(lesson) == (LAST, "plain.md")


@pytest.mark.parametrize("kind", ["--site", "--lesson", "--bank"])
@pytest.mark.parametrize("name", ["con", "PRN", "aux", "nul", "com1", "lpt9", "nul.txt", "con ."])
def test_a_name_of_a_device_of_windows_is_refused(folder: Path, name: str, kind: str) -> None:
    result = CliRunner().invoke(main, ["new", name, kind])
    assert result.exit_code == 2
    assert f"“{name}” is the name of a device on Windows" in result.output
    assert sorted(path.name for path in folder.iterdir()) == ["worksheets"]


@pytest.mark.parametrize("name", ["lessons.", "lessons ", "school/lessons...", "... "])
def test_a_folder_that_ends_in_a_dot_or_a_space_is_refused(folder: Path, name: str) -> None:
    result = CliRunner().invoke(main, ["new", name, "--site"])
    assert result.exit_code == 2
    assert "ends in a dot or a space" in result.output
    assert sorted(path.name for path in folder.iterdir()) == ["worksheets"]


@pytest.mark.parametrize("name", ["console", "com10", "auxiliary", "v1.2", "null"])
def test_a_name_that_only_begins_like_a_device_is_taken(folder: Path, name: str) -> None:
    assert CliRunner().invoke(main, ["new", name, "--site"]).exit_code == 0


def test_in_the_folder_of_lessons_a_lesson_of_that_site_is_written(
    folder: Path, monkeypatch
) -> None:
    """Before, a whole site was made among the lessons, and its lesson joined no menu."""
    (folder / "mkdocs.yml").write_text("site_name: Mine\n", encoding="utf-8")
    monkeypatch.chdir(folder / "worksheets")
    result = CliRunner().invoke(main, ["new", "two-trains"])
    assert (result.exit_code, result.output) == (
        0,
        "two-trains.md is written. Edit it, then: cd .., carts check, carts serve\n",
    )
    assert "order: 8" in (folder / "worksheets" / "two-trains.md").read_text(encoding="utf-8")
    assert sorted(path.name for path in (folder / "worksheets").iterdir()) == [
        "old.md",
        "two-trains.md",
    ]
