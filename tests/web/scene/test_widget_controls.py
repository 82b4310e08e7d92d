"""Sliders, boxes, keys and the element's own functions: what a reader can change."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import SharePage
from tests.web.scene.given.widget_site import PLAY, PLAYS, live, on_scene, widget_site, write_page

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture


@pytest.mark.one_browser
def test_a_slider_and_its_box_are_one(shared_page: SharePage, widget_site: Path) -> None:
    page = live(shared_page(widget_site / "meeting.html"))
    control = page.locator('#meeting [data-set="A.mass"]')
    box, slider = control.locator("[type=text]"), control.locator("[type=range]")
    mass = page.locator('#meeting [data-body="A"] [data-quantity="mass"]')
    slider.focus()
    slider.press("ArrowRight")
    expect(mass).to_have_text("0.6")
    expect(box).to_have_value("0.6")
    box.fill("1,5")
    box.press("Enter")
    expect(mass).to_have_text("1.5")
    assert slider.input_value() == "1.5"
    box.fill("750 g")
    box.press("Enter")
    expect(mass).to_have_text("0.75")
    expect(box).to_have_value("0.75")
    box.fill("1.23456")
    box.press("Enter")
    expect(mass).to_have_text("1.23")
    expect(box).to_have_value("1.23456")
    box.blur()
    expect(box).to_have_value("1.23456")
    box.fill("8")  # a value that is being typed is left alone
    on_scene(page, "await el.set({ 'A.velocity': 0.7 })")
    expect(box).to_have_value("8")
    box.press("ControlOrMeta+a")
    box.press_sequentially("1,5 kg")
    box.press("Tab")
    expect(box).to_have_value("1.5")
    page.locator("#meeting .carts-reset").click()
    expect(mass).to_have_text("0.5")
    expect(box).to_have_value("0.5")


WRONG = (
    ("1,000", "1,000 can mean 1 or 1000"),
    ("one", "not a number"),
    ("99", "mass of A: 0.5 to 4.0 kg"),
    ("1e309", "too large"),
    ("2 s", "kg"),
    ("-1 kg", "mass of A: 0.5 to 4.0 kg"),
    ("100 kg", "mass of A: 0.5 to 4.0 kg"),
    ("-1000 g", "greater than 0 kg"),
)


@pytest.mark.one_browser
def test_a_wrong_number_is_explained_beside_its_box(
    shared_page: SharePage, widget_site: Path
) -> None:
    """One after another; what is said of one goes with the right number that is typed after it."""
    page = live(shared_page(widget_site / "meeting.html"))
    control = page.locator('#meeting [data-set="A.mass"]')
    box, error = control.locator("[type=text]"), control.locator(".carts-error")
    mass = page.locator('#meeting [data-body="A"] [data-quantity="mass"]')
    for typed, said in WRONG:
        box.fill(typed)
        box.press("Enter")
        expect(error).to_be_visible()
        assert said in error.inner_text(), typed
        expect(mass).to_have_text("0.5")
        box.fill("0.5")
        box.press("Enter")
        expect(error).to_be_hidden()


TYPE_TWO = """(box, texts) => {
  box.focus();
  for (const text of texts) {
    box.value = text;
    box.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
  }
}"""


@pytest.mark.one_browser
def test_a_run_that_arrives_late_does_not_unsay_what_was_typed_since(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "meeting.html"))
    control = page.locator('#meeting [data-set="A.mass"]')
    box = control.locator("[type=text]")
    box.evaluate(TYPE_TWO, ["0.6", "one"])
    expect(page.locator('#meeting [data-body="A"] [data-quantity="mass"]')).to_have_text("0.6")
    expect(control.locator(".carts-error")).to_contain_text("not a number")
    expect(control.locator(".carts-error")).to_be_visible()
    expect(box).to_have_value("one")
    page.locator("#meeting .carts-reset").click()
    expect(control.locator(".carts-error")).to_be_hidden()
    expect(box).to_have_value("0.5")


def test_everything_is_reached_by_keyboard(shared_page: SharePage, widget_site: Path) -> None:
    page = live(shared_page(widget_site / "meeting.html"))
    world, clock = page.locator("#meeting .carts-world"), page.locator("#meeting .carts-clock")
    world.focus()
    page.keyboard.press("ArrowRight")
    expect(clock).to_have_text("0.040")
    page.keyboard.press("ArrowLeft")
    expect(clock).to_have_text("0.000")
    page.keyboard.press("End")
    expect(clock).to_have_text("6.000")
    page.keyboard.press("Home")
    page.keyboard.press(" ")
    expect(page.locator("#meeting .carts-play")).to_have_text("Pause")
    page.wait_for_function(PLAYS)
    page.keyboard.press(" ")
    expect(page.locator("#meeting .carts-play")).to_have_text("Play")
    reached = set()
    for _ in range(30):
        page.keyboard.press("Tab")
        reached.add(page.evaluate("document.activeElement.className.split(' ').at(-1)"))
    assert {"carts-scrub", "carts-play", "carts-speed", "carts-slow", "carts-slider"} <= reached
    assert {"carts-number-box", "carts-reset", "carts-window", "carts-sign"} <= reached


@pytest.mark.one_browser
def test_a_table_is_filled_when_it_is_opened(shared_page: SharePage, widget_site: Path) -> None:
    page = live(shared_page(widget_site / "meeting.html"))
    on_scene(page, "await el.set({ 'A.velocity': 1 })")
    table = page.locator('#meeting [data-quantity="v"] details')
    table.locator("summary").click()
    expect(table.locator("tbody tr").first.locator("td").nth(1)).to_have_text("1.00")


@pytest.fixture
def play(shared_page: SharePage, widget_site: Path) -> Page:
    return live(shared_page(write_page(widget_site, "play", PLAY)), "play")


def value(page: Page, target: str) -> str:
    return page.locator(f'#play [data-set="{target}"] .carts-number-box').input_value()


@pytest.mark.one_browser
def test_presets_are_undone_and_reset(play: Page) -> None:
    scene = play.locator("#play")
    undo = scene.locator(".carts-undo")
    expect(undo).to_be_disabled()
    scene.locator(".carts-preset", has_text="heavy hits light").click()
    mass = scene.locator('[data-set="A.mass"] .carts-number-box')
    expect(mass).to_have_value("4.0")
    scene.locator(".carts-preset", has_text="elastic").click()
    expect(mass).to_have_value("0.5")  # a preset starts from the lesson's values
    undo.click()
    expect(mass).to_have_value("4.0")
    scene.locator(".carts-reset").click()
    expect(mass).to_have_value("0.5")
    undo.click()
    expect(mass).to_have_value("4.0")


def test_carts_and_arrows_are_pulled_at_the_start(play: Page) -> None:
    def pull(selector: str, by: float) -> None:
        box = play.locator(f"#play .carts-stage-wide {selector}").bounding_box()
        assert box
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        play.mouse.move(x, y)
        play.mouse.down()
        play.mouse.move(x + by / 2, y, steps=3)
        play.mouse.move(x + by, y)
        play.mouse.up()

    metre = on_scene(
        play,
        """const box = el.querySelector('.carts-stage-wide [data-part="box"]');
        return box.getBBox().width * box.getScreenCTM().a / 0.12;""",
        name="play",
    )
    cart = '.carts-cart[data-body="A"] [data-part="box"]'
    pull(cart, 0.31 * metre)
    expect(play.locator('#play [data-set="A.position"] .carts-number-box')).to_have_value("0.7")
    pull('.carts-velocity[data-body="A"] [data-part="text"]', -100)
    expect(play.locator('#play [data-set="A.velocity"] .carts-number-box')).to_have_value("0.20")
    expect(play.locator("#play .carts-reset")).to_be_enabled()
    on_scene(play, "el.time = 0.5;", name="play")
    pull(cart, -0.3 * metre)
    assert value(play, "A.position") == "0.7"  # only at the start
