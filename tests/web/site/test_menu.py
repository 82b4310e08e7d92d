"""The menu of a narrow window: closed it is in nobody's way, opened it is whole."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage

pytestmark = pytest.mark.browser


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
