"""A teacher's kept draft is there before anything can be typed, with Python and without."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.teach.at_work import LESSON, WAIT, enter, saved, settled
from tests.web.conftest import OpenPage
from tests.web.kept_store import DRAFTS, written

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.one_browser]

NO_PYTHON = "window.Worker = class { constructor() { throw new Error('no worker'); } };"
KEPT = "Draft kept in this browser."


# What teacher mode keeps, as it lies in the browser; and the same put into one that has nothing.
TAKE = """async () => {
  const [{ name, version }] = (await indexedDB.databases()).filter(({ name }) =>
    name.endsWith("~teacher"));
  const asked = indexedDB.open(name);
  const base = await new Promise((done) => (asked.onsuccess = () => done(asked.result)));
  const all = (request) => new Promise((done) => (request.onsuccess = () => done(request.result)));
  const stores = [];
  for (const kind of base.objectStoreNames) {
    const store = base.transaction(kind).objectStore(kind);
    if (store.keyPath !== null || store.autoIncrement) throw new Error("keys lie beside values");
    stores.push([kind, await all(store.getAllKeys()), await all(store.getAll())]);
  }
  base.close();
  return { name, version, stores };
}"""
PUT = """async ({ name, version, stores }) => {
  const asked = indexedDB.open(name, version);
  asked.onupgradeneeded = () => stores.forEach(([kind]) => asked.result.createObjectStore(kind));
  const base = await new Promise((done) => (asked.onsuccess = () => done(asked.result)));
  for (const [kind, keys, values] of stores) {
    const filled = base.transaction(kind, "readwrite");
    keys.forEach((key, k) => filled.objectStore(kind).put(values[k], key));
    await new Promise((done) => (filled.oncomplete = done));
  }
  base.close();
}"""


@pytest.fixture(scope="module")
def typed(lessons: Path, browser: Browser) -> tuple[Any, str]:
    """A draft that was typed once for all tests of this file: what is kept, and its text."""
    page = browser.new_page()
    page.goto((lessons / "worksheets" / f"{LESSON}.html").as_uri())
    enter(page)
    piece = page.locator(".carts-teach-piece").filter(has_text="Text Newton's second law").first
    piece.locator("summary").click()
    area = piece.get_by_label("Text in Markdown")
    area.fill(area.input_value().replace("# Newton's second law", "# An hour of work", 1))
    settled(page)
    expect(page.locator(".carts-teach-state")).to_have_text(KEPT)
    kept, text = page.evaluate(TAKE), saved(page).decode()
    assert "# An hour of work" in text
    page.close()
    return kept, text


def with_draft(open_page: OpenPage, lessons: Path, typed: tuple[Any, str]) -> tuple[Page, str]:
    """A page beside a lesson of which a draft is kept, and the draft's text."""
    page = open_page(lessons / "404.html")
    page.evaluate(PUT, typed[0])
    return page, typed[1]


def opened(page: Page, lessons: Path) -> None:
    """Go to the lesson, which opens in teacher mode."""
    page.goto((lessons / "worksheets" / f"{LESSON}.html").as_uri() + "#teacher")


def test_without_python_a_kept_draft_is_what_is_shown_and_changed(
    lessons: Path, open_page: OpenPage, typed: tuple[Any, str]
) -> None:
    page, draft = with_draft(open_page, lessons, typed)
    page.add_init_script(NO_PYTHON)
    opened(page, lessons)
    page.wait_for_selector(".carts-teach[data-state=unchecked]", timeout=WAIT)
    area = page.get_by_label("Text of this block")
    expect(area).to_have_value(draft)
    expect(page.locator(".carts-teach-state")).to_have_text(KEPT)
    area.press("Control+End")
    page.keyboard.type("More.")
    written(page, DRAFTS)
    page.reload()
    page.wait_for_selector(".carts-teach[data-state=unchecked]", timeout=WAIT)
    assert "An hour of work" in area.input_value()
    assert area.input_value().endswith("More.")


def test_no_published_text_can_be_typed_over_while_the_draft_comes_back(
    lessons: Path, open_page: OpenPage, typed: tuple[Any, str]
) -> None:
    page, draft = with_draft(open_page, lessons, typed)
    page.add_init_script(
        """window.shown = new Set();
        setInterval(() => {
          for (const { textContent } of document.querySelectorAll(".carts-teach-piece summary"))
            if (/^Text (Newton's second law|An hour)/.test(textContent)) shown.add(textContent);
        }, 2);"""
    )
    opened(page, lessons)
    page.wait_for_selector(".carts-teach[data-state=ready]", timeout=WAIT)
    assert saved(page).decode() == draft
    assert page.evaluate("[...window.shown]") == ["Text An hour of work changed"]


def test_a_draft_that_was_put_aside_is_no_longer_said_to_be_back(
    lessons: Path, open_page: OpenPage, typed: tuple[Any, str]
) -> None:
    page, _ = with_draft(open_page, lessons, typed)
    opened(page, lessons)
    page.wait_for_selector(".carts-teach[data-state=ready]", timeout=WAIT)
    expect(page.locator(".carts-teach-status")).to_contain_text("is back")
    page.click(".carts-teach-reset")
    page.get_by_role("button", name="Yes, go back").click()
    settled(page)
    expect(page.locator(".carts-teach-status")).to_have_text("")
