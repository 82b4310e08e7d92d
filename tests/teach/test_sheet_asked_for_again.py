"""The watchdog asks again for a sheet that has not come; who waits for the first hears of it."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.teach.at_work import LESSON, WAIT
from tests.web.conftest import CONTEXT
from tests.web.held_back import WHEN_TOLD, holding_back

pytestmark = [pytest.mark.browser, pytest.mark.slow]


def test_teacher_mode_opens_when_its_sheet_is_just_coming_as_the_watchdog_looks(
    hosted_site: Path, browser: Browser, browser_name: str
) -> None:
    folder = hosted_site.parents[1]
    at = hosted_site.relative_to(folder).as_posix()
    context = browser.new_context(**CONTEXT[browser_name])
    with holding_back(folder, "/teacher.css") as (server, go_on):
        page = context.new_page()
        page.add_init_script(WHEN_TOLD)
        page.goto(f"{server}/{at}/worksheets/{LESSON}.html")
        door = page.locator(".carts-teach-door a")
        door.click()
        expect(door).to_have_text("Opening …")
        sheet = page.locator('link[href*="/teacher.css"]')
        expect(sheet).to_have_count(1)
        page.evaluate("watchdogLooks()")
        expect(sheet).to_have_attribute("media", "print")
        go_on.set()
        expect(sheet).to_have_attribute("media", "all")
        page.wait_for_selector(".carts-teach", timeout=WAIT)
        expect(door).to_have_text("Change this lesson")
    context.close()
