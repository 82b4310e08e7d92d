"""Three hints on the first scene: one at a time, gone by use, and in nobody's way."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.conftest import ROOT
from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import LIVE
from tests.web.site.lessons_with_scenes import LESSONS
from tests.web.site.pages_of import DRAWN, enlarge

pytestmark = [pytest.mark.browser, pytest.mark.slow]

SMALL, LAPTOP = {"width": 360, "height": 740}, {"width": 1366, "height": 768}
SETTLED = 300  # ms; it moves when nothing has changed for a moment
SEEN = "localStorage.getItem('carts-tour')"

COVERED = """scene => {
  const card = scene.querySelector(".carts-tour").getBoundingClientRect();
  const parts = [...scene.querySelectorAll(".carts-cart, .carts-velocity, .carts-acting")];
  const boxes = parts.map((part) => [part, part.getBoundingClientRect()]);
  return boxes.filter(([, box]) => box.width && box.left < card.right
    && box.right > card.left && box.top < card.bottom && box.bottom > card.top)
    .map(([part]) => part.getAttribute("class"));
}"""
"""What of the carts and their arrows lies under the hint."""


def hint(page: Page) -> Locator:
    return page.locator(".carts-tour .carts-tour-text")


def asks_first(lesson: str) -> bool:
    """Whether the first scene waits for a prediction; nothing is hinted at there."""
    text = (ROOT / "worksheets" / f"{lesson}.md").read_text(encoding="utf-8")
    return "predict:" in text.split("```scene")[1].split("```")[0]


@pytest.mark.one_browser
def test_hints_come_one_by_one_and_never_again_once_done(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "index.html", viewport=LAPTOP)
    expect(hint(page)).to_contain_text("Pull the arrow")
    arrow = page.locator(".carts-stage-wide .carts-velocity[data-body=A]")
    box = arrow.locator("[data-part=arrow]").bounding_box()
    assert box
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 30, y)
    page.mouse.up()
    expect(hint(page)).to_have_text("Press Play.")
    play = page.locator("#home .carts-play")
    play.click()
    expect(hint(page)).to_have_count(0)  # nothing distracts from the run
    page.wait_for_function("() => document.getElementById('home').time > 0.3")
    play.click()
    expect(hint(page)).to_contain_text("Pull the time back")
    page.locator("#home .carts-scrub").focus()
    page.keyboard.press("ArrowLeft")
    expect(hint(page)).to_have_count(0)
    page.reload()
    page.wait_for_selector("#home[data-state=live]", timeout=60_000)
    expect(hint(page)).to_have_count(0)
    assert page.locator(".carts-tour-here").count() == 0


@pytest.mark.one_browser
def test_hints_that_are_closed_stay_closed(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "sandbox.html", viewport=SMALL)
    expect(hint(page)).to_contain_text("Pull a cart")
    page.get_by_role("button", name="No more hints").press("Enter")
    expect(hint(page)).to_have_count(0)
    expect(page.locator("carts-scene .carts-play").first).to_be_focused()
    page.reload()
    page.wait_for_selector("carts-scene[data-state=live]", timeout=60_000)
    expect(hint(page)).to_have_count(0)


@pytest.mark.one_browser
def test_nothing_is_hinted_at_before_a_prediction_is_locked(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "worksheets" / "newtons-second-law.html", folder=site, viewport=LAPTOP)
    page.wait_for_selector("carts-scene.carts-asks[data-state=live]", timeout=60_000)
    expect(hint(page)).to_have_count(0)


@pytest.mark.one_browser
@pytest.mark.parametrize(
    ("name", "sizes"),
    [
        ("index", (SMALL, LAPTOP)),
        *(
            (name, (LAPTOP, SMALL))
            for name in (
                *("index", "sandbox", "physics/effects/incline", "physics/effects/push"),
                *(f"worksheets/{one}" for one in LESSONS if not asks_first(one)),
            )
        ),
    ],
    ids=lambda it: it if isinstance(it, str) else f"{it[0]['width']} px first",
)
def test_a_hint_covers_no_cart_and_no_arrow(
    name: str, sizes: tuple[dict[str, int], ...], site: Path, open_page: OpenPage
) -> None:
    """In a window as it came, and in one that was made smaller or larger since."""
    page = open_page(site / f"{name}.html", folder=site, viewport=sizes[0])
    scene = page.locator("carts-scene").first
    expect(hint(page)).to_have_count(1)
    clear_in(scene, sizes)
    expect(scene).to_have_attribute("data-state", "live", timeout=LIVE)
    scene.evaluate("scene => scene.reveal()")
    end = "scene => { scene.time = 60; scene.dispatchEvent(new Event('keyup')); }"
    scene.evaluate(end)
    expect(hint(page)).to_contain_text("Pull the time back")
    clear_in(scene, sizes[::-1])


def clear_in(scene: Locator, sizes: tuple[dict[str, int], ...]) -> None:
    """The first of the sizes is that of the window now. In another, the hint looks for room anew at
    whatever is done next."""
    covers_nothing(scene)
    for size in sizes[1:]:
        scene.page.set_viewport_size(size)  # type: ignore[arg-type]
        scene.page.evaluate(DRAWN)
        scene.dispatch_event("keyup")
        scene.page.wait_for_timeout(SETTLED)
        covers_nothing(scene)


def covers_nothing(scene: Locator) -> None:
    """As soon as it has settled, which a busy machine lets it do late."""
    for _ in range(20):
        if not (covered := scene.evaluate(COVERED)):
            return
        scene.page.wait_for_timeout(SETTLED)
    pytest.fail(f"the hint covers {covered}")


def test_on_a_phone_a_hint_goes_to_a_corner_of_the_sky_before_it_lies_on_the_scale(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "physics" / "worlds.html", folder=site, viewport=SMALL)
    expect(page.locator(".carts-tour")).to_have_attribute("data-at", "end")
    card = page.locator(".carts-tour").bounding_box()
    scale = page.locator(".carts-legend").locator("visible=true").first.bounding_box()
    assert card
    assert scale
    assert card["y"] + card["height"] < scale["y"]


@pytest.mark.one_browser
def test_a_hint_covers_no_cart_beside_letters_twice_as_large(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "index.html", viewport=SMALL)
    enlarge(page, 32)
    scene = page.locator("carts-scene").first
    expect(scene).to_have_attribute("data-state", "live", timeout=LIVE)
    expect(hint(page)).to_have_count(1)
    scene.dispatch_event("keyup")
    page.wait_for_timeout(SETTLED)
    clear_in(scene, (SMALL, LAPTOP))


NUMBERS = """(card) => {
  const own = card.getBoundingClientRect();
  return [...document.querySelectorAll(".carts-number")].filter((one) => {
    const { left, right, top, bottom, width } = one.getBoundingClientRect();
    const tails = 3; // px of room below a line, which figures have not
    const beside = right <= own.left || left >= own.right;
    return width && !beside && own.top < bottom - tails && top < own.bottom;
  }).map((one) => one.textContent);
}"""


@pytest.mark.one_browser
def test_a_hint_on_the_scale_leaves_the_numbers_of_the_ruler_free(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "physics" / "effects" / "push.html", folder=site, viewport=SMALL)
    scene = page.locator("carts-scene").first
    expect(scene).to_have_attribute("data-state", "live", timeout=LIVE)
    scene.evaluate("scene => { scene.time = 60; scene.dispatchEvent(new Event('keyup')); }")
    expect(hint(page)).to_contain_text("Pull the time back")
    card = page.locator(".carts-tour")
    expect(card).to_have_attribute("data-at", "low")
    assert card.evaluate(NUMBERS) == []
