"""`carts key`: what a teacher prints before the lesson, for every lesson of the project."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.pages.translate.catalogues import OTHERS

ROOT = Path(__file__).parents[2]
ASKING = sorted(
    path.stem
    for path in (ROOT / "worksheets").glob("*.md")
    if re.search(r"^```(question|quiz)$", path.read_text(encoding="utf-8"), re.MULTILINE)
)


@pytest.fixture(scope="module")
def keys(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("keys")
    lessons = [str(ROOT / "worksheets" / f"{name}.md") for name in ASKING]
    said = CliRunner().invoke(main, ["key", "--out", str(out), *lessons])
    assert said.exit_code == 0, (said.output, said.exception)
    return out


def items(path: Path) -> list[dict[str, Any]]:
    content = json.loads(path.read_text(encoding="utf-8"))
    return [item for form in content["forms"] for item in form["items"]]


@pytest.mark.parametrize("lesson", ASKING)
def test_every_lesson_that_asks_has_a_key(keys: Path, lesson: str) -> None:
    page = (keys / f"{lesson}.key.html").read_text(encoding="utf-8")
    names = [item["id"] for item in items(keys / f"{lesson}.key.json")]
    assert names
    assert [name for name in names if name not in page] == []


def test_cells_of_a_table_are_told_with_units_and_tolerance(keys: Path) -> None:
    page = (keys / "newtons-second-law.key.html").read_text(encoding="utf-8")
    assert re.search(r"0\.45 ± 0\.005 N", page)
    assert re.search(r": 0\.8 m/s ± 0\.02", page)


def test_pairs_and_lines_stand_in_the_key_as_students_see_them(keys: Path) -> None:
    page = (keys / "newtons-first-law.key.html").read_text(encoding="utf-8")
    assert "a <em>v</em> line <strong>above zero</strong> that rises – it gets faster" in page
    for lesson in ASKING:
        page = (keys / f"{lesson}.key.html").read_text(encoding="utf-8")
        answers = re.findall(r'<p class="right">(.*)</p>', page)
        assert [told for told in answers if "*" in told or "\\(" in told] == []


@pytest.mark.parametrize("language", OTHERS)
def test_a_translated_lesson_has_its_key_in_the_words_that_students_read(
    keys: Path, language: str
) -> None:
    own = (keys / f"newtons-third-law.{language}.key.html").read_text(encoding="utf-8")
    english = (keys / "newtons-third-law.key.html").read_text(encoding="utf-8")
    assert "In none." in english and "In none." not in own
    answers = [
        {item["id"]: item["key"] for item in items(path)}
        for path in (keys / "newtons-third-law.key.json",
                     keys / f"newtons-third-law.{language}.key.json")
    ]  # fmt: skip
    right = [{name: key.get("correct") for name, key in one.items()} for one in answers]
    assert right[0] == right[1]


LESSON = str(ROOT / "worksheets" / "newtons-third-law.md")


@pytest.mark.parametrize(
    ("settings", "out"),
    [
        ("site_name: A\n", "site"),
        ("site_name: A\n", "site/below/keys"),
        ("site_dir: public\n", "build/../public"),
        ("docs_dir: worksheets\n", "worksheets/keys"),
        ("docs_dir: !ENV X\n", "./site"),
    ],
)
def test_a_key_is_never_written_where_students_get_it(
    settings: str, out: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("mkdocs.yml").write_text(settings, encoding="utf-8")
    result = CliRunner().invoke(main, ["key", LESSON, "--out", out])
    assert result.exit_code == 2
    assert "which students get" in result.stderr
    assert list(tmp_path.rglob("*.key.*")) == []


def test_a_key_is_written_beside_the_site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("mkdocs.yml").write_text("site_name: A\n", encoding="utf-8")
    assert CliRunner().invoke(main, ["key", LESSON]).exit_code == 0
    assert Path("build/keys/newtons-third-law.key.html").is_file()


def test_a_bank_is_answered_with_what_to_do(tmp_path: Path) -> None:
    bank = ROOT / "worksheets" / "banks" / "forces-and-motion.yml"
    result = CliRunner().invoke(main, ["key", str(bank), "--out", str(tmp_path)])
    assert result.exit_code == 2
    assert "is a bank. A key belongs to a lesson (.md)" in result.stderr
    assert f"carts export {bank}" in result.stderr


ASKS = "```question\nid: why\ntype: long\nask: {}\nrubric: {{1: a, 0: b}}\n```\n"


@pytest.fixture
def lessons(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    for place, ask in (("", "Why?"), ("ms", "Mengapa?")):
        folder = tmp_path / "worksheets" / place
        folder.mkdir(exist_ok=True)
        (folder / "held.md").write_text(ASKS.format(ask), encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize("named", [(), ("worksheets/held.md", "worksheets/ms/held.md")])
def test_a_lesson_translated_by_hand_has_a_key_of_its_own(
    lessons: Path, named: tuple[str, ...]
) -> None:
    result = CliRunner().invoke(main, ["key", *named])
    assert result.exit_code == 0, result.output
    keys_of = lessons / "build" / "keys"
    assert "Why?" in (keys_of / "held.key.html").read_text(encoding="utf-8")
    assert "Mengapa?" in (keys_of / "held.ms.key.html").read_text(encoding="utf-8")


def test_no_key_takes_the_place_of_another(lessons: Path) -> None:
    (lessons / "other").mkdir()
    (lessons / "other" / "held.md").write_text(ASKS.format("Else?"), encoding="utf-8")
    result = CliRunner().invoke(main, ["key", "worksheets/held.md", "other/held.md"])
    assert result.exit_code == 2
    assert "held.key.html would be the key of worksheets/held.md and of other/held.md" in (
        " ".join(result.output.split())
    )
    assert "Why?" in Path("build/keys/held.key.html").read_text(encoding="utf-8")


def test_a_lesson_that_is_named_twice_has_one_key(lessons: Path) -> None:
    named = ["worksheets/held.md", str(lessons / "worksheets" / "held.md")]
    assert CliRunner().invoke(main, ["key", *named]).exit_code == 0


def test_the_language_of_a_key_is_the_lesson_s_and_not_that_of_a_folder_above(
    lessons: Path,
) -> None:
    folder = lessons / "ms" / "school" / "worksheets"
    folder.mkdir(parents=True)
    (folder / "held.md").write_text(ASKS.format("Why?"), encoding="utf-8")
    told = f"---\nlanguage: ta\n---\n{ASKS.format('Why?')}"
    (folder / "own.md").write_text(told, encoding="utf-8")
    (lessons / "worksheets" / "held.md").unlink()
    result = CliRunner().invoke(main, ["key", f"{folder}/held.md", f"{folder}/own.md"])
    assert result.exit_code == 0, result.output
    made = {file.name for file in (lessons / "build" / "keys").glob("*.html")}
    assert made == {"held.key.html", "own.ta.key.html"}


def test_in_a_folder_without_lessons_it_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    result = CliRunner().invoke(main, ["key"])
    assert result.exit_code == 2
    assert "There are no lessons here (looked for worksheets)." in result.output
