"""The pages of a built site, and what they complain of."""

from __future__ import annotations

import re
from pathlib import Path

from playwright.sync_api import Page, expect

from sim.pages.language import language_folder

MOST_SHIFT = 0.01  # cumulative layout shift: a tenth of what counts as good
LATE = 300  # ms; what moves late, by an element of ours, moves within this
OURS = "[...document.querySelectorAll('*')].some((one) => one.localName.startsWith('carts-'))"
DRAWN = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
HALF_A_FORMULA = re.compile(r"Incorrect number of children for <m\w+/> tag\.")
SHEET = re.compile(rb"/Type\s*/Page[^s]")  # of a PDF
LETTERS = """() => [...document.querySelectorAll(".carts-stage text, .carts-plot text")]
    .filter((one) => one.checkVisibility() && one.textContent.trim()).map((one) => {
        const drawing = one.ownerSVGElement;
        const scale = drawing.getBoundingClientRect().width / drawing.viewBox.baseVal.width;
        return { name: `${one.closest("carts-scene").id} ${one.textContent}`,
            size: parseFloat(getComputedStyle(one).fontSize) * scale };
    })"""
LEAST_LETTER = 12.95  # px: 13, drawn in a picture that is a whole number of pixels wide
COUNT_SHIFTS = """
  window.shifted = 0;
  window.moved = [];
  new PerformanceObserver((list) => {
    for (const entry of list.getEntries()) {
      window.shifted += entry.value;
      for (const { node, previousRect: from, currentRect: to } of entry.sources)
        window.moved.push(`${node?.nodeName} ${node?.className}: ${entry.startTime} ms, `
          + `${[from.x, from.y, from.width, from.height]} to `
          + `${[to.x, to.y, to.width, to.height]}`);
    }
  }).observe({ type: "layout-shift", buffered: true });
"""


def pages(site: Path) -> list[str]:
    """The addresses of all pages, from the site's folder; the largest translated lesson stands for
    all of them.

    Such pages differ in their words only; `tests/pages/test_site.py` reads every one of them.
    """
    found = sorted(path.relative_to(site).as_posix() for path in site.rglob("*.html"))
    translated = [name for name in found if language_folder(name)]
    largest = max(translated, key=lambda name: (site / name).stat().st_size, default="")
    return [name for name in found if name == largest or name not in translated]


def listen(page: Page) -> list[str]:
    """What the page's console and its scripts complain of, from now on.

    Firefox draws a page while it arrives, and complains of a formula that is half there; that all
    of it is there in the end is for `test_every_formula_of_the_site_has_all_its_parts`.
    """
    heard: list[str] = []

    def hear(text: str) -> None:
        if not HALF_A_FORMULA.fullmatch(text):
            heard.append(text)

    page.on("console", lambda m: hear(m.text) if m.type in ("error", "warning") else None)
    page.on("pageerror", lambda error: hear(str(error)))
    return heard


def settle(page: Page) -> None:
    """Wait until all is loaded and Python runs where the page starts it: then all has been heard.

    A page that is left earlier is no fault of its own: Firefox then complains of the files under
    way that a service worker was to bring.
    """
    expect(page.locator("html:not(.no-js)")).to_be_attached()
    page.wait_for_load_state()
    for still in ("html[data-python=starting]", "carts-scene:not([data-state=live])"):
        page.wait_for_selector(still, state="detached", timeout=60_000)
    expect(page.locator("html[data-python=failed]")).to_have_count(0)


def shift_of(page: Page) -> float:
    """How far things have moved since the page was opened, Python's start included; the page runs
    `COUNT_SHIFTS` when it begins, which Firefox has no word for."""
    settle(page)
    page.evaluate("document.fonts.ready")
    if page.evaluate(OURS):
        page.wait_for_timeout(LATE)
    return float(page.evaluate("window.shifted"))


KINDS = re.compile(r'<(carts-[a-z]+)|<script src="[^"]*?([\w.-]+\.js)"|data-packages="([^"]+)"')


def of_each_kind(site: Path) -> list[str]:
    """Few pages that have every script, every element of ours and all packages between them."""
    of_page = {}
    for name in pages(site):
        found = KINDS.findall((site / name).read_text(encoding="utf-8"))
        of_page[name] = {next(filter(None, one)) for one in found}
    left, chosen = set[str]().union(*of_page.values()), list[str]()
    while left:
        chosen.append(max(of_page, key=lambda name: len(of_page[name] & left)))
        left -= of_page[chosen[-1]]
    return chosen


def enlarge(page: Page, size: int) -> None:
    """The size of letters in the settings of the browser, 16 where nobody has changed it."""
    session = page.context.new_cdp_session(page)
    session.send("Page.setFontSizes", {"fontSizes": {"standard": size, "fixed": size}})
