"""Browsers killed 50 ms after the last key, again and again: what was not kept is counted."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path

from playwright.sync_api import sync_playwright

from tests.web.question.killed_browser import lost_answers
from tests.web.question.question_site import ALL_KINDS, prepare, write_page

from .tried import RIGHT, SILENT, Row

AFTER = 0.05  # s after the last key
KILLS = 10  # of each browser; `make bench AREA=answers` kills at random times, and more often


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
            yield _row(browser, len(lost))


def _row(browser: str, lost: int) -> Row:
    name = f"killed 50 ms after the last key: {browser}"
    return Row(name, SILENT if lost else RIGHT, f"{lost} of {KILLS} lost", "")
