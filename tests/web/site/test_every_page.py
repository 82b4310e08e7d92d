"""Every page of the built site, visited once: it complains of nothing, nothing jumps, every text
can be told from what lies behind it, and axe-core finds nothing, with all that can be opened open.

All pages from disk in one browser; from a server, wider and in the other browser a few that have
between them whatever pages have (in test_site_policy.py).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page

from tests.web.runtime.boot_site import ROOT
from tests.web.site.accessibility import PALE, RUN_AXE, SMALL
from tests.web.site.pages_of import (
    COUNT_SHIFTS,
    DRAWN,
    MOST_SHIFT,
    listen,
    of_each_kind,
    pages,
    shift_of,
)

pytestmark = [pytest.mark.browser, pytest.mark.one_browser, pytest.mark.slow]

OPEN_ALL = "for (const part of document.querySelectorAll('details')) part.open = true"
AXE = ROOT / "node_modules" / "axe-core" / "axe.min.js"
# The theme makes code that is wider than its place focusable a moment after it is laid out.
WIDE_CODE = """() => [...document.querySelectorAll("pre > code")].every((code) =>
  code.scrollWidth <= code.clientWidth || code.tabIndex === 0)"""

LEAST = 24  # px, for what is pressed or pulled

# Where axe does not look into elements of ours, it would still walk through all of them for every
# rule: on a page with scenes two seconds of the two and a quarter. Head and navigation likewise.
ARTICLE_ALONE = """() => {
  const article = document.querySelector("article") ?? document.body;
  for (const one of article.querySelectorAll("*"))
    if (one.localName.startsWith("carts-")) one.replaceChildren();
  if (article !== document.body) document.body.replaceChildren(article);
}"""

# Width of the window, colours that the reader prefers, and what the page is made for. The first is
# that in which a page is read in: on a phone there is least room.
VIEWS = (
    (360, "light", "screen"),
    (1280, "light", "screen"),
    (1280, "dark", "screen"),
    (360, "dark", "screen"),
    (1280, "dark", "print"),
)
# Colours belong to the kind of a page: of each kind one is looked at in all views, the others in
# that which differs most from how they were read in; and there axe looks at what an author wrote
# around the elements of ours.
FEWER = (VIEWS[2],)


@dataclass
class Found:
    """What was found on all pages; each row begins with the name of its page."""

    said: list[tuple[str, object]] = field(default_factory=list)
    jumps: list[tuple[str, object]] = field(default_factory=list)
    pale: list[tuple[str, object]] = field(default_factory=list)
    violations: list[tuple[str, object]] = field(default_factory=list)
    small: list[tuple[str, object]] = field(default_factory=list)


@pytest.fixture(scope="module")
def found(site: Path, browser: Browser) -> Found:
    all_, axe = Found(), AXE.read_text(encoding="utf-8")
    context = browser.new_context()
    page = context.new_page()
    at_once(page)
    page.add_init_script(COUNT_SHIFTS)
    heard = listen(page)
    chosen = set(of_each_kind(site))
    for name in pages(site):
        page.goto("about:blank")  # the page before is not laid out for a phone once more
        look(page, *VIEWS[0])
        heard.clear()  # what axe had to say of it, and what it said in pieces
        page.goto((site / name).as_uri())
        if (shift := shift_of(page)) > MOST_SHIFT:
            all_.jumps.append((name, (shift, page.evaluate("window.moved"))))
        all_.said += [(name, said) for said in heard]
        heard.clear()
        for view in VIEWS if name in chosen else FEWER:
            look(page, *view)
            page.evaluate(DRAWN)
            all_.pale += [(name, (view, text)) for text in page.evaluate(PALE)]
        if name in chosen:
            look(page, *VIEWS[1])
        page.evaluate(OPEN_ALL)
        page.wait_for_function(WIDE_CODE)
        all_.small += [(name, one) for one in page.evaluate(SMALL, LEAST)]
        if name not in chosen:
            page.evaluate(ARTICLE_ALONE)
        page.evaluate(axe)
        all_.violations += [
            (name, violation) for violation in page.evaluate(RUN_AXE, name in chosen)
        ]
    context.close()
    return all_


def at_once(page: Page) -> None:
    """The theme fades colours of links: from now on in no time."""
    session = page.context.new_cdp_session(page)
    session.send("Animation.enable")
    session.send("Animation.setPlaybackRate", {"playbackRate": 1000})


def look(page: Page, width: int, scheme: str, media: str) -> None:
    page.set_viewport_size({"width": width, "height": 800})
    page.emulate_media(media=media, color_scheme=scheme)  # type: ignore[arg-type]


def test_no_page_complains_from_disk(found: Found) -> None:
    """Of a broken policy, a missing file, an error of a script."""
    assert found.said == []


def test_nothing_jumps_on_a_phone_while_a_page_is_read_in(found: Found) -> None:
    assert found.jumps == []


def test_every_text_can_be_told_from_what_lies_behind_it(found: Found) -> None:
    """On a desktop and a phone, in light and dark, and on paper from a dark screen."""
    assert found.pale == []


def test_everything_to_press_or_pull_is_24_px_high_and_wide(found: Found) -> None:
    assert found.small == []


def test_every_page_passes_axe(found: Found) -> None:
    assert found.violations == []
