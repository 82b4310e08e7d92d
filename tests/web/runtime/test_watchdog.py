"""A page whose scripts do not run says so at once, and takes no answer that it could not keep."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from sim.pages.head.watchdog import watchdog
from tests.web.conftest import OpenPage
from tests.web.held_back import WHEN_TOLD
from tests.web.site.pages_of import pages

pytestmark = pytest.mark.browser

AGAIN = pytest.mark.one_browser  # the same sentence as for the first of them

LESSON = "worksheets/newtons-first-law.html"
SOON = 3000  # ms after which nobody may still believe that the page works
LEFT_OUT = shutil.ignore_patterns("runtime", "search", "javascripts", "images")


def missing(file: Path) -> None:
    file.unlink()


def cut(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    file.write_text(text[: len(text) // 2], encoding="utf-8")


def too_new(file: Path) -> None:
    """What a browser sees of a script in a language that it does not know yet."""
    file.write_text("let later = |> ;\n" + file.read_text(encoding="utf-8"), encoding="utf-8")


def breaks(file: Path) -> None:
    file.write_text("throw new Error('altered');\n" + file.read_text("utf-8"), encoding="utf-8")


@pytest.mark.parametrize("script", [pytest.param("answers.js", marks=AGAIN), "carts.js"])
@pytest.mark.parametrize(
    "fault", [missing, *(pytest.param(f, marks=AGAIN) for f in (cut, too_new, breaks))]
)
def test_a_script_that_does_not_run_is_told_and_the_boxes_stay_closed(
    fault: Callable[[Path], None], script: str, site: Path, open_page: OpenPage, tmp_path: Path
) -> None:
    for folder in ("worksheets", "assets"):
        shutil.copytree(site / folder, tmp_path / folder, ignore=LEFT_OUT)
    fault(tmp_path / "assets" / "carts" / script)
    page = open_page(tmp_path / LESSON, folder=tmp_path)
    expect(page.get_by_role("alert").first).to_contain_text(
        "nothing you type is kept", timeout=SOON
    )
    if script == "answers.js":
        assert open_boxes(page) == 0


def test_a_part_that_does_not_run_is_told_and_the_answers_stay_open(
    site: Path, open_page: OpenPage, tmp_path: Path
) -> None:
    for folder in ("worksheets", "assets"):
        shutil.copytree(site / folder, tmp_path / folder, ignore=LEFT_OUT)
    cut(tmp_path / "assets" / "carts" / "challenge.js")
    page = open_page(tmp_path / "worksheets" / "newtons-third-law.html", folder=tmp_path)
    watchdog = page.locator(".carts-watchdog")
    expect(watchdog).to_contain_text("your answers are kept", timeout=SOON)
    expect(page.locator("carts-question[data-ready]").first).to_be_attached()
    assert open_boxes(page) > 0


def open_boxes(page: Page) -> int:
    """Fields of questions that would take a key."""
    fields = "carts-question :is(input, textarea, select, .carts-q-up):not([readonly], :disabled)"
    return page.locator(fields).count()


@pytest.mark.parametrize("script", ["answers.js", "carts.js"])
@pytest.mark.one_browser
def test_on_the_web_a_reader_is_told_to_load_the_page_again_not_to_copy_a_folder(
    script: str, open_page: OpenPage, tmp_path: Path, site_server: Callable[[Path], str]
) -> None:
    lines = f'<script>{watchdog()}</script><body><script src="assets/carts/{script}"></script>'
    (tmp_path / "page.html").write_text(f"<!doctype html>{lines}", encoding="utf-8")
    on_web = open_page(f"{site_server(tmp_path)}/page.html").get_by_role("alert")
    expect(on_web).to_contain_text("load the page again")
    expect(on_web).not_to_contain_text("folder")
    from_disk = open_page(tmp_path / "page.html").get_by_role("alert")
    expect(from_disk).to_contain_text("copy the whole folder again")


def test_every_page_is_watched(site: Path) -> None:
    for name in pages(site):
        text = (site / name).read_text(encoding="utf-8")
        assert name in {"OPEN ME.html"} or "data-carts-answers" in text, name


def test_a_page_that_works_says_nothing(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "index.html", folder=site)
    page.add_init_script(WHEN_TOLD)
    page.goto((site / LESSON).as_uri())
    expect(page.locator("carts-question[data-ready]").first).to_be_attached()
    page.evaluate("watchdogLooks()")
    expect(page.locator(".carts-watchdog")).to_have_count(0)
