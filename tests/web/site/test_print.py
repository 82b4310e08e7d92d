"""A lesson as it is printed: what is on paper says something there."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]


def test_a_form_for_readings_that_nobody_has_chosen_is_not_printed(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "worksheets" / "real-carts.html", folder=site)
    expect(page.locator("#real-own")).to_have_attribute("data-state", "live", timeout=60_000)
    page.emulate_media(media="print")
    expect(page.locator("#real-own")).to_be_hidden()
    expect(page.locator("#real-film .carts-measured-figure").first).to_be_visible()
    expect(page.locator("#real-film .carts-measured-unit").first).to_be_hidden()
