"""A ruler and a stopwatch that a reader works: they measure the picture, not the run."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page, expect

from sim.scene import read_fence
from sim.scene.problem import SceneError
from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import LIVE, MEETING

pytestmark = pytest.mark.browser

PIXEL = 1.5  # px: a line is drawn to a tenth of a unit, and a mouse moves by whole pixels


@pytest.fixture
def page(site: Path, open_page: OpenPage) -> Page:
    page = open_page(
        site / "worksheets" / "newtons-first-law.html",
        folder=site,
        viewport={"width": 1366, "height": 768},
    )
    page.wait_for_selector("#after-the-hand[data-state=live]", timeout=LIVE, state="attached")
    page.evaluate(
        "document.dispatchEvent(new Event('carts-open-questions'))"
    )  # by the teacher's key
    return page


def seek(page: Page, t: float) -> None:
    page.evaluate(f"document.getElementById('after-the-hand').time = {t}")


def watch(page: Page) -> tuple[Locator, Locator, Locator]:
    tool = page.locator("#after-the-hand [data-tool=stopwatch]")
    return tool.locator("output"), tool.locator("[data-act=stop]"), tool.locator("[data-act=zero]")


@pytest.mark.one_browser
def test_a_stopwatch_counts_the_time_of_the_carts(page: Page) -> None:
    read, press, zero = watch(page)
    seek(page, 0.5)
    press.click()
    expect(press).to_have_text("Stop")
    seek(page, 1.25)
    expect(read).to_have_text("0.75")  # while it runs
    press.click()
    seek(page, 1.75)
    expect(read).to_have_text("0.75")
    press.click()  # it goes on from there
    seek(page, 2.0)
    press.click()
    expect(read).to_have_text("1.00")
    zero.click()
    expect(read).to_have_text("0.00")


@pytest.mark.one_browser
def test_the_next_reader_of_a_scene_begins_with_a_stopwatch_at_zero(page: Page) -> None:
    read, press, _ = watch(page)
    seek(page, 0.5)
    press.click()
    seek(page, 1.25)
    expect(read).to_have_text("0.75")
    # What “Start again” does to the inside of a scene.
    page.locator("#after-the-hand [data-tool=stopwatch]").evaluate(
        "tool => { const anew = tool.cloneNode(true);"
        " anew.querySelector('output').textContent = '0.00'; tool.replaceWith(anew); }"
    )
    expect(press).to_have_text("Start")
    press.click()
    seek(page, 1.5)
    expect(read).to_have_text("0.25")


@pytest.mark.one_browser
def test_time_that_is_pulled_back_is_never_counted_below_zero(page: Page) -> None:
    read, press, _ = watch(page)
    seek(page, 1.0)
    press.click()
    seek(page, 0.25)
    press.click()
    expect(read).to_have_text("0.00")


def number_on_the_track(page: Page, text: str) -> float:
    """px, the middle of a number under the track of the picture that is seen."""
    numbers = page.locator("#after-the-hand .carts-stage-wide .carts-number")
    box = numbers.get_by_text(text, exact=True).bounding_box()
    assert box
    return box["x"] + box["width"] / 2


@pytest.mark.one_browser
def test_the_ruler_agrees_with_the_numbers_under_the_track(page: Page) -> None:
    """Its ends are pulled to two numbers of the track: it reads their difference."""
    stage = page.locator("#after-the-hand .carts-stage-wide")
    stage.evaluate("(stage) => stage.scrollIntoView({ block: 'center', behavior: 'instant' })")
    for key, text in (("from", "1.4"), ("to", "1.8")):
        handle = stage.locator(f".carts-tape-end[data-end={key}] circle").last
        box = handle.bounding_box()
        assert box
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(number_on_the_track(page, text), y, steps=5)
        page.mouse.up()
        there = handle.bounding_box()
        assert there
        middle = there["x"] + there["width"] / 2
        assert middle == pytest.approx(number_on_the_track(page, text), abs=PIXEL)
    read = page.locator("#after-the-hand [data-tool=ruler] output")
    metres_per_px = 0.4 / (number_on_the_track(page, "1.8") - number_on_the_track(page, "1.4"))
    assert float(read.inner_text()) == pytest.approx(0.4, abs=2 * PIXEL * metres_per_px)
    expect(stage.locator(".carts-tape text")).to_have_text(f"{read.inner_text()} m")


@pytest.mark.one_browser
def test_the_ruler_is_moved_with_the_keyboard_too(page: Page) -> None:
    tool = page.locator("#after-the-hand [data-tool=ruler]")
    before = float(tool.locator("output").text_content() or "")
    end = tool.get_by_label("right end of the ruler")
    end.focus()
    for _ in range(4):
        page.keyboard.press("ArrowRight")
    assert float(tool.locator("output").inner_text()) == pytest.approx(before + 0.02)
    expect(end).to_have_attribute("aria-valuetext", "1.220 m")


@pytest.mark.one_browser
def test_a_page_without_tools_loads_nothing_of_them(site: Path) -> None:
    pages = {
        path.stem: path.read_text(encoding="utf-8")
        for path in (site / "worksheets").glob("newtons-*.html")
    }
    assert [name for name, text in pages.items() if "tools.js" in text] == ["newtons-first-law"]
    assert all("carts-tape" not in text for name, text in pages.items() if "first" not in name)


def test_a_tool_that_nobody_knows_is_refused() -> None:
    with pytest.raises(SceneError) as refused:
        read_fence({**MEETING, "with": ["telescope"]})
    assert "ruler, stopwatch" in refused.value.problems[0].message
