"""A predicted curve: typed or drawn, compared by what it says of the motion."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import SharePage
from tests.web.scene.given.widget_site import live, lock, widget_site, write_page

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture


@pytest.mark.one_browser
def test_a_curve_is_typed_or_drawn_and_compared_by_features(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "curve.html"), "curve")
    heights = page.locator("#curve .carts-height")
    for k, height in enumerate((0, 5, 9, 5)):
        heights.nth(k).fill(str(height))
    page.locator("#curve .carts-pad").scroll_into_view_if_needed()
    pad = page.locator("#curve .carts-pad").bounding_box()
    assert pad
    end = (pad["x"] + pad["width"] * 350 / 360, pad["y"] + pad["height"] * 94 / 170)
    page.mouse.click(*end, button="right")
    expect(heights.nth(4)).to_have_value("")
    page.keyboard.press("Escape")
    page.mouse.click(*end)
    expect(heights.nth(4)).to_have_value("3")
    lock(page, "curve")
    compared = page.locator("#curve .carts-compared")
    expect(compared).to_contain_text("starts from zero: your curve yes, the run yes")
    expect(compared).to_contain_text("is zero again at the end: your curve no, the run yes")


@pytest.mark.one_browser
def test_a_height_that_is_cleared_or_cannot_be_read_or_drawn_is_none_and_a_decimal_comma_is_one(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "curve.html"), "curve")
    heights, told = page.locator("#curve .carts-height"), page.locator("#curve .carts-heights")
    missing = page.locator("#curve .carts-predict-error")
    for k, height in enumerate(("0", "2,5", "9", "5", "0")):
        heights.nth(k).fill(height)
    for typed, said in (("", "Type a number"), ("high", "“high” is not a number."), ("3 N", "3 N")):
        heights.nth(2).fill(typed)
        heights.nth(2).press("Tab")
        page.locator("#curve .carts-lock").click()
        expect(missing).to_contain_text("Give all five heights first")
        expect(told.locator(".carts-error")).to_contain_text(said)
        expect(heights.nth(2)).to_have_value(typed)
    for typed in ("90", "-1"):  # a height that nobody typed would be none of theirs
        heights.nth(2).fill(typed)
        heights.nth(2).press("Tab")
        page.locator("#curve .carts-lock").click()
        expect(missing).to_contain_text("Give all five heights first")
        expect(told.locator(".carts-error")).to_contain_text("0 to 10, please.")
        expect(heights.nth(2)).to_have_value(typed)
    heights.nth(2).fill("10")
    heights.nth(2).press("Tab")
    expect(told.locator(".carts-error")).to_have_count(0)
    page.reload()
    expect(heights.nth(1)).to_have_value("2.5")
    lock(live(page, "curve"), "curve")
    expect(page.locator("#curve .carts-compared")).to_contain_text("your curve")


@pytest.mark.one_browser
def test_curves_of_velocity_and_position_have_a_direction_and_need_no_contact(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "speed.html"), "speed")
    for k, height in enumerate((6, 4, 2, -2, -2)):
        page.locator("#speed .carts-height").nth(k).fill(str(height))
    lock(page, "speed")
    compared = page.locator("#speed .carts-compared")
    expect(compared).to_contain_text("stays the same from start to end: your curve no, the run yes")
    expect(compared).to_contain_text("turns round: your curve yes, the run no")
    drawn = page.locator("#speed .carts-pad [data-part=answer]").get_attribute("d") or ""
    heights = {point.split()[1] for point in drawn.lstrip("M").split("L")}
    assert heights == {"10"}, "one height, above the line of rest: to the right"


PUSHED = {
    "id": "pushed", "title": "A steady push, then none", "slow": "never", "until": "2.6 s",
    "carts": {"A": {"mass": "0.5 kg", "position": "0.3 m"}}, "track": {"length": "2.4 m"},
    "effects": [{"push": {"cart": "A", "force": "0.2 N", "until": "2 s"}}],
    "predict": {"ask": "Draw the velocity of A.", "curve": "v.A"},
}  # fmt: skip


@pytest.mark.one_browser
@pytest.mark.parametrize(
    ("drawn", "evenly", "level"),
    [
        ((0, 3, 6, 9, 9), "yes", "yes"),
        ((0, 9, 9, 9, 0), "no", "no"),
        ((0, 5, 8, 9, 9), "no", "yes"),
    ],
    ids=["as the run", "as fast as pushed", "gains less and less"],
)
def test_a_velocity_that_goes_with_the_push_differs_from_one_that_grows_with_it(
    shared_page: SharePage, widget_site: Path, drawn: tuple[int, ...], evenly: str, level: str
) -> None:
    page = live(shared_page(write_page(widget_site, "pushed", PUSHED)), "pushed")
    for k, height in enumerate(drawn):
        page.locator("#pushed .carts-height").nth(k).fill(str(height))
    lock(page, "pushed")
    compared = page.locator("#pushed .carts-compared")
    for feature, mine in (
        ("changes evenly in the first half", evenly),
        ("stays the same in the last quarter", level),
    ):
        expect(compared).to_contain_text(f"{feature}: your curve {mine}, the run yes")
    expect(compared).not_to_contain_text("turns round")


UNDER = """(name) => {
  const pad = document.querySelector(`#${name} .carts-pad`);
  const points = [...pad.querySelectorAll("[data-part]")].flatMap((line) => {
    const whole = line.getTotalLength();
    const at = (k) => line.getPointAtLength((whole * k) / 399);
    return whole ? Array.from({ length: 400 }, (_, k) => at(k)) : [];
  });
  return [...pad.querySelectorAll("[data-way]")].filter((text) => {
    const { x, y, width, height } = text.getBBox();
    return points.some((p) => p.x > x && p.x < x + width && p.y > y && p.y < y + height);
  }).map((text) => text.textContent);
}"""


@pytest.mark.one_browser
@pytest.mark.parametrize(
    "drawn",
    [(0, 0, 0, 0, 0), (0, 3, 6, 2, 2), (9, 9, 2, 2, 2), (2, 2, -2, -2, -9), (-9, 0, 3, 2, 1)],
)
def test_no_curve_goes_through_the_words_of_its_pad(
    shared_page: SharePage, widget_site: Path, drawn: tuple[int, ...]
) -> None:
    """“at rest” was struck out by the velocity that was drawn."""
    page = live(shared_page(write_page(widget_site, "pushed", PUSHED)), "pushed")
    for k, height in enumerate(drawn):
        page.locator("#pushed .carts-height").nth(k).fill(str(height))
    assert page.evaluate(UNDER, "pushed") == []
    lock(page, "pushed")
    expect(page.locator("#pushed .carts-compared")).to_contain_text("your curve")
    assert page.evaluate(UNDER, "pushed") == []
