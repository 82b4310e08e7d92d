"""What a frame of a run costs the browser, counted, not timed: a weak laptop draws 60 a second."""

from __future__ import annotations

import json
import statistics
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.web.conftest import OpenPage

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

MOST_RESTYLED = 60
"""Elements a frame: carts, arrows, curves and numbers of one scene. A lesson has thousands; a sheet
that asks `:root:has(…)` has the browser look at every paragraph again (386 were counted)."""
MOST_CHANGED = 40  # nodes that come or go in a run, not in each frame: none is needed for a number
COUNTED = "disabled-by-default-devtools.timeline"

COUNT_NODES = """(scene) => {
  window.changed = 0;
  const seen = new MutationObserver((all) => { window.changed += all.length; });
  seen.observe(scene, { childList: true, subtree: true });
}"""


def test_a_frame_restyles_what_moves_and_nothing_else_of_a_long_lesson(
    site: Path, browser: Browser, open_page: OpenPage
) -> None:
    page = open_page(site / "worksheets" / "newtons-third-law.html", folder=site)
    scene = page.locator("carts-scene#third-own")
    scene.evaluate("(scene) => scene.ready")
    scene.evaluate("(scene) => scene.scrollIntoView({ behavior: 'instant' })")
    scene.locator(".carts-predict input[type=radio]").first.check()
    browser.start_tracing(page=page, categories=[COUNTED, "devtools.timeline"])
    scene.locator(".carts-certainty input").first.check()
    scene.locator(".carts-lock").click()  # now it plays by itself
    page.wait_for_function("() => document.getElementById('third-own').time > 0.1")
    scene.evaluate(COUNT_NODES)
    page.wait_for_function("() => document.getElementById('third-own').time > 1")
    traced = json.loads(browser.stop_tracing())["traceEvents"]
    counts = [
        event["args"]["elementCount"]
        for event in traced
        if event["name"] == "UpdateLayoutTree" and "elementCount" in event.get("args", {})
    ]
    assert len(counts) > 10
    assert statistics.median(counts) <= MOST_RESTYLED
    assert page.evaluate("window.changed") <= MOST_CHANGED
