"""A page whose ready-made settings change what stands at the end of the track."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.web.conftest import OpenPage, SharePage
from tests.web.scene.given.against_ends import AGAINST, AT_PEAK, ends
from tests.web.scene.given.widget_site import live, on_scene, widget_site, write_page

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

__all__ = ["widget_site"]  # a fixture

NAMES = {
    "foam": ("the foam", "foam", "foam"),
    "soft spring": ("the spring", "spring", "spring"),
    "board": ("the board", "board", "board"),
    "wall": ("the wall", "wall", "wall"),
}
"""In sentences, in labels, and where one end need not be told from the other."""

TOUCHED = """return ["wide", "narrow"].map((kind) => {
  const stage = el.querySelector(`.carts-stage-${kind}`);
  const cart = stage.querySelector(".carts-cart");
  const [centre] = cart.getAttribute("transform").match(/[\\d.]+/);
  const box = cart.querySelector('[data-part="box"]');
  const face = stage.querySelector(".carts-wall-face").getAttribute("d").split("M")[1];
  const xs = [...`M${face}`.matchAll(/[ML]([\\d.]+) /g)].map(([, x]) => Number(x));
  return [Number(centre) + Number(box.getAttribute("width")) / 2, Math.max(...xs)];
});"""
"""Where the cart ends, and how far the face of what it touches comes, in both pictures."""


@pytest.fixture
def against(shared_page: SharePage, widget_site: Path) -> Page:
    return live(shared_page(write_page(widget_site, "against", AGAINST)), "against")


def part(page: Page, selector: str, name: str = "against") -> Locator:
    return page.locator(f"#{name} {selector}")


def press(page: Page, preset: str, name: str = "against") -> None:
    part(page, f'[data-preset="{preset}"]', name).click()
    expect(part(page, f'[data-preset="{preset}"]', name)).to_have_attribute("aria-pressed", "true")


def is_named(page: Page, preset: str, name: str = "against") -> None:
    """Wherever the page names what A runs into."""
    body, _, kind = NAMES[preset]
    expect(part(page, ".carts-events", name)).to_contain_text(f"A touches {body}.")
    key = part(page, '.carts-graph[data-quantity="F"] .carts-key', name)
    expect(key).to_have_text(f"on A by {body}on {body} by A")
    expect(part(page, '[data-view="bars"] tr.carts-wall th', name)).to_have_text(f"{kind} + Earth")
    on_scene(page, AT_PEAK, name=name)
    expect(part(page, ".carts-lens-note", name)).to_contain_text(f"A and {body}: squeezed by")
    expect(part(page, '.carts-lens [data-part="name"]', name).last).to_have_text(kind)
    expect(part(page, ".carts-alone li", name).first).to_contain_text(f"force on A by {body}: ")
    arrows = part(page, ".carts-stage-wide .carts-push text", name)
    expect(arrows.last).to_contain_text(f"on {body} by A: ")
    expect(part(page, f"#{name}-described", name)).to_contain_text(f"Force on A by {body}: ")


def test_each_button_brings_its_name_and_its_picture(against: Page) -> None:
    expect(part(against, '[aria-pressed="true"]').first).to_have_text("foam")  # as it begins
    for preset in ("foam", "soft spring", "board", "wall", "foam"):
        press(against, preset)
        expect(part(against, '.carts-preset[aria-pressed="true"]')).to_have_text([preset])
        is_named(against, preset)
        drawn = part(against, '.carts-stage-wide [data-part="thing"]')
        expect(drawn).to_have_count(0 if preset == "wall" else 1)
        for front, deepest in on_scene(against, TOUCHED, name="against"):
            assert deepest == pytest.approx(front, abs=0.2)


def test_undo_and_reset_bring_it_back(against: Page) -> None:
    press(against, "board")
    press(against, "soft spring")
    part(against, ".carts-undo").click()
    expect(part(against, '.carts-preset[aria-pressed="true"]')).to_have_text(["board"])
    is_named(against, "board")
    part(against, ".carts-reset").click()
    expect(part(against, '.carts-preset[aria-pressed="true"]')).to_have_text(["foam"])
    is_named(against, "foam")


def test_two_scenes_on_a_page_keep_their_own_names(open_page: OpenPage, widget_site: Path) -> None:
    other: dict[str, Any] = {**ends(right_is="spring"), "id": "other"}
    page = live(open_page(write_page(widget_site, "two", AGAINST, other)), "against")
    live(page, "other")
    press(page, "board")
    is_named(page, "board")
    is_named(page, "soft spring", "other")
    press(page, "wall", "other")
    is_named(page, "wall", "other")
    is_named(page, "board")


def test_a_link_brings_it_to_another_page_and_a_bad_one_is_refused(
    against: Page, open_page: OpenPage, widget_site: Path
) -> None:
    press(against, "soft spring")
    part(against, ".carts-take summary").click()
    part(against, "[data-take=link]").click()
    address = part(against, ".carts-take textarea").input_value()
    assert "track.right_is=spring" in address
    other = open_page(widget_site / "against.html")
    for link in (address, f"{address.split('#')[0]}#carts:against?track.right_is=mud&t=0"):
        other.goto("about:blank")
        other.goto(link)
        live(other, "against")
        if link == address:
            is_named(other, "soft spring")
            expect(part(other, '.carts-preset[aria-pressed="true"]')).to_have_text(["soft spring"])
    told = "right_is must be wall, foam, spring or board (got mud)"
    expect(part(other, ".carts-note")).to_contain_text(told)
    is_named(other, "foam")


def test_what_stands_on_the_left_gives_way_in_the_lens_too(
    open_page: OpenPage, widget_site: Path
) -> None:
    track = {"left": "wall", "right": "open", "left_is": "foam"}
    carts = {"A": {**AGAINST["carts"]["A"], "velocity": "-0.5 m/s"}}
    fence = {**ends(**track), "id": "left", "carts": carts, "presets": {}}
    page = live(open_page(write_page(widget_site, "left", fence)), "left")
    on_scene(page, AT_PEAK, name="left")
    faces = on_scene(
        page,
        """return [0, 1].map((side) => {
          const box = el.querySelector(`.carts-lens [data-side="${side}"] [data-part="body"]`);
          const [x, width] = ["x", "width"].map((name) => Number(box.getAttribute(name)));
          return side ? x : x + width;
        });""",
        name="left",
    )
    assert faces[0] == pytest.approx(faces[1], abs=0.2)
    expect(part(page, '.carts-lens [data-part="name"]', "left").first).to_have_text("foam")
