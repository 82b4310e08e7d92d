"""A scene on one screen of a school laptop: picture, Play, clock, sliders and two graphs."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page

from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import LIVE
from tests.web.site.lessons_with_scenes import LESSONS
from tests.web.site.pages_of import DRAWN, LEAST_LETTER, LETTERS

pytestmark = [pytest.mark.browser, pytest.mark.slow]

HEAD, BAR = 48, 39  # px of the theme's head and of “My answers”, which stay on screen
LAPTOP, PHONE, PROJECTOR = (1366, 768), (360, 740), (1280, 720)


BOTTOMS = """(parts) => [...document.querySelectorAll("carts-scene")].flatMap((scene) => {
    const { top } = scene.getBoundingClientRect();
    return Object.entries(parts).flatMap(([part, most]) =>
        [...scene.querySelectorAll(part)].filter((one) => one.checkVisibility()).slice(0, most)
            .map((one) => ({ name: `${scene.id} ${part}`,
                bottom: Math.round(one.getBoundingClientRect().bottom - top) })));
})"""
WIDTHS = """() => [...document.querySelectorAll(".carts-stage")].filter((one) =>
    one.checkVisibility()).map((one) => Math.round(one.getBoundingClientRect().width))"""


LENGTHS = """() => [...document.querySelectorAll("carts-scene .carts-cart")].filter((one) =>
    one.checkVisibility()).map((cart) => {
        const side = (name) =>
            cart.querySelector(`[data-part=face-${name}]`).getBoundingClientRect();
        return { name: `${cart.closest("carts-scene").id} ${cart.dataset.body}`,
            length: side("right").right - side("left").left };
    })"""


def too_low(page: Page, height: int, parts: dict[str, int]) -> list[str]:
    """What of the first few of each part cannot be seen with the top of its scene."""
    room = height - HEAD - BAR
    found = page.evaluate(BOTTOMS, parts)
    assert found
    return [f"{one['name']}: {one['bottom']} px" for one in found if one["bottom"] > room]


TOLD_WHOLE = """async (scene) => {
    await scene.reveal();
    const end = scene.querySelector(".carts-end");
    if (end?.checkVisibility()) end.click();
    scene.time = 0;
}"""


def told_whole(scene: Locator) -> None:
    """Its run, seen to the end, without a prediction."""
    scene.evaluate(TOLD_WHOLE)


def all_shown(page: Page) -> None:
    for scene in page.locator("carts-scene").all():
        scene.and_(page.locator("[data-state=live]")).wait_for(timeout=LIVE)
        told_whole(scene)


def opened(site: Path, open_page: OpenPage, lesson: str, screen: tuple[int, int]) -> Page:
    width, height = screen
    page = open_page(
        site / "worksheets" / f"{lesson}.html",
        folder=site,
        viewport={"width": width, "height": height},
    )
    page.evaluate(
        "document.dispatchEvent(new Event('carts-open-questions'))"
    )  # by the teacher's key
    return page


def turned(page: Page, screen: tuple[int, int]) -> None:
    """The same page on another screen, drawn anew."""
    page.set_viewport_size({"width": screen[0], "height": screen[1]})
    page.evaluate(DRAWN)


def large_enough(page: Page, least: float) -> None:
    """Carts to take hold of, at least `least` px long, and letters to read."""
    carts, letters = page.evaluate(LENGTHS), page.evaluate(LETTERS)
    assert carts and letters
    assert [one for one in carts if one["length"] < least] == []
    assert [one for one in letters if one["size"] < LEAST_LETTER] == []


@pytest.mark.parametrize(
    "lesson",
    [LESSONS[0], *(pytest.param(name, marks=pytest.mark.one_browser) for name in LESSONS[1:])],
)
def test_what_one_plays_with_is_seen_together_and_large_enough_on_every_screen(
    site: Path, open_page: OpenPage, browser_name: str, lesson: str
) -> None:
    """On a phone and a laptop; and a class sees the question, the picture and a graph together."""
    page = opened(site, open_page, lesson, PHONE)
    # Play is dead until the lock: before that, what is asked stands below the picture.
    before_lock = {"carts-scene:not(.carts-asks) .carts-play": 1, ".carts-asks .carts-ask": 1}
    assert too_low(page, PHONE[1], {".carts-stage": 1, **before_lock}) == []
    turned(page, LAPTOP)
    parts = {".carts-stage": 1, ".carts-play": 1, ".carts-clock": 1, ".carts-slider": 99}
    assert too_low(page, LAPTOP[1], {**parts, ".carts-lock": 1}) == []
    before = page.evaluate(WIDTHS)
    if browser_name == "chromium":
        turned(page, PROJECTOR)
        assert too_low_for_a_class(page) == []
        turned(page, LAPTOP)
    all_shown(page)
    assert too_low(page, LAPTOP[1], {**parts, ".carts-plot": 2}) == []
    assert page.evaluate(WIDTHS) == before  # the picture never shrinks
    large_enough(page, least=64)
    if browser_name == "chromium":  # whose bars are laid over the page, as on a phone
        turned(page, PHONE)
        assert too_low(page, PHONE[1], {".carts-stage": 1, ".carts-play": 1}) == []
        large_enough(page, least=36)


def too_low_for_a_class(page: Page) -> list[str]:
    """On a projector: the question before Reveal, Play and a graph after it too."""
    low = []
    for scene in page.locator("carts-scene").all():
        scene.and_(page.locator("[data-state=live]")).wait_for(timeout=LIVE)
        asks = scene.locator(".carts-predict").count() > 0
        scene.locator(".carts-project").press("Enter")
        low += low_on_projector(scene, ".carts-stage", *((".carts-ask",) if asks else ()))
        told_whole(scene)
        parts = (".carts-stage", ".carts-play", ".carts-plot", *((".carts-ask",) if asks else ()))
        low += low_on_projector(scene, *parts)
        # By key: a run that is drawn between a mouse's down and its up moves the button away.
        scene.locator(".carts-project").press("Enter")
    return low


def low_on_projector(scene: Locator, *parts: str) -> list[str]:
    """What cannot be seen without scrolling."""
    found = []
    for part in parts:
        box = scene.locator(part).filter(visible=True).first.bounding_box()
        if box is None or box["y"] + box["height"] > PROJECTOR[1]:
            found.append(f"{scene.get_attribute('id')} {part}: {box}")
    return found
