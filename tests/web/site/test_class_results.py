"""The page “Class results” of the built site, with the theme around the report."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.classroom.given.makers import random_class, sources
from tests.web.classroom.class_site import BANK, KEY, choose
from tests.web.conftest import OpenPage
from tests.web.shared_page import WINDOW
from tests.web.site.pages_of import DRAWN

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

BULLET = 20
"""px between the bar of a list and its text: less, and the bullets touch the bar."""

READ = 9.5
"""px: smallest letters that are read on a phone; the axes' own are 11 of 620 px."""

LETTERS = """() => [...document.querySelectorAll(".carts-class-plot text")].map((text) =>
  parseFloat(getComputedStyle(text).fontSize) * text.getScreenCTM().a)"""

MANY = 4
"""Lines of a belief in words."""


@pytest.fixture(scope="module")
def report(site: Path, open_for_all: OpenPage) -> Page:
    """The report on a class, whole; it is only looked at."""
    page = open_for_all(site / "teachers" / "class-results.html", folder=site)
    expect(page.locator("carts-class[data-state=ready]")).to_have_count(1, timeout=60_000)
    choose(page, [*sources(random_class(BANK, 12, prefix="BLUE-FOX")), KEY])
    expect(page.locator("carts-class[data-state=complete]")).to_have_count(1, timeout=60_000)
    return page


@pytest.fixture
def on_a_phone(report: Page) -> Iterator[Page]:
    report.set_viewport_size({"width": 360, "height": 800})
    report.evaluate(DRAWN)
    yield report
    report.set_viewport_size(WINDOW)  # type: ignore[arg-type]


def test_the_bullets_of_what_to_talk_about_stand_clear_of_the_bar(report: Page) -> None:
    talk = report.locator(".carts-class-talk").first
    expect(talk).to_be_visible()
    assert float(talk.evaluate("one => parseFloat(getComputedStyle(one).paddingLeft)")) > BULLET


LINES = """cell => {
  const range = document.createRange();
  range.selectNodeContents(cell);
  return new Set([...range.getClientRects()].map((line) => Math.round(line.top))).size;
}"""


def test_on_a_phone_a_row_is_a_few_lines_and_a_code_word_one(on_a_phone: Page) -> None:
    """Tables are pushed aside there: nothing is gained by a word, or three letters, on a line."""
    page = on_a_phone
    page.evaluate("document.querySelectorAll('details').forEach(one => one.open = true)")
    beliefs = page.locator(".carts-class-table.overview").first.locator("td:last-child")
    assert max(int(belief.evaluate(LINES)) for belief in beliefs.all()) < MANY
    word = page.locator(".carts-class-table.students td", has_text="BLUE-FOX-1").first
    assert int(word.evaluate(LINES)) == 1


def test_letters_of_plots_can_be_read_on_a_phone(on_a_phone: Page) -> None:
    """A plot is pushed aside, as a table is; the page around it stays."""
    expect(on_a_phone.locator(".carts-class-plot").first).to_be_visible()
    assert min(on_a_phone.evaluate(LETTERS)) >= READ
    assert on_a_phone.evaluate("document.documentElement.scrollWidth") == 360
