"""The menu of a narrow window: closed it is in nobody's way, opened it is whole."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage

pytestmark = pytest.mark.browser


def a_lesson(open_page: OpenPage, site: Path, width: int, height: int) -> Page:
    """Open in a window of that size, with all that was kept back in it."""
    lesson = site / "worksheets" / "newtons-first-law.html"
    page = open_page(lesson, folder=site, viewport={"width": width, "height": height})
    expect(page.locator(".carts-bar[data-ready]")).to_have_count(1)
    return page


@pytest.mark.one_browser
def test_nobody_tabs_through_a_menu_that_is_closed(site: Path, open_page: OpenPage) -> None:
    """113 links lay to the left of the window, between the head and the lesson."""
    page = open_page(site / "index.html", folder=site)
    page.set_viewport_size({"width": 1200, "height": 800})
    links = page.locator(".md-sidebar--primary a")
    assert links.count() > 0
    assert not any(link.is_visible() for link in links.all())
    page.locator("label.md-header__button[for=__drawer]").click()
    expect(
        page.locator(".md-sidebar--primary").get_by_text("Newton's third law", exact=True)
    ).to_be_visible()


@pytest.mark.one_browser
def test_the_menu_of_a_narrow_window_is_opened_and_left_by_keyboard(
    site: Path, open_page: OpenPage
) -> None:
    page = a_lesson(open_page, site, 1024, 600)
    button = page.get_by_role("button", name="Navigation")
    for _ in range(4):  # skip to the text, then the head
        page.keyboard.press("Tab")
        if button.evaluate("(one) => one === document.activeElement"):
            break
    expect(button).to_be_focused()
    for key in ("Enter", "Space"):
        page.keyboard.press(key)
        expect(button).to_have_attribute("aria-expanded", "true")
        expect(page.locator("nav.md-nav--primary a:focus")).to_be_visible()
        page.keyboard.press("Escape")
        expect(button).to_have_attribute("aria-expanded", "false")
        expect(button).to_be_focused()


@pytest.mark.one_browser
def test_the_part_that_was_pressed_is_the_one_that_is_marked(
    site: Path, open_page: OpenPage
) -> None:
    """The theme measures from the first thing in its main part: ours stood there, for paper."""
    page = a_lesson(open_page, site, 1366, 768)
    parts = page.locator(".md-nav--secondary a.md-nav__link").locator("visible=true")
    parts.nth(2).click()
    expect(parts.nth(2)).to_contain_class("md-nav__link--active")
    expect(parts.nth(3)).not_to_contain_class("md-nav__link--active")
    folded = page.locator(".md-sidebar--primary a[href^='ta/']")
    assert folded.count() > 0
    assert not any(link.is_visible() for link in folded.all())


@pytest.mark.one_browser
def test_in_a_low_window_head_and_foot_leave_with_the_page(site: Path, open_page: OpenPage) -> None:
    """A laptop at 200 %: 300 px were left between them."""
    page = a_lesson(open_page, site, 683, 384)
    page.evaluate("scrollTo(0, 1000)")
    for part in (".md-header", ".carts-bar"):
        expect(page.locator(part)).not_to_be_in_viewport()
