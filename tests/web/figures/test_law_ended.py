"""A law that does not end, or not soon: it is ended, with more time where Python starts slowly."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.figures.law_writing import SPRING, STARTS, bench, opened, press, write
from tests.web.runtime.booted import hurried

__all__ = ["bench"]  # a fixture

pytestmark = pytest.mark.browser

SLOW = """\
def force(overlap, rate):
    x = 0
    for i in range(200):
        for j in range(90):
            x = x + j * overlap
    return 100 * overlap + 0 * x
"""


@pytest.mark.one_browser
def test_a_law_that_takes_too_long_is_ended_and_told_and_the_text_stays(
    open_page: OpenPage, bench: Path
) -> None:
    page = opened(open_page, bench)
    page.evaluate(hurried(3))  # nobody needs to wait for all of its seconds
    write(page, SLOW)
    press(page, "Judge")
    expect(page.locator(".carts-law-fault")).to_contain_text("was ended")
    box = page.get_by_label("Your law, in Python")
    assert box.input_value() == SLOW
    # The number in the message is of seconds: no line of the text is marked, to be typed over.
    assert box.evaluate("box => box.selectionStart === box.selectionEnd")
    page.get_by_role("button", name="Judge", exact=True).click()
    stop = page.get_by_role("button", name="Stop", exact=True)
    expect(stop).to_be_focused()
    stop.press("Enter")
    expect(page.locator(".carts-law-fault")).to_have_text("Stopped.", timeout=STARTS)
    write(page, SPRING)
    press(page, "Run")
    expect(page.locator(".carts-law-fault")).to_have_text("")


@pytest.mark.one_browser
def test_where_python_starts_slowly_a_law_is_given_longer(open_page: OpenPage, bench: Path) -> None:
    """Four seconds are ten usual laws here, and one on a laptop that has become old."""
    page = opened(open_page, bench)
    page.evaluate(hurried(12))  # a start of a quarter of a second is three, and three are slow
    write(page, SLOW)
    press(page, "Judge")
    expect(page.locator(".carts-law-fault")).to_contain_text(
        re.compile(r"more than (?:[5-9]|1\d|20) s")
    )
