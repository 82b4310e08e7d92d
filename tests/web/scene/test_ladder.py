"""The ladder in “What is in this model”: nothing before it is opened; then all, in order."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from sim.dynamics.relevance.ranking import ranked_effects
from sim.scene import read_fence, read_scene
from sim.scene.said import capital
from tests.web.conftest import OpenPage
from tests.web.scene.given.counted_requests import COUNT, asked
from tests.web.scene.given.widget_site import FENCES, LIVE, live, on_scene, widget_site

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture

MODULES = """() => new Promise((resolve) => setTimeout(() => resolve(
    [...document.querySelectorAll("#meeting .carts-ladder-box")].length), 300))"""


@pytest.mark.one_browser
def test_nothing_is_made_or_asked_before_a_reader_opens_the_model(
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(widget_site / "meeting.html"))
    page.evaluate(COUNT)
    on_scene(page, 'await el.set({ "A.mass": 2 })')
    assert page.evaluate(MODULES) == 0
    assert asked(page) == ["run"]
    page.locator("#meeting .carts-model > summary").click()
    rungs = page.locator("#meeting .carts-ladder li")
    expect(rungs.first).to_be_visible(timeout=LIVE)
    assert asked(page) == ["run", "relevance"]
    # With the reader's own value: the same sentences, in order, as Python says them here.
    plain = dict(read_fence(FENCES["meeting"]).plain)
    plain["carts"] = {**plain["carts"], "A": {**plain["carts"]["A"], "mass": 2}}
    rows = [
        rung for rung in ranked_effects(read_scene(plain)) if rung.changes or rung.candidate.listed
    ]
    wanted = [capital(rung.sentence) for rung in rows]  # what nobody has a size for is left out
    texts = rungs.all_inner_texts()
    line = next(k for k, text in enumerate(texts) if "a graph cannot show:" in text)
    assert 0 < line < len(wanted)
    del texts[line]
    assert [text.split(" (", 1)[0] for text in texts] == [w.split(" (", 1)[0] for w in wanted]
    assert all(text.startswith(w) for text, w in zip(texts, wanted, strict=True))


@pytest.mark.one_browser
def test_another_value_tells_it_anew_and_a_closed_one_is_left_alone(
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(widget_site / "meeting.html"))
    page.locator("#meeting .carts-model > summary").click()
    rungs = page.locator("#meeting .carts-ladder li")
    expect(rungs.first).to_be_visible(timeout=LIVE)
    before = rungs.all_inner_texts()
    on_scene(page, 'await el.set({ "A.mass": 3 })')
    expect(rungs.first).not_to_have_text(before[0], timeout=LIVE)
    page.locator("#meeting .carts-model > summary").click()
    page.evaluate(COUNT)
    on_scene(page, 'await el.set({ "A.mass": 1 })')
    page.evaluate(MODULES)
    assert asked(page) == ["run"]
