"""Browsers killed 50 ms after the last key, again and again: what was not kept is counted."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from playwright.sync_api import sync_playwright

from tests.browsers.webkit import missing, webkit
from tests.web.question_site import ALL_KINDS, prepare, write_page
from tests.web.test_crash import kill, lost_answers

from .tried import RIGHT, SILENT, UNTRIED, Row

AFTER = 0.05  # s after the last key
KILLS = 10  # of each browser; `make bench AREA=answers` kills at random times, and more often
PATIENCE = 20.0  # s
BOX = "#why textarea"
VALUE = f"return document.querySelector('{BOX}').value"
OPEN = f"const box = document.querySelector('{BOX}'); return box && !box.readOnly"


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
        if absent := missing():
            yield Row("killed: WebKit", UNTRIED, "", absent)
        else:
            yield _row("WebKit", _lost_in_webkit(Path(name) / "webkit", file))


def _row(browser: str, lost: int) -> Row:
    name = f"killed 50 ms after the last key: {browser}"
    return Row(name, SILENT if lost else RIGHT, f"{lost} of {KILLS} lost", "")


def _lost_in_webkit(folder: Path, file: Path) -> int:
    """As `lost_answers`, behind WebDriver. The kept files lie in `folder`."""
    folder.mkdir()
    lost, written = 0, ""
    for number in range(KILLS + 1):
        with suppress(Exception), webkit(folder) as window:  # it dies within
            window.go(file.as_uri())
            window.wait(OPEN, PATIENCE)
            lost += window.run(VALUE) != written
            if number == KILLS:
                break
            window.run(f"document.querySelector('{BOX}').value = ''")
            written = f"{number}: kept"
            window.type(BOX, written)
            time.sleep(AFTER)
            kill(folder)
    return lost
