"""Visits of a reader who types at once, on a computer whose store comes late."""

from __future__ import annotations

import random
from pathlib import Path

from playwright.sync_api import Browser, Page, expect

from tests.web.conftest import CONTEXT
from tests.web.question.answering import saved
from tests.web.question.broken_stores import late_store
from tests.web.question.question_site import ready

LATEST = 5.0
"""s after which the latest store opens: a laptop whose disk must first wake up."""
# So many ms as the address says.
LATE = """new Promise((open) =>
  setTimeout(open, Number(new URLSearchParams(location.search).get('late'))))"""
BOX = "#why textarea"


def lost_earlier(browser: Browser, name: str, file: Path, visits: int, seed: int) -> list[str]:
    """What a visit found instead of all that had been written in the visits before.

    A visit types before the page's scripts have come or while its store still opens, at any speed,
    then, once the store is open, adds a letter that must be there at the next one.
    """
    dice = random.Random(seed)
    context = browser.new_context(**CONTEXT[name])
    page = context.new_page()
    page.add_init_script(late_store(LATE))
    written, lost = "", []
    for _ in range(visits):
        late = 1000 * LATEST * dice.random() ** 2  # most come soon
        page.goto(f"{file.as_uri()}?late={late:.0f}", wait_until="commit")
        _type_early(page, dice)
        expect(ready(page).locator(BOX)).to_be_editable()
        found = page.locator(BOX).input_value()
        if written not in found:
            lost.append(f"{written!r} after {late:.0f} ms: {found!r}")
        letter = dice.choice("abcdefghijklmnopqrstuvwxyz")
        page.locator(BOX).press("End")
        page.locator(BOX).press_sequentially(letter)
        saved(page, "why")
        written = (found + letter)[-40:]
        if len(found) > 40:
            page.locator(BOX).fill(written)
            saved(page, "why")
    context.close()
    return lost


def _type_early(page: Page, dice: random.Random) -> None:
    page.wait_for_selector(BOX, state="attached")
    page.evaluate("css => document.querySelector(css).focus()", BOX)
    for _ in range(dice.randrange(1, 8)):
        page.keyboard.type(dice.choice("0123456789"), delay=dice.choice((0, 20, 80)))
