"""Files beside the lessons that a teacher takes for lessons, and no page is made of."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main


@pytest.mark.parametrize("ending", ["docx", "odt", "rtf", "text", "doc"])
def test_a_letter_among_the_lessons_is_told_and_how_to_save_it(
    ending: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "worksheets").mkdir()
    (tmp_path / "worksheets" / f"carts.{ending}").write_bytes(b"PK")
    result = CliRunner().invoke(main, ["check"])
    assert result.exit_code == 1
    assert f"worksheets/carts.{ending}:1:1: error: this is no lesson" in result.output
    assert "carts.md" in result.output


def test_a_table_or_a_letter_elsewhere_is_the_teachers_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "worksheets" / "data").mkdir(parents=True)
    (tmp_path / "worksheets" / "data" / "real.txt").write_text("t x\n", encoding="utf-8")
    (tmp_path / "letter.docx").write_bytes(b"PK")
    assert CliRunner().invoke(main, ["check"]).exit_code == 0
