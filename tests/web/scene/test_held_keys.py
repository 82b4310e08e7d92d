"""A key that is held down acts once where twice would undo it; Enter asks once."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import SharePage
from tests.web.scene.given.widget_site import in_node, live, on_scene, widget_site

__all__ = ["widget_site"]  # a fixture


@pytest.fixture
def meeting(shared_page: SharePage, widget_site: Path) -> Page:
    return live(shared_page(widget_site / "meeting.html"))


def held(page: Page, key: str) -> None:
    for _ in range(4):  # from the second on it is a repeat: with one more or less, it acts twice
        page.keyboard.down(key)
    page.keyboard.up(key)


@pytest.mark.browser
@pytest.mark.one_browser
def test_the_space_bar_and_the_key_of_the_projector(meeting: Page) -> None:
    scene = meeting.locator("#meeting")
    scene.locator(".carts-speed").select_option(index=0)
    scene.locator(".carts-world").focus()
    held(meeting, " ")
    expect(scene.locator(".carts-transport")).to_have_class(re.compile("carts-is-playing"))
    held(meeting, "p")
    expect(scene).to_have_class(re.compile("carts-projector"))
    meeting.keyboard.press("Escape")
    on_scene(meeting, "el.time = 0;")
    scene.locator(".carts-world").focus()
    held(meeting, "ArrowRight")
    assert on_scene(meeting, "return el.time") > 0


FILM = """
const { View } = await import(`${source}/film/view.js`);
let held = false;
const canvas = Object.assign(new EventTarget(), {
  width: 100, height: 100, getContext: () => ({}), setPointerCapture: () => (held = true),
  hasPointerCapture: () => held,
  getBoundingClientRect: () => ({ left: 0, top: 0, width: 100, height: 100 }),
});
let set = 0;
const own = new View(canvas, () => (set += 1));
own.draw = () => {};
const send = (type, given) => canvas.dispatchEvent(Object.assign(new Event(type), given));
send("keydown", { key: "Enter", repeat: false });
for (const key of ["Enter", " "]) send("keydown", { key, repeat: true });
const keys = set;
for (const button of [2, 0])
  for (const type of ["pointerdown", "pointerup"])
    send(type, { button, clientX: 5, clientY: 5, isPrimary: true, pointerType: "mouse" });
give([keys, set - keys]);
"""


def test_a_place_in_a_film_is_set_once_and_by_the_first_button() -> None:
    assert in_node(FILM, None) == [1, 1]


BOXES = """
const { parseHTML } = await import("linkedom");
const window = parseHTML(`<div id="root"><div class="carts-control" data-set="A.mass">
  <input class="carts-slider" type="range"><input class="carts-number-box">
  <p class="carts-error"></p></div></div>`);
globalThis.document = window.document;
globalThis.CSS = { escape: (text) => text };
const root = document.querySelector(".carts-control");
const box = root.querySelector(".carts-number-box");
const asked = [];
const { Controls } = await import(`${source}/scene/controls.js`);
const { AxisControl } = await import(`${source}/map/axis.js`);
if (data.axis) {
  const axis = { set: "A.mass", values: [1, 2, 3], low: 1, high: 3, unit: "kg", per: 1 };
  const control = new AxisControl(root, axis, (place) => {
    asked.push(place);
    control.show(axis.values, place);
  });
} else {
  const control = { set: "A.mass", low: 0, high: 5, step: 0.1, value: 1, unit: "kg", per: 1 };
  new Controls(root.parentElement, [control], { change: (_, value) => asked.push(value) });
}
for (const { typed, ...key } of data.keys) {
  if (typed) box.value = typed;
  const event = new window.Event("keydown");
  box.dispatchEvent(Object.assign(event, { keyCode: 13, isComposing: false, ...key }));
  if (!key.isComposing) box.dispatchEvent(new window.Event("change"));
}
give(asked);
"""


@pytest.mark.parametrize(
    ("typed", "axis", "asked"),
    [("2", False, 2), ("750 g", False, "750 g"), ("2", True, 1)],
    ids=["a number", "another unit", "an axis of a map"],
)
def test_a_typed_value_is_asked_for_once(typed: str, axis: bool, asked: float | str) -> None:
    keys = [
        {"key": "Enter", "isComposing": True, "typed": typed},
        {"key": "Enter"},
    ]
    assert in_node(BOXES, {"keys": keys, "axis": axis}) == [asked]
