"""The theme's search, from the disk: whoever looks for a law finds its lesson before all else."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]


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
    site: Path, open_page: OpenPage, words: str, lesson: str
) -> None:
    page = open_page(site / "index.html", folder=site)
    field = page.locator(".md-search__input")
    field.click()
    page.keyboard.insert_text(words)
    field.press("Shift")  # the theme listens for keys
    first = page.locator(".md-search-result__item > a").first
    address = re.compile(rf"/worksheets/{lesson}\.html")
    expect(first).to_have_attribute("href", address, timeout=15_000)
