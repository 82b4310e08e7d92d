"""Questions on paper, and where no script runs."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import saved
from tests.web.question.question_site import question_site, ready

pytestmark = pytest.mark.browser

__all__ = ["question_site"]  # a fixture


def test_without_javascript_a_question_is_a_printed_one(
    open_page: OpenPage, question_site: Path, browser_name: str
) -> None:
    if browser_name == "firefox":
        pytest.skip("Firefox cannot be told to run no scripts through this driver")
    page = open_page(question_site / "kinds.html", java_script_enabled=False)
    expect(page.get_by_label("The one on the van")).to_be_visible()
    expect(page.locator("#why textarea")).to_be_visible()
    for hidden in (".carts-q-check", ".carts-q-hint", ".carts-q-up", ".carts-q-hints div"):
        expect(page.locator(hidden).first).to_be_hidden()
    page.emulate_media(media="print")
    expect(page.locator("#why .carts-q-write hr")).to_have_count(5)
    expect(page.locator("#why .carts-q-write")).to_be_visible()
    expect(page.locator("#story .carts-q-paper")).to_be_visible()
    page.goto((question_site / "test.html").as_uri())
    expect(page.locator("#small-pre carts-question").first).to_be_visible()
    expect(page.locator("#small-post carts-question").first).to_be_hidden()


def test_on_paper_stands_what_was_answered_or_a_line(
    open_page: OpenPage, question_site: Path, browser_name: str
) -> None:
    if browser_name == "firefox":
        pytest.skip("Firefox ESR cannot be told to print through this driver")
    page = ready(open_page(question_site / "kinds.html"))
    page.locator("#why textarea").fill("Same force,\nless mass.")
    saved(page, "why")
    page.emulate_media(media="print")
    expect(page.locator("#why .carts-q-printed")).to_have_text("Same force,\nless mass.")
    expect(page.locator("#why .carts-q-printed")).to_be_visible()
    expect(page.locator("#why .carts-q-write")).to_be_hidden()
    expect(page.locator("#resultant .carts-q-write")).to_be_visible()
    expect(page.locator(".carts-bar")).to_be_hidden()
    page.evaluate("document.documentElement.classList.add('carts-print-empty')")
    expect(page.locator("#why .carts-q-printed")).to_be_hidden()
    expect(page.locator("#why .carts-q-write")).to_be_visible()
