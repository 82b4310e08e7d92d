"""A lesson as it is printed: what is on paper says something there."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.site.pages_of import SHEET

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


def test_the_hard_cases_are_a_table_on_paper_of_few_sheets(site: Path, open_page: OpenPage) -> None:
    """As on a phone, each cell on a line of its own, they took fifteen sheets, mostly white."""
    page = open_page(site / "accuracy" / "hard-cases.html", folder=site)
    assert len(SHEET.findall(page.pdf(format="A4"))) <= 7


def test_what_leads_to_a_table_is_printed_above_it(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "accuracy" / "measured.html", folder=site)
    page.emulate_media(media="print")
    commands = page.locator("article p:has(+ .md-typeset__scrollwrap)")
    assert commands.count() > 5
    for command in commands.all():
        expect(command).to_have_css("break-after", "avoid")


def test_what_happens_in_a_run_is_not_told_on_two_sheets(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "physics" / "map.html", folder=site)
    page.emulate_media(media="print")
    expect(page.locator(".carts-story").first).to_have_css("break-inside", "avoid")
