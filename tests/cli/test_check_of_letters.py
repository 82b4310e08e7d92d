"""Files beside the lessons that a teacher takes for lessons, and no page is made of."""

from __future__ import annotations

import io
import zipfile
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


def test_rich_text_under_the_name_of_a_lesson_is_told(tmp_path: Path) -> None:
    lesson = tmp_path / "carts.md"
    lesson.write_text("{\\rtf1\\ansi # Carts}", encoding="ascii")
    result = CliRunner().invoke(main, ["check", str(lesson)])
    assert result.exit_code == 1
    assert "this is rich text (RTF)" in result.output


def zipped(**files: str) -> bytes:
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as packed:
        for name, text in files.items():
            packed.writestr(name.replace("__", "/"), text)
    return data.getvalue()


NOT_TEXT = {
    "a Word document": zipped(word__document="<w:document/>"),
    "a LibreOffice document": zipped(mimetype="application/vnd.oasis.opendocument.text"),
    "a zip file": zipped(notes="# Carts"),
    "a PDF file": b"%PDF-1.7\n%\xe2\xe3\n",
    "an old Word document": b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1",
    "no text: it holds bytes of the value 0": b"# Carts\n\0\0\n",
}


@pytest.mark.parametrize("what", NOT_TEXT)
def test_what_is_no_text_under_the_name_of_a_lesson_or_a_scene_is_told_by_what_it_is(
    what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("carts.md").write_bytes(NOT_TEXT[what])
    Path("carts.yml").write_bytes(NOT_TEXT[what])
    for call in (("check", "carts.md"), ("words", "carts.md"), ("run", "carts.yml")):
        result = CliRunner().invoke(main, call)
        assert result.exit_code == 1, call
        assert f"{call[1]}:1:1: error: this is {what}\n" in result.output
        assert result.output.count("error:") == 1
        assert "hint: save its text as plain text, UTF-8" in result.output


@pytest.mark.parametrize(
    ("angle", "told"), [("1", True), ("-1", True), ("0.05", False), ("1 rad", False)]
)
def test_a_plain_angle_that_was_meant_in_degrees_is_a_hint(
    angle: str, told: bool, tmp_path: Path
) -> None:
    lesson = tmp_path / "slope.md"
    lesson.write_text(
        "# A\n\n```scene\nid: a\ncarts: {A: {mass: 1 kg, position: 0.5 m}}\n"
        f"effects: [{{incline: {{angle: {angle}}}}}]\n```\n",
        encoding="utf-8",
    )
    result = CliRunner().invoke(main, ["check", str(lesson)])
    assert result.exit_code == 0
    assert (f"For {angle}° write angle: {angle} deg" in result.output) == told


@pytest.mark.parametrize(("mass", "told"), [("20 kg", True), ("0.2 kg", True), ("3 kg", False)])
def test_a_preset_that_its_slider_cannot_show_is_a_hint(
    mass: str, told: bool, tmp_path: Path
) -> None:
    lesson = tmp_path / "preset.md"
    lesson.write_text(
        "# A\n\n```scene\nid: a\ncarts: {A: {mass: 1 kg, position: 0.5 m}}\n"
        "controls:\n  - {set: A.mass, from: 0.5 kg, to: 4 kg, step: 0.5 kg}\n"
        f"presets: {{heavy: {{A.mass: {mass}}}}}\n```\n",
        encoding="utf-8",
    )
    result = CliRunner().invoke(main, ["check", str(lesson)])
    assert result.exit_code == 0
    assert (f"{mass} is outside of the control of A.mass" in result.output) == told
