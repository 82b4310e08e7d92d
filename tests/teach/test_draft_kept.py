"""A teacher's kept draft is there before anything can be typed, with Python and without."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.teach.at_work import LESSON, WAIT, open_teacher, saved, settled
from tests.web.conftest import OpenPage

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.one_browser]

NO_PYTHON = "window.Worker = class { constructor() { throw new Error('no worker'); } };"
KEPT = "Draft kept in this browser."


def with_draft(open_page: OpenPage, lessons: Path) -> tuple[Page, str]:
    """A lesson of which a draft was kept, and its text."""
    page = open_teacher(open_page, lessons, LESSON)
    piece = page.locator(".carts-teach-piece").filter(has_text="Text Newton's third law").first
    piece.locator("summary").click()
    area = piece.get_by_label("Text in Markdown")
    area.fill(area.input_value().replace("# Newton's third law", "# An hour of work", 1))
    settled(page)
    expect(page.locator(".carts-teach-state")).to_have_text(KEPT)
    return page, saved(page).decode()


def test_without_python_a_kept_draft_is_what_is_shown_and_changed(
    lessons: Path, open_page: OpenPage
) -> None:
    page, draft = with_draft(open_page, lessons)
    page.add_init_script(NO_PYTHON)
    page.reload()
    page.wait_for_selector(".carts-teach[data-state=unchecked]", timeout=WAIT)
    area = page.get_by_label("Text of this block")
    expect(area).to_have_value(draft)
    expect(page.locator(".carts-teach-state")).to_have_text(KEPT)
    area.press("Control+End")
    page.keyboard.type("More.")
    page.wait_for_timeout(500)
    page.reload()
    page.wait_for_selector(".carts-teach[data-state=unchecked]", timeout=WAIT)
    assert "An hour of work" in area.input_value()
    assert area.input_value().endswith("More.")


def test_no_published_text_can_be_typed_over_while_the_draft_comes_back(
    lessons: Path, open_page: OpenPage
) -> None:
    page, draft = with_draft(open_page, lessons)
    page.add_init_script(
        """window.shown = new Set();
        setInterval(() => {
          for (const { textContent } of document.querySelectorAll(".carts-teach-piece summary"))
            if (/^Text (Newton's third law|An hour)/.test(textContent)) shown.add(textContent);
        }, 2);"""
    )
    page.reload()
    page.wait_for_selector(".carts-teach[data-state=ready]", timeout=WAIT)
    assert saved(page).decode() == draft
    assert page.evaluate("[...window.shown]") == ["Text An hour of work changed"]


def test_a_draft_that_was_put_aside_is_no_longer_said_to_be_back(
    lessons: Path, open_page: OpenPage
) -> None:
    page, _ = with_draft(open_page, lessons)
    page.reload()
    page.wait_for_selector(".carts-teach[data-state=ready]", timeout=WAIT)
    expect(page.locator(".carts-teach-status")).to_contain_text("is back")
    page.click(".carts-teach-reset")
    page.get_by_role("button", name="Yes, go back").click()
    settled(page)
    expect(page.locator(".carts-teach-status")).to_have_text("")
