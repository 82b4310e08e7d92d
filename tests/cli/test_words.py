"""`carts words`: catalogues of a lesson, written and brought up to date."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from sim.cli import main

LESSON = (
    "---\ntitle: A lesson\n---\n\n# A lesson\n\nFirst text here.\n\nSecond text, quite other.\n"
)


@pytest.fixture
def lesson(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("worksheets").mkdir()
    path = Path("worksheets/one.md")
    path.write_text(LESSON, encoding="utf-8")
    return path


def call(*arguments: str) -> Result:
    result = CliRunner().invoke(main, ["words", *arguments])
    assert result.exit_code == 0, result.output
    return result


def test_it_writes_a_catalogue_for_each_language(lesson: Path) -> None:
    said = call(str(lesson)).output
    for language in ("ms", "ta", "zh-Hans"):
        text = Path(f"worksheets/words/{language}/one.po").read_text(encoding="utf-8")
        assert f'"Language: {language}\\n"' in text
        assert text.count('msgstr ""') == 4  # the head, and three texts: the title stands once
        assert f"worksheets/words/{language}/one.po: 3 texts, 3 not in" in said


@pytest.mark.parametrize("text", ["", "\n\n", "---\norder: 3\n---\n"])
def test_of_a_lesson_without_a_text_it_says_so_and_writes_none(lesson: Path, text: str) -> None:
    lesson.write_text(text, encoding="utf-8")
    assert call(str(lesson)).output.startswith("worksheets/one.md: no text to translate")
    assert not Path("worksheets/words").exists()


def test_or_for_the_one_that_is_asked_for(lesson: Path) -> None:
    call(str(lesson), "--language", "ta")
    assert [path.name for path in Path("worksheets/words").iterdir()] == ["ta"]


def test_what_is_there_is_kept_and_a_second_time_changes_nothing(lesson: Path) -> None:
    call(str(lesson), "--language", "ms")
    path = Path("worksheets/words/ms/one.po")
    text = path.read_text(encoding="utf-8")
    text = text.replace('here."\nmsgstr ""', 'here."\nmsgstr "Teks pertama."')
    text = text.replace("# A draft, until", "# My own remark, until")
    text = text.replace('"X-Carts-State: draft\\n"\n', '"Last-Translator: me\\n"\n')
    path.write_text(text, encoding="utf-8")
    assert "3 texts, 2 not in Bahasa Melayu yet" in call(str(lesson), "--language", "ms").output
    assert path.read_text(encoding="utf-8") == text


def test_a_changed_text_keeps_its_old_translation_beside_it(lesson: Path) -> None:
    call(str(lesson), "--language", "ms")
    path = Path("worksheets/words/ms/one.po")
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace('here."\nmsgstr ""', 'here."\nmsgstr "Teks."'), encoding="utf-8")
    lesson.write_text(LESSON.replace("text here", "text there"), encoding="utf-8")
    said = call(str(lesson), "--language", "ms").output
    assert "3 not in Bahasa Melayu yet, 1 of them with an old translation" in said
    assert '#, fuzzy\n#| msgid "First text here."' in path.read_text(encoding="utf-8")


def test_a_text_that_went_and_came_back_finds_its_translation(lesson: Path) -> None:
    call(str(lesson), "--language", "ms")
    path = Path("worksheets/words/ms/one.po")
    text = path.read_text(encoding="utf-8")
    whole = text.replace('other."\nmsgstr ""', 'other."\nmsgstr "Teks kedua."')
    path.write_text(whole, encoding="utf-8")
    lesson.write_text(LESSON.replace("Second text, quite other.\n", ""), encoding="utf-8")
    call(str(lesson), "--language", "ms")
    assert '#~ msgstr "Teks kedua."' in path.read_text(encoding="utf-8")
    lesson.write_text(LESSON, encoding="utf-8")
    call(str(lesson), "--language", "ms")
    assert path.read_text(encoding="utf-8") == whole


def test_a_per_cent_sign_is_no_placeholder(lesson: Path) -> None:
    lesson.write_text(LESSON.replace("First text", "With 5 % in {all} text"), encoding="utf-8")
    call(str(lesson), "--language", "ms")
    assert "-format" not in Path("worksheets/words/ms/one.po").read_text(encoding="utf-8")


def test_a_file_that_is_no_lesson_is_refused(lesson: Path) -> None:
    other = lesson.with_name("scene.yml")
    other.write_text("carts: {}\n", encoding="utf-8")
    result = CliRunner().invoke(main, ["words", str(other)])
    assert (result.exit_code, "scene.yml" in result.output) == (2, True)


def test_a_language_without_a_catalogue_leads_to_the_guide(lesson: Path) -> None:
    result = CliRunner().invoke(main, ["words", str(lesson), "--language", "de"])
    assert result.exit_code == 2
    assert "'de' is not one of 'ms'" in result.output
    guide = "docs/developers/add-a-language.md"
    assert guide in result.output
    assert (Path(__file__).parents[2] / guide).is_file()


def test_a_language_may_be_called_as_the_settings_of_a_site_call_it(lesson: Path) -> None:
    result = CliRunner().invoke(main, ["words", str(lesson), "--language", "zh"])
    assert result.exit_code == 0, result.output
    assert Path("worksheets/words/zh-Hans/one.po").is_file()


def test_one_text_is_told_of_as_one(lesson: Path) -> None:
    lesson.write_text("# Alone\n", encoding="utf-8")
    assert "1 text, 1 not in" in call(str(lesson), "--language", "ms").output
