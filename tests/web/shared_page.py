"""A page that the tests of a file use one after another: Python starts in it once.

Before every test the page is as it came: its elements are made anew from the file, its stores are
empty, the window is as wide as at first. What cannot be put back no test may leave behind: it fails
at its own end where it does. A test that adds scripts, routes or listeners of its own, or whose
subject is the start, wants `open_page`.

Files of one folder that differ in their `<main>` alone are one page: it is opened from a copy that
lies beside them and is now the one, now the other, so that it may also be loaded again.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from playwright.sync_api import ConsoleMessage, Page

from tests.web.last_words import LastWords

MAIN = re.compile(r"<main>(.*)</main>", re.S)
Size = dict[str, int]
NO_FILE = "Failed to load resource"  # sites of tests have not all scripts; the built one is asked
WINDOW: Size = {"width": 1280, "height": 720}  # as the driver opens one
# Elements leave first: what they keep as they go does not outlive the stores.
ANEW = """async (main) => {
  document.activeElement?.blur();
  const place = document.querySelector("main");
  place.replaceChildren();
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  localStorage.clear();
  sessionStorage.clear();
  for (const { name } of await indexedDB.databases()) {
    const asked = indexedDB.open(name);
    const base = await new Promise((done) => (asked.onsuccess = () => done(asked.result)));
    const stores = [...base.objectStoreNames];
    const emptied = base.transaction(stores, "readwrite");
    for (const store of stores) emptied.objectStore(store).clear();
    await new Promise((done) => (emptied.oncomplete = done));
    base.close();
  }
  history.replaceState(null, "", location.pathname);
  place.innerHTML = main;
  scrollTo(0, 0);
}"""
# In the window and around what `ANEW` makes anew. Names with a bar before them are the page's own,
# and the driver's: they come as Python starts.
LEFT = """() => ({
  names: Object.getOwnPropertyNames(window).filter((name) => !/^(\\d+$|_)/.test(name)),
  beside: [...document.body.children].map(({ localName }) => localName),
  classes: [document.documentElement, document.body].map(({ className }) => className),
  python: document.documentElement.dataset.python === "failed",
})"""


class SharedPage:
    """One open page, the copy that it was opened from, and what it complains of."""

    def __init__(self, page: Page, copy: Path) -> None:
        self.page, self.words = page, LastWords(page)
        self._copy = copy
        self._complaints: list[str] = []
        page.on("pageerror", lambda error: self._complaints.append(str(error)))
        page.on("console", self._hear)
        self._first = self._left()
        self._names = set(self._first.pop("names"))

    def _hear(self, said: ConsoleMessage) -> None:
        if said.type == "error" and not said.text.startswith(NO_FILE):
            self._complaints.append(said.text)

    def begin(self, file: Path, window: Size) -> Page:
        """The page as it comes from `file` in a window of this size."""
        self._copy.write_text(file.read_text(encoding="utf-8"), encoding="utf-8")
        self.page.set_viewport_size(window)  # type: ignore[arg-type]
        if self._is_chromium():  # the other driver cannot, so that no test there does
            self.page.emulate_media(media="null")
        self.page.mouse.move(0, 0)
        self.page.evaluate(ANEW, parts(file)[1])
        self._complaints.clear()
        return self.page

    def end(self) -> None:
        """Fail where the next test would not find the page as this one did."""
        assert self._complaints == []
        assert len(self.page.context.pages) == 1, "a page beside it was left open"
        now = self._left()
        more = set(now.pop("names")) ^ self._names
        assert not more, f"a test left something in the window: {more}"
        assert now == self._first, "a test left something in the page"

    def _left(self) -> dict[str, Any]:
        if self.page.locator("#carts-lesson").count():  # its foot comes when answers are back
            self.page.locator(".carts-bar[data-ready]").wait_for(state="attached")
        return dict(self.page.evaluate(LEFT))

    def _is_chromium(self) -> bool:
        browser = self.page.context.browser
        return browser is not None and browser.browser_type.name == "chromium"


def parts(file: Path) -> tuple[tuple[str, str], str]:
    """The text of a page around its `<main>`, and what stands in it."""
    text = file.read_text(encoding="utf-8")
    found = MAIN.search(text)
    assert found, f"{file.name} has no <main> to be made anew"
    return (text[: found.start()], text[found.end() :]), found[1]
