"""Larger letters in a reader's browser: on a phone nothing of a scene or a question is cut off, nor
is the page wider than the window; on a laptop the picture stays large. Fingers, forced colours."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.site.accessibility import PALE, SMALL
from tests.web.site.pages_of import LEAST_LETTER, LETTERS, enlarge

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


@pytest.mark.parametrize("name", ["sandbox", "worksheets/newtons-third-law"])
def test_letters_twice_as_large_leave_the_picture_what_room_there_is(
    open_page: OpenPage, site: Path, name: str
) -> None:
    """The column of graphs grew with the letters, and left carts of the size of a thumbnail."""
    window = {"width": 1280, "height": 900}
    page = open_page(site / f"{name}.html", folder=site, viewport=window)
    enlarge(page, 32)
    expect(page.locator("html")).to_have_css("font-size", "40px")
    assert [one for one in page.evaluate(LETTERS) if one["size"] < LEAST_LETTER] == []


def test_the_head_of_a_page_fits_a_phone_whose_letters_are_twice_as_large(
    open_page: OpenPage, site: Path
) -> None:
    """The home page's has a button more: that of the answers."""
    page = open_page(site / "index.html", folder=site, viewport={"width": 360, "height": 740})
    enlarge(page, 32)
    expect(page.locator("html")).to_have_css("font-size", "40px")
    assert page.evaluate("document.documentElement.scrollWidth") <= 361
    enlarge(page, 24)
    page.set_viewport_size({"width": 320, "height": 700})
    frame, live = (
        page.locator(part).first.bounding_box() for part in (".carts-frame", ".carts-mark")
    )
    assert frame
    assert live
    assert live["x"] + live["width"] < frame["x"] + frame["width"]  # it was cut off


FINGER = 44  # px
PULLED = ".carts :is(.carts-button, .carts-slider)"


def test_what_a_finger_presses_or_pulls_is_44_px_high(open_page: OpenPage, site: Path) -> None:
    phone = {"viewport": {"width": 360, "height": 740}, "has_touch": True, "is_mobile": True}
    page = open_page(site / "index.html", folder=site, **phone)
    low = page.locator(PULLED).evaluate_all(
        """(parts, least) => parts.filter((one) => one.checkVisibility()
          && one.getBoundingClientRect().height < least - 0.01).map((one) => one.className)""",
        FINGER,
    )
    assert low == []
    assert page.evaluate(SMALL, 24) == []
    undo, reset = (one.bounding_box() for one in page.locator(".carts-reset-row button").all())
    assert undo
    assert reset
    apart = max(reset["x"] - undo["x"] - undo["width"], reset["y"] - undo["y"] - undo["height"])
    assert apart > 6  # px: who wants the one does not hit the other


def test_what_is_read_before_a_run_can_be_told_in_forced_colours(
    open_page: OpenPage, site: Path
) -> None:
    page = open_page(
        site / "worksheets" / "newtons-second-law.html", folder=site, forced_colors="active"
    )
    talk = page.locator(".carts-talk").first
    talk.evaluate("(box) => { box.hidden = false; }")
    expect(talk).to_be_visible()
    assert page.evaluate(PALE) == []
