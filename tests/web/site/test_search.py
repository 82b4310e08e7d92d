"""The theme's search, from the disk: whoever looks for a law finds its lesson before all else."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]


@pytest.fixture(scope="module")
def searched(site: Path, open_for_all: OpenPage) -> Page:
    """A page in which one thing is looked for after another: the index is read once."""
    return open_for_all(site / "about.html", folder=site)


@pytest.mark.parametrize(
    ("words", "lesson"),
    [
        ("third law", "newtons-third-law"),
        ("momentum", "momentum-and-restitution"),
        ("hukum ketiga", "ms/newtons-third-law"),
        ("மூன்றாம் விதி", "ta/newtons-third-law"),
        ("牛顿第三", "zh-Hans/newtons-third-law"),
    ],
)
def test_a_lesson_is_found_before_the_page_that_tells_its_teacher_the_answers(
    searched: Page, words: str, lesson: str
) -> None:
    field = searched.locator(".md-search__input")
    field.click()
    field.fill("")
    expect(searched.locator(".md-search-result__item")).to_have_count(0)
    searched.keyboard.insert_text(words)
    field.press("Shift")  # the theme listens for keys
    first = searched.locator(".md-search-result__item > a").first
    address = re.compile(rf"/worksheets/{lesson}\.html")
    expect(first).to_have_attribute("href", address, timeout=15_000)
