"""The strip of what each cart did: boundaries are dragged and moved by keys, the fit follows."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import SharePage
from tests.web.figures.measured_bench import LIVE, STARTS, benches
from tests.web.kept_store import MEASURED, written

__all__ = ["benches"]  # a fixture

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

EDGE = ".carts-measured-edge"
TARGET = 24  # px, of a finger


def contact(page: Page) -> dict[str, Any]:
    """The contact of the last report."""
    found = page.evaluate(
        "document.querySelector('carts-measured').report.contacts.find((one) => one.chosen)"
    )
    return dict(found)


def settled(page: Page) -> None:
    page.evaluate("document.querySelector('carts-measured').complete")


def fingers_find_each(page: Page) -> None:
    """Every handle is large enough, and none lies over another."""
    boxes = [page.locator(EDGE).nth(k).bounding_box() for k in range(4)]
    for first, second in (boxes[:2], boxes[2:]):
        assert first and second
        assert min(first["width"], first["height"], second["width"], second["height"]) >= TARGET
        apart = abs(first["x"] - second["x"]), abs(first["y"] - second["y"])
        assert max(apart) >= TARGET


def drag(page: Page, by: float) -> None:
    """The first boundary, by some px."""
    edge = page.locator(EDGE).nth(0)
    assert edge.get_attribute("role") == "slider"
    edge.scroll_into_view_if_needed()
    box = edge.bounding_box()
    assert box
    page.mouse.move(box["x"] + 12, box["y"] + 12)
    page.mouse.down()
    page.mouse.move(box["x"] + 12 + by, box["y"] + 12, steps=4)
    page.mouse.up()


def test_a_boundary_is_dragged_moved_by_keys_kept_and_put_back(
    benches: Path, shared_page: SharePage
) -> None:
    page = shared_page(benches / "film.html", window={"width": 360, "height": 800})
    expect(page.locator(LIVE)).to_have_count(1, timeout=STARTS)
    expect(page.locator(".carts-measured-spans")).to_be_hidden()
    page.locator(".carts-measured-fit").click()
    edges = page.locator(EDGE)
    expect(edges).to_have_count(4, timeout=2 * STARTS)
    settled(page)
    found = contact(page)
    assert page.evaluate("document.documentElement.scrollWidth") <= 360

    fingers_find_each(page)
    drag(page, -16)
    again = page.locator(".carts-measured-as-found")
    expect(again).to_be_visible(timeout=STARTS)
    settled(page)
    dragged = contact(page)
    assert dragged["from"] < found["from"] - 0.03
    assert dragged["until"] == pytest.approx(found["until"], abs=0.02)
    shared = [edges.nth(k).get_attribute("aria-valuenow") for k in (0, 2)]
    assert shared[0] == shared[1]  # of both carts

    edges.nth(0).focus()
    text = edges.nth(0).get_attribute("aria-valuetext")
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowRight")
    expect(edges.nth(0)).not_to_have_attribute("aria-valuetext", str(text))
    page.wait_for_function(
        "before => document.querySelector('carts-measured').report.contacts"
        ".find((one) => one.chosen).from > before",
        arg=dragged["from"],
    )
    settled(page)
    expect(edges.nth(0)).to_be_focused()
    kept = edges.nth(0).get_attribute("aria-valuenow")

    written(page, MEASURED)
    page.reload()
    expect(edges).to_have_count(4, timeout=2 * STARTS)
    expect(edges.nth(0)).to_have_attribute("aria-valuenow", str(kept))
    page.locator(".carts-measured-as-found").click()
    expect(page.locator(".carts-measured-as-found")).to_have_count(0, timeout=STARTS)
    settled(page)
    assert contact(page)["from"] == pytest.approx(found["from"])


ACROSS = """() => {
  const of = (name) => document.querySelector(name).getBoundingClientRect();
  const figure = of(".carts-measured-figure"), bar = of(".carts-measured-strip-bar");
  const at = (x) => figure.x + (figure.width * x) / 640;
  return [bar.left - at(78), bar.right - at(630)];
}"""
"""How far the ends of the strip are from those of the axis of time."""


def test_the_strip_lies_over_the_readings_that_it_tells_of_on_wide_and_narrow_pages(
    benches: Path, shared_page: SharePage
) -> None:
    page = shared_page(benches / "film.html")
    expect(page.locator(LIVE)).to_have_count(1, timeout=STARTS)
    page.locator(".carts-measured-fit").click()
    expect(page.locator(EDGE)).to_have_count(4, timeout=2 * STARTS)
    for width in (1600, 1280, 360):
        page.set_viewport_size({"width": width, "height": 800})
        left, right = page.evaluate(ACROSS)
        assert abs(left) < 3 and abs(right) < 3, width
