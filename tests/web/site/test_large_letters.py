"""Larger letters in a reader's browser, on a phone: nothing of a scene or a question is cut off,
nor is the page wider than the window."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

# What is beyond the edge of its scene or question, and cannot be scrolled to.
CUT = """() => {
  const parts = [...document.querySelectorAll(".carts-frame, carts-question, carts-quiz")];
  const scrolls = (part) => /auto|scroll/.test(getComputedStyle(part).overflowX);
  const inside = (part, root) =>
    part !== root && (scrolls(part) || inside(part.parentElement, root));
  return parts.flatMap((root) => [...root.querySelectorAll("*")]
    .filter((part) => part.getClientRects().length && !part.closest("svg, .katex-mathml"))
    .filter((part) => getComputedStyle(part).visibility !== "hidden")
    .filter((part) => part.getBoundingClientRect().right > root.getBoundingClientRect().right + 1)
    .filter((part) => !inside(part.parentElement, root))
    .map((part) => `${part.tagName} ${part.className} ${part.textContent.trim().slice(0, 30)}`));
}"""
PAGES = ("worksheets/newtons-third-law", "worksheets/test-forces-and-motion", "sandbox")


def enlarge(page: Page, size: int) -> None:
    """The size of letters in the settings of the browser, 16 where nobody has changed it."""
    session = page.context.new_cdp_session(page)
    session.send("Page.setFontSizes", {"fontSizes": {"standard": size, "fixed": size}})


@pytest.mark.parametrize(("width", "size"), [(360, 20), (320, 24)])
@pytest.mark.parametrize("name", PAGES)
def test_nothing_is_cut_off_beside_large_letters(
    open_page: OpenPage, site: Path, name: str, width: int, size: int
) -> None:
    window = {"width": width, "height": 800}
    page = open_page(site / f"{name}.html", folder=site, viewport=window)
    enlarge(page, size)
    expect(page.locator("html")).to_have_css("font-size", f"{1.25 * size:g}px")  # of the theme
    assert page.evaluate(CUT) == []
    assert page.evaluate("document.documentElement.scrollWidth") <= width + 1
    for whole in page.locator(".carts-bar-who").all():  # “no code word yet”
        assert whole.evaluate("(button) => button.scrollWidth - button.clientWidth") <= 1
