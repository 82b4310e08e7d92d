"""What opens every question of a lesson is the teacher's: students are not offered it."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

WORD = "owl"  # teacher_word of the site


def test_all_questions_are_opened_by_the_teachers_word_alone(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "worksheets" / "newtons-first-law.html", folder=site)
    waiting = page.locator("[data-after]:not([data-opened])")
    many = waiting.count()
    assert many > 5
    page.get_by_role("button", name="My answers").click()
    panel = page.get_by_role("dialog", name="My answers")
    opening = panel.get_by_role("button", name="Open all questions")
    expect(opening).to_be_hidden()
    panel.locator("summary", has_text="For teachers").click()
    opening.click()
    expect(panel).to_contain_text("open at once, and tell what it shows")
    panel.get_by_role("button", name="Open them now").click()
    expect(panel).to_contain_text("That is not the word.")
    expect(waiting).to_have_count(many)
    panel.get_by_label("Your teacher's word").fill(WORD)
    opening.click()
    panel.get_by_role("button", name="Open them now").click()
    expect(panel).to_contain_text("All questions of this page are open now.")
    expect(waiting).to_have_count(0)
