"""Browsers killed 50 ms after the last key, again and again: what was not kept is counted."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path

from playwright.sync_api import sync_playwright

from tests.browsers.killed_webkit import has_webkit, lost_in_webkit
from tests.web.question.killed_browser import lost_answers
from tests.web.question.question_site import ALL_KINDS, prepare, write_page

from .tried import RIGHT, SILENT, UNTRIED, Row

AFTER = 0.05  # s after the last key
KILLS = 10  # of each browser; `make bench AREA=answers` kills more often


def killed() -> Iterator[Row]:
    """A row for each browser that is here."""
    with tempfile.TemporaryDirectory() as name:
        site = prepare(Path(name) / "site")
        file = write_page(site, "kinds", ALL_KINDS)
        for browser in ("chromium", "firefox"):
            with sync_playwright() as driver:
                profile = Path(name) / browser
                profile.mkdir()
                lost = lost_answers(driver, browser, profile, file, [AFTER] * KILLS, told=False)
            yield _row(browser, lost)
        if has_webkit():
            profile = Path(name) / "webkit"
            profile.mkdir()
            yield _row("webkit", lost_in_webkit(profile, file, [AFTER] * KILLS))
        else:
            yield Row(_name("webkit"), UNTRIED, "", "python3-gi and gir1.2-webkit2-4.1")


def _name(browser: str) -> str:
    return f"killed 50 ms after the last key: {browser}"


def _row(browser: str, lost: list[str]) -> Row:
    told = f"{len(lost)} of {KILLS} lost"
    return Row(_name(browser), SILENT if lost else RIGHT, told, " | ".join(lost))
