"""Python in a page knows the zone of the browser: the day on a slip is that of the lesson."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.classroom.given.makers import answers, sources
from tests.web.classroom.class_site import BANK, KEY, NOTE_PRINT, choose
from tests.web.conftest import OpenPage

pytestmark = pytest.mark.browser

SAVED = "2026-09-01T23:30:00.000Z"


@pytest.mark.parametrize(
    ("zone", "day"),
    [
        ("Asia/Singapore", "2026-09-02"),
        pytest.param("America/Costa_Rica", "2026-09-01", marks=pytest.mark.one_browser),
    ],
)
def test_a_slip_shows_the_day_that_it_was_where_the_browser_is(
    zone: str, day: str, place: Path, open_page: OpenPage
) -> None:
    page = open_page(place, timezone_id=zone)
    expect(page.locator("carts-class[data-state=ready]")).to_have_count(1)
    file = answers(BANK, "FOX", "pre", {"item-0": "a"}, created=SAVED, saved=SAVED)
    choose(page, [*sources([file]), KEY])
    page.evaluate(NOTE_PRINT)
    page.get_by_role("button", name="Print slips for students").click(timeout=60_000)
    expect(page.locator(".carts-slip h3 small")).to_have_text(day)
