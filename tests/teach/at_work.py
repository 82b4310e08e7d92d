"""A teacher at work on a lesson, for the tests of teacher mode."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from playwright.sync_api import Page

from tests.web.conftest import OpenPage

LESSON = "newtons-second-law"
WAIT = 60_000  # ms; on a busy computer


def open_teacher(open_page: OpenPage, site: Path, name: str = LESSON, **context: Any) -> Page:
    """The page of a lesson with teacher mode opened by its link."""
    page = open_page(site / "worksheets" / f"{name}.html", folder=site, **context)
    enter(page)
    return page


def enter(page: Page) -> None:
    """Through the link of the lesson into teacher mode."""
    page.click(".carts-teach-door a")
    page.wait_for_selector(".carts-teach[data-state=ready]", timeout=WAIT)


def settled(page: Page) -> None:
    """Wait until Python has seen what was typed: a field waits for a pause, then for Python."""
    page.wait_for_selector(".carts-teach[data-state=ready]:not(:has([data-waits]))", timeout=WAIT)


# Firefox tells Playwright nothing of downloads: the file is taken where the page makes it.
CATCH = """() => {
  window.files = [];
  const make = URL.createObjectURL;
  URL.createObjectURL = (blob) => {
    if (blob.type !== "text/javascript") window.files.push(blob); // a worker may start just then
    return make.call(URL, blob);
  };
}"""
BYTES = """async () => [...new Uint8Array(await window.files.pop().arrayBuffer())]"""


def saved(page: Page, button: str = ".carts-teach-save") -> bytes:
    page.evaluate(CATCH)
    page.click(button)
    page.wait_for_function("() => window.files.length")  # a page that still works makes it later
    return bytes(page.evaluate(BYTES))
