"""Right answers are not two clicks away: a teacher's word, and zips without the way in."""

from __future__ import annotations

import shutil
import zipfile
from pathlib import Path

import pytest
from click.testing import CliRunner
from playwright.sync_api import expect

from sim.cli import main
from sim.cli.site.build import build_site
from sim.lesson.opening import word_sum
from tests.teach.conftest import SETTINGS
from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import ROOT

pytestmark = [pytest.mark.browser, pytest.mark.slow]

LESSON = "newtons-second-law"
WAIT = 60_000  # ms; on a busy computer


@pytest.fixture
def lesson_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A project of one lesson."""
    monkeypatch.setenv("CARTS_CACHE", str(ROOT / ".cache"))
    folder = tmp_path / "project"
    (folder / "worksheets").mkdir(parents=True)
    (folder / "mkdocs.yml").write_text(SETTINGS, encoding="utf-8")
    shutil.copy(ROOT / "worksheets" / f"{LESSON}.md", folder / "worksheets")
    return folder


@pytest.mark.one_browser
def test_with_a_teachers_word_nothing_is_opened_before_it_is_given(
    lesson_alone: Path, tmp_path: Path, open_page: OpenPage
) -> None:
    settings = {"teacher_word": "grey owl"}
    site = build_site(
        lesson_alone, hosted=False, strict=False, site_dir=tmp_path / "site", settings=settings
    )
    assert site
    page = open_page(site / "index.html", folder=site)
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto((site / "worksheets" / f"{LESSON}.html").as_uri() + "#teacher")
    word = page.locator(".carts-teach-door input")
    expect(word).to_be_focused()
    page.goto((site / "index.html").as_uri())
    page.goto((site / "worksheets" / f"{LESSON}.html").as_uri())
    page.locator(".carts-teach-door a").click()
    expect(word).to_be_focused()  # also after the address has become #teacher
    page.keyboard.type("OWL")
    word.press("Enter")
    assert page.locator(".carts-teach-door [role=alert]").inner_text() == "That is not the word."
    expect(word).to_have_attribute("aria-invalid", "true")
    assert page.evaluate("getSelection().toString()") == "OWL"  # the next word takes its place
    parts = ("assets/carts/teacher.", "assets/carts/lessons/")
    assert not [url for url in asked if any(part in url for part in parts)]
    word.fill("Grey Owl ")
    word.press("Enter")
    page.wait_for_selector(".carts-teach[data-state=ready]", timeout=WAIT)
    page.reload()  # once in a tab is enough
    page.wait_for_selector(".carts-teach[data-state=ready]", timeout=WAIT)


def test_a_pack_for_students_has_no_way_to_the_answers(
    lesson_alone: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(lesson_alone)
    packed = {}
    for name, more in (("students", ()), ("teachers", ("--teacher-word", "OWL"))):
        out = tmp_path / f"{name}.zip"
        done = CliRunner().invoke(main, ["pack", "--out", str(out), *more])
        assert done.exit_code == 0, done.output
        with zipfile.ZipFile(out) as archive:
            packed[name] = archive.read(f"worksheets/{LESSON}.html").decode("utf-8")
            assert ("assets/carts/teacher.js" in archive.namelist()) is bool(more)
    assert "carts-teach-door" not in packed["students"]
    assert 'name="carts-teacher"' in packed["teachers"]


def test_a_pack_for_students_asks_for_the_sites_word_before_all_questions_open(
    lesson_alone: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    settings = lesson_alone / "mkdocs.yml"
    text = settings.read_text(encoding="utf-8")
    worded = text.replace("[search, carts]", "[search, {carts: {teacher_word: OWL}}]")
    settings.write_text(worded, encoding="utf-8")
    monkeypatch.chdir(lesson_alone)
    out = tmp_path / "students.zip"
    done = CliRunner().invoke(main, ["pack", "--out", str(out)])
    assert done.exit_code == 0, done.output
    with zipfile.ZipFile(out) as archive:
        page = archive.read(f"worksheets/{LESSON}.html").decode("utf-8")
    assert "carts-teach-door" not in page
    assert f'name="carts-teacher" content="{word_sum("teacher", "OWL")}"' in page
