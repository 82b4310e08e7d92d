"""Browsers whose stores are missing or refuse, for pages that keep answers."""

from __future__ import annotations

from playwright.sync_api import Page

from tests.web.question.question_site import ready

NO_DATABASE = "Object.defineProperty(window, 'indexedDB', { get() { throw new Error('no'); } });"
NO_TEXT_STORE = (
    "Object.defineProperty(window, 'localStorage', { get() { throw new Error('no'); } });"
)
REFUSING = """IDBObjectStore.prototype.put = () => {
  throw new DOMException("full", "QuotaExceededError");
};"""


def again_with(page: Page, script: str) -> Page:
    page.add_init_script(script)
    page.reload()
    return ready(page)
