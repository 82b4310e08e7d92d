"""A file that is named wrongly is told in a sentence, the same one by every command."""

from __future__ import annotations

import pytest

from tests.cli.called import carts

COMMANDS = {
    "run": "a scene file",
    "plan": "a scene file",
    "law": "a law file",
    "single": "a lesson or a scene file",
    "export": "a lesson or a bank",
    "words": "a lesson or a bank",
    "key": "a lesson",
    "fit": "a file of readings",
}


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("name", ["no-such.md", "x" * 300, "zero\0byte"])
def test_a_file_that_is_not_there_is_named(command, name):
    result = carts(command, name)
    assert result.exit_code == 2
    if name == "no-such.md":
        assert "Error: There is no file “no-such.md”.\n" in result.stderr
    assert "Traceback" not in result.stderr


@pytest.mark.parametrize("command", COMMANDS)
def test_a_folder_in_place_of_a_file_is_told_what_should_be_there(command, tmp_path):
    (tmp_path / "lessons.md").mkdir()
    result = carts(command, "lessons.md")
    assert result.exit_code == 2
    assert f"Error: “lessons.md” is a folder, not {COMMANDS[command]}.\n" in result.stderr


def test_answers_may_be_a_folder_and_what_is_not_there_is_neither():
    result = carts("class", "answers")
    assert "Error: There is no file or folder “answers”.\n" in result.stderr
    assert result.exit_code == 2


@pytest.mark.parametrize("name", ["scene.txt", "scene"])
def test_one_scene_of_a_file_with_another_ending_is_refused_by_its_ending(name, tmp_path):
    (tmp_path / name).write_text("carts: {A: {mass: 1, position: 1}}\n", encoding="utf-8")
    result = carts("single", name)
    assert result.exit_code == 2
    assert f"{name} is neither a lesson (.md) nor a scene file (.yml)" in result.stderr


def test_a_key_is_of_a_lesson_whatever_else_is_named(tmp_path):
    (tmp_path / "scene.txt").write_text("carts: {}\n", encoding="utf-8")
    result = carts("key", "scene.txt")
    assert (result.exit_code, result.stdout) == (2, "")
    assert "scene.txt is no lesson (.md)." in result.stderr


@pytest.mark.parametrize("inside", [None, "scene.yml", "notes.txt"])
def test_a_folder_of_which_nothing_is_looked_at_is_not_said_to_be_right(inside, tmp_path):
    folder = tmp_path / "mine"
    folder.mkdir()
    if inside:
        (folder / inside).write_text("carts: {A: {mass: -1, position: 1}}\n", encoding="utf-8")
    result = carts("check", "mine")
    assert (result.exit_code, result.stdout) == (2, "")
    assert "Nothing in “mine” was looked at" in result.stderr
