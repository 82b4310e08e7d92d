"""A style sheet that never comes leaves no blank page: the lesson works without it, later with."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.web.conftest import CONTEXT
from tests.web.held_back import holding_back

pytestmark = pytest.mark.browser

LESSON = "worksheets/newtons-first-law.html"
# A blank page is looked at for three seconds; here that would be three seconds of every run.
SOONER = """const later = setTimeout;
  window.setTimeout = (does, ms, ...more) => later(does, ms === 3000 ? 300 : ms, ...more);"""


@pytest.fixture
def held_back(site: Path) -> Iterator[tuple[str, threading.Event]]:
    """An address where carts.css comes only after the event."""
    with holding_back(site, "/carts.css") as held:
        yield held


@pytest.mark.one_browser  # Firefox waits until its own clock runs out, whatever is done to the link
def test_a_page_does_not_wait_for_a_sheet_for_ever(
    browser: Browser, browser_name: str, held_back: tuple[str, threading.Event]
) -> None:
    address, go_on = held_back
    context = browser.new_context(**CONTEXT[browser_name])
    page = context.new_page()
    page.add_init_script(SOONER)
    page.goto(f"{address}/{LESSON}", wait_until="commit")
    expect(page.locator("carts-question[data-ready]").first).to_be_visible()
    expect(page.locator(".carts-watchdog")).to_have_count(0)
    sheet = page.locator('link[href*="/carts.css"]')
    expect(sheet).to_have_attribute("media", "print")
    go_on.set()
    expect(sheet).to_have_attribute("media", "all")
    context.close()
