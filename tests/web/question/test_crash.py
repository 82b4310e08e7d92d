"""A browser that is killed loses no answer that it called saved: 3 times, Firefox once; and no
prediction, no lock, no run that was watched.

`make bench AREA=answers` kills 50 ms after the last key, whatever the page says.
"""

from __future__ import annotations

from contextlib import AbstractContextManager
from pathlib import Path

import pytest
from playwright.sync_api import Page, Playwright, expect

from tests.web.question.answering import guess
from tests.web.question.killed_browser import killed_page, lost_answers
from tests.web.question.question_site import question_site
from tests.web.scene.given.widget_site import live, widget_site

pytestmark = pytest.mark.browser

__all__ = ["question_site", "widget_site"]  # fixtures

DELAYS = (0.0, 0.05, 0.5)  # s
SOON = 0.05  # s after what a reader did last


def test_no_answer_is_lost_when_the_browser_is_killed(
    driver: Playwright, browser_name: str, question_site: Path, tmp_path: Path
) -> None:
    file = question_site / "kinds.html"
    delays = DELAYS if browser_name == "chromium" else DELAYS[1:2]  # Firefox takes 6 s to start
    assert lost_answers(driver, browser_name, tmp_path, file, delays, told=True) == []


@pytest.mark.one_browser
def test_a_prediction_its_lock_and_its_watched_run_are_there_when_the_browser_is_killed(
    driver: Playwright, browser_name: str, widget_site: Path, tmp_path: Path
) -> None:
    def opened_anew(delay: float | None) -> AbstractContextManager[Page]:
        return killed_page(driver, browser_name, tmp_path, widget_site / "arrows.html", delay)

    arrow, lock = '.carts-guess[data-on="{}"] [type=text]', ".carts-lock"
    with opened_anew(SOON) as page:
        live(page, "arrows")
        guess(page, "A", 2)
    with opened_anew(SOON) as page:
        live(page, "arrows")
        expect(page.locator(arrow.format("A"))).to_have_value("2.0")
        guess(page, "B", 6)
        page.locator(lock).click()
    with opened_anew(SOON) as page:
        live(page, "arrows")
        expect(page.locator(arrow.format("B"))).to_have_value("6.0")
        expect(page.locator(lock)).to_be_disabled()
        expect(page.locator(".carts-play")).to_be_enabled()  # not before a lock
        page.locator(".carts-end").click()
        expect(page.locator(".carts-compared")).to_be_visible()
    with opened_anew(None) as page:
        expect(page.locator(".carts-compared")).to_contain_text("2.0 N")
        expect(page.locator(".carts-compared")).to_contain_text("6.0 N")
