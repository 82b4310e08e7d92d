"""What a reader sees of a page: whether Python lives, an answer is kept, what it says."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace

from playwright.sync_api import BrowserContext, Error, Page

from .table import WORD, Fault

SETTLED = 30.0  # s in which Python starts or fails, on a machine that others use too
SOON = 5.0  # s within which something must be said
STEP = 0.1  # s between two looks
PICTURE = "/assets/images/favicon.png"
EARLIER = "an earlier answer"

STATE = "document.documentElement?.dataset.python ?? ''"
TOLD = """[...document.querySelectorAll(
  "[role=alert], [role=status], .carts-note, .carts-bar, .carts-q-saved")]
  .map((note) => note.offsetHeight ? note.textContent.trim() : "")
  .filter((text) => text &&
    /not|can.t|missing|damaged|too|lost|nothing|Opening|wait|still|slow|interrupted/i.test(text))"""
FLUSHED = 3.0
"""s after the last key: the browser was asked to write to the disk (`SETTLE_AFTER`), and did."""
FIELDS = """[...document.querySelectorAll("carts-question :is(textarea, input, select)")]
  .filter((its) => its.offsetParent && !its.disabled && !its.readOnly)
  .length"""
DEAD = """[...new Set([...document.querySelectorAll(":not(:defined)")]
  .filter((its) => its.offsetHeight).map((its) => its.localName))]"""
FIELD = "carts-question textarea:not([readonly], :disabled):visible"
BOX = "[...document.querySelectorAll('carts-question textarea')].map((its) => its.value).join('|')"
KEPT = """[...document.querySelectorAll("carts-question .carts-q-saved")].some((its) =>
  its.textContent === "Saved")"""
NAMES = """[...document.querySelectorAll("carts-question")].map((its) => its.id)"""


@dataclass(frozen=True)
class Seen:
    """`told`: what was said, and `after` how many s of this machine. `kept`: of pages with a
    question."""

    live: bool
    kept: bool
    fields: int
    told: tuple[str, ...]
    after: float
    dead: tuple[str, ...]
    again: bool  # what was answered before is in its field

    @property
    def said(self) -> bool:
        return bool(self.told) and self.after <= SOON


def look(context: BrowserContext, fault: Fault, where: str, usual: frozenset[str]) -> Seen:
    """Open the page and use it. `usual`: what it says when nothing is wrong."""
    page = context.new_page()
    if fault.without:
        page.add_init_script(fault.without)
    try:
        page.goto(where, wait_until="commit", timeout=1000 * SETTLED * fault.slow)
    except Error as refused:  # the browser's own words
        return Seen(False, False, 0, (str(refused),), 0, (), False)
    began, slow = time.monotonic(), fault.slow
    after = _settled(page, usual, lambda: (time.monotonic() - began) / slow)
    live = page.evaluate(STATE) == "ready"
    again = EARLIER in page.evaluate(BOX)
    kept = _answered(page, slow, fault.word)
    told = _new(page, usual)
    while not told and not (live and kept) and time.monotonic() - began < SOON * slow:
        page.wait_for_timeout(1000 * STEP)
        told = _new(page, usual)
    if told and after == float("inf"):
        after = 0.0  # said at the key, within `_answered`
    found = Seen(live, kept, page.evaluate(FIELDS), told, after, tuple(page.evaluate(DEAD)), again)
    page.close()
    return replace(found, again=_still(context, where)) if fault.again else found


def _still(context: BrowserContext, where: str) -> bool:
    """Whether the earlier answer is there at one more visit."""
    page = context.new_page()
    page.goto(where)
    page.wait_for_selector(FIELD)
    page.wait_for_timeout(1000)
    found = EARLIER in page.evaluate(BOX)
    page.close()
    return bool(found)


def said(page: Page) -> frozenset[str]:
    """All that the page says now."""
    return frozenset(page.evaluate(TOLD))


def _new(page: Page, usual: frozenset[str]) -> tuple[str, ...]:
    return tuple(sorted(said(page) - usual))


def _settled(page: Page, usual: frozenset[str], clock: Callable[[], float]) -> float:
    """Waits until Python lives or not; s after which the page said something new, or infinity."""
    after = float("inf")
    while (now := clock()) < SETTLED:
        try:
            if after == float("inf") and _new(page, usual):
                after = now
            over = page.evaluate(STATE) in ("ready", "failed")
        except Error:  # between two documents
            over = False
        alarmed = after < now - 1 and page.query_selector(".carts-watchdog")
        idle = now > SOON and page.evaluate("!document.querySelector('carts-scene')")
        if over or alarmed or idle or (now > 2 * SOON and after < SOON):
            break
        page.wait_for_timeout(1000 * STEP)
    return after


def _answered(page: Page, slow: float = 1.0, word: str = WORD) -> bool:
    """Types one answer; whether the page says within `SOON` that it is kept."""
    box = page.locator(FIELD).first
    if not page.locator(FIELD).count():
        return False
    try:
        box.fill(word, timeout=1000 * SOON * slow)
    except Error:
        return False
    for _ in range(int(SOON * slow / STEP)):
        if page.evaluate(KEPT):
            return True
        page.wait_for_timeout(1000 * STEP)
    return False


def prepare(context: BrowserContext, fault: Fault, where: str) -> None:
    """Make what was there before this visit."""
    if not (fault.before or fault.earlier):
        return
    page = context.new_page()
    page.goto(where)
    if fault.earlier:
        page.wait_for_selector(FIELD)
        _answered(page, word=EARLIER)
        page.wait_for_timeout(1000 * FLUSHED)  # a visit lasts longer than its last key
    else:
        page.evaluate(_seed(page, fault.before))
    page.close()


def _seed(page: Page, script: str) -> str:
    """The script with this page's names in it; what the page itself has kept goes first."""
    site, name = (
        page.locator(f"meta[name=carts-{what}]").get_attribute("content") or ""
        for what in ("site", "page")
    )
    fields = page.evaluate(NAMES)
    script = script.replace("SITE", site).replace("PAGE", name).replace("FIELDS", str(fields))
    page.goto(page.url.rsplit("/", 2)[0] + PICTURE)  # of the same origin, without a script
    return f"""async () => {{ await new Promise((ok) => {{
      const gone = indexedDB.deleteDatabase("carts:{site}");
      gone.onsuccess = gone.onerror = gone.onblocked = ok; }});
      await ({script})(); }}"""


def usual(context: BrowserContext, where: str) -> frozenset[str]:
    """All that a page says where nothing is wrong, while it starts and when an answer is kept."""
    page = context.new_page()
    page.goto(where, wait_until="commit")
    found: set[str] = set()
    while (state := page.evaluate(STATE)) != "ready":
        if state == "failed":
            raise ValueError(f"nothing is wrong with {where}, and Python fails")
        found |= said(page)
        page.wait_for_timeout(1000 * STEP / 5)
    found |= said(page)
    _answered(page)
    found |= said(page)
    context.close()
    return frozenset(found)
