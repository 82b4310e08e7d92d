"""Nothing jumps, and every text can be read: every page of the built site."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page

from tests.web.conftest import OpenPage
from tests.web.pages_of import one_of_each_kind, pages

pytestmark = [pytest.mark.browser, pytest.mark.one_browser, pytest.mark.slow]

MOST_SHIFT = 0.01  # cumulative layout shift: a tenth of what counts as good

COUNT_SHIFTS = """
  window.shifted = 0;
  new PerformanceObserver((list) => {
    for (const entry of list.getEntries()) window.shifted += entry.value;
  }).observe({ type: "layout-shift", buffered: true });
"""


@pytest.mark.parametrize("width", [1280, 360])
def test_nothing_jumps_while_a_page_is_read_in(site: Path, open_page: OpenPage, width: int) -> None:
    page = open_page(site / "index.html", viewport={"width": width, "height": 800})
    page.add_init_script(COUNT_SHIFTS)
    # On a phone there is least room: all pages there, elsewhere one of each kind.
    for name in pages(site) if width == 360 else one_of_each_kind(site):
        page.goto((site / name).as_uri())
        page.wait_for_load_state()
        page.evaluate("document.fonts.ready")
        page.wait_for_timeout(300)  # what moves late moves within this
        assert page.evaluate("window.shifted") <= MOST_SHIFT, name


# Width of the window, colours that the reader prefers, and what the page is made for.
VIEWS = (
    (1280, "light", "screen"),
    (360, "light", "screen"),
    (360, "dark", "screen"),
    (1280, "dark", "screen"),
    (1280, "dark", "print"),
)


def test_every_text_can_be_told_from_what_lies_behind_it(site: Path, open_page: OpenPage) -> None:
    """On a desktop and a phone, in light and dark, and on paper from a dark screen."""
    page = open_page(site / "index.html")
    at_once(page)
    pale = (Path(__file__).parent / "contrast.js").read_text(encoding="utf-8")
    for name in pages(site):
        page.emulate_media(media="screen", color_scheme="light")
        page.goto((site / name).as_uri())
        page.wait_for_load_state()
        for width, scheme, media in VIEWS:
            page.set_viewport_size({"width": width, "height": 800})
            page.emulate_media(media=media, color_scheme=scheme)  # type: ignore[arg-type]
            page.wait_for_timeout(60)
            assert page.evaluate(pale) == [], (name, width, scheme, media)


def at_once(page: Page) -> None:
    """The theme fades colours of links: from now on in no time."""
    session = page.context.new_cdp_session(page)
    session.send("Animation.enable")
    session.send("Animation.setPlaybackRate", {"playbackRate": 1000})
