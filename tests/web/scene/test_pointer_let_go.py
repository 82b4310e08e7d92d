"""What follows a pointer lets go with it, and hears the first button alone; a finger that scrolls
points at nothing."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import SharePage
from tests.web.scene.given.widget_site import (
    PLAY,
    in_node,
    live,
    on_scene,
    widget_site,
    write_page,
)

__all__ = ["widget_site"]  # a fixture

NODE = """
const { followPointer, onPointed } = await import(`${source}/shared/follow.js`);
const page = new EventTarget();
globalThis.addEventListener = page.addEventListener.bind(page);
const pressed = { pointerId: 1, button: 0, buttons: 1, clientX: 0, clientY: 0 };
const made = (type, given) => Object.assign(new Event(type), pressed, given);
const send = (type, given) => page.dispatchEvent(made(type, given));
"""
FOLLOWED = """
const seen = [];
const pull = (button) => followPointer(made("pointerdown", { button }), (by) => seen.push(by));
pull(2);
send("pointermove", { clientX: 1, buttons: 2 });
send("pointerup", { buttons: 0 });
pull(0);
send("pointermove", { clientX: 10 });
send("pointermove", { clientX: 20, buttons: 0 }); // a menu has swallowed the end
send("pointermove", { clientX: 30 });
pull(0);
send("pointermove", { clientX: 40, pointerId: 2 });
send("pointerup", { buttons: 0 });
send("pointermove", { clientX: 50 });
give(seen);
"""
POINTED = """
const place = new EventTarget();
const seen = [];
onPointed(place, ({ type, clientX }) => seen.push([type, clientX]));
const down = (given) => place.dispatchEvent(made("pointerdown", given));
for (const step of data) {
  seen.length = 0;
  const [pointerType, moves] = step;
  down({ pointerType, clientX: 0 });
  for (const [clientX, clientY] of moves) send("pointermove", { clientX, clientY });
  send("pointercancel", { buttons: 0 });
  step.push([...seen]);
}
seen.length = 0;
down({ pointerType: "mouse", button: 2 });
place.dispatchEvent(made("click", { clientX: 7 })); // a finger's tap
give([data.map((step) => step[2]), seen]);
"""


def test_one_that_is_followed_is_let_go_with_its_button() -> None:
    assert in_node(NODE + FOLLOWED, None) == [10]


def test_a_finger_points_where_it_taps_or_goes_sideways() -> None:
    steps: list[Any] = [
        ["mouse", [[3, 0]]],
        ["touch", [[2, 1], [3, 40], [9, 90]]],  # the page is scrolled
        ["touch", [[2, 1], [20, 3], [25, 30]]],
    ]
    told, tapped = in_node(NODE + POINTED, steps)
    assert told[0] == [["pointerdown", 0], ["pointermove", 3]]
    assert told[1] == []
    assert told[2] == [["pointermove", 20], ["pointermove", 25]]
    assert tapped == [["click", 7]]


@pytest.fixture
def play(shared_page: SharePage, widget_site: Path) -> Page:
    return live(shared_page(write_page(widget_site, "play", PLAY)), "play")


@pytest.mark.browser
@pytest.mark.one_browser
def test_a_cart_is_pulled_by_the_first_button_as_long_as_it_is_held(play: Page) -> None:
    box = play.locator('#play .carts-stage-wide .carts-cart[data-body="A"]').bounding_box()
    assert box
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    number = play.locator('#play [data-set="A.position"] .carts-number-box')
    before = number.input_value()
    play.mouse.move(x, y)
    play.mouse.down(button="right")
    play.mouse.move(x + 80, y, steps=3)
    play.mouse.up(button="right")
    play.keyboard.press("Escape")
    expect(number).to_have_value(before)
    play.mouse.move(x, y)
    play.mouse.down()
    play.evaluate(
        """() => document.querySelector(".carts-stage-wide .carts-cart").dispatchEvent(
        new PointerEvent("pointermove", { bubbles: true, pointerId: 1, buttons: 0 }))"""
    )
    play.mouse.move(x + 80, y, steps=3)
    play.mouse.up()
    expect(number).to_have_value(before)


@pytest.mark.browser
@pytest.mark.one_browser
def test_a_graph_that_is_scrolled_over_or_clicked_aside_does_not_move_the_time(play: Page) -> None:
    graph = play.locator('#play .carts-graph[data-quantity="v"] .carts-plot')
    graph.scroll_into_view_if_needed()
    box = graph.bounding_box()
    assert box
    at = {"x": box["x"] + box["width"] / 2, "y": box["y"] + box["height"] / 2}
    send = """(plot, [kind, x, y]) => plot.dispatchEvent(new PointerEvent(kind, {
      bubbles: true, pointerId: 5, pointerType: "touch", buttons: kind === "pointercancel" ? 0 : 1,
      clientX: x, clientY: y }))"""
    graph.evaluate(send, ["pointerdown", at["x"], at["y"]])
    graph.evaluate(send, ["pointermove", at["x"] + 2, at["y"] - 30])
    graph.evaluate(send, ["pointercancel", at["x"], at["y"]])
    graph.click(button="right")
    play.keyboard.press("Escape")
    assert on_scene(play, "return el.time", name="play") == 0
    graph.click()
    assert on_scene(play, "return el.time", name="play") > 0
