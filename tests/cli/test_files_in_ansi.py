"""A lesson or a bank that Notepad saved as “ANSI” is named with its line by every command."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main
from tests.pages.given.small_site import lesson

BANK = "title: V\nitems:\n  - {id: a, type: number, ask: Wie groß?, answer: 1, tolerance: 0.1}\n"
QUIZ = "\n\n```quiz\nid: before\nform: pre\nbank: speed.yml\nitems: [a]\n```\n"
OF_A_LESSON = [
    ("check", "worksheets/ansi.md"),
    ("key", "worksheets/ansi.md"),
    ("words", "worksheets/ansi.md"),
    ("single", "worksheets/ansi.md"),
    ("export", "worksheets/ansi.md"),
]
OF_A_BANK = [
    ("check", "worksheets/asks.md"),
    ("key", "worksheets/asks.md"),
    ("words", "worksheets/banks/speed.yml"),
    ("export", "worksheets/banks/speed.yml"),
]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "worksheets/banks").mkdir(parents=True)
    ansi = lesson() + "\n\nWie groß?\n"
    (tmp_path / "worksheets/ansi.md").write_bytes(ansi.encode("cp1252"))
    (tmp_path / "worksheets/asks.md").write_text(lesson() + QUIZ)
    (tmp_path / "worksheets/banks/speed.yml").write_bytes(BANK.encode("cp1252"))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def told(*words: str) -> str:
    result = CliRunner().invoke(main, words)
    assert result.exception is None or isinstance(result.exception, SystemExit)
    assert result.exit_code == 1, result.output
    return result.output


@pytest.mark.parametrize("words", OF_A_LESSON, ids=lambda words: words[0])
def test_a_lesson_that_is_not_utf_8_is_named_with_its_line(
    folder: Path, words: tuple[str, str]
) -> None:
    line = (folder / words[1]).read_bytes().count(b"\n")
    assert f"ansi.md:{line}:1: error: this is not UTF-8 text" in told(*words)


@pytest.mark.parametrize("words", OF_A_BANK, ids=lambda words: words[0])
@pytest.mark.usefixtures("folder")
def test_a_bank_that_is_not_utf_8_is_named_with_its_line(words: tuple[str, str]) -> None:
    assert "banks/speed.yml:3:1: error: this is not UTF-8 text" in told(*words)


def test_hand_in_codes_that_are_not_utf_8_are_refused(folder: Path) -> None:
    (folder / "codes.txt").write_bytes("MÜSLI-7 AB".encode("cp1252"))
    result = CliRunner().invoke(main, ["class", "--codes", "codes.txt"])
    assert result.exit_code == 2
    assert "save this file as UTF-8" in result.output


def test_a_scene_file_that_is_not_utf_8_is_told_as_a_lesson_is(folder: Path) -> None:
    (folder / "worksheets/scenes").mkdir()
    scene = "carts: {A: {mass: 1 kg, position: 0.4 m}}\n"
    (folder / "worksheets/scenes/wide.yml").write_bytes(scene.encode("utf-16"))
    (folder / "worksheets/ansi.md").write_text("# T\n\n```scene\nid: a\nfile: wide.yml\n```\n")
    for words in (("check", "worksheets/ansi.md"), ("single", "worksheets/scenes/wide.yml")):
        assert "scenes/wide.yml:1:1: error: this is not UTF-8 text" in told(*words)
