"""Contacts are heard, where a reader wants it."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from tests.web.scene.given.third_site import AT_PEAK, third
from tests.web.scene.given.widget_site import live, on_scene, widget_site

pytestmark = pytest.mark.browser

__all__ = ["third", "widget_site"]  # fixtures

HEARD = """() => {
  window.heard = [];
  window.AudioContext = class {
    sampleRate = 8000;
    resume() {}
    createBuffer(_, length) {
      const own = new Float32Array(length);
      return { getChannelData: () => own };
    }
    createBufferSource() {
      const source = { connect() {}, start() {
        window.heard.push(Math.max(...source.buffer.getChannelData(0).map(Math.abs)));
      } };
      return source;
    }
  };
}"""


@pytest.mark.one_browser
def test_contacts_are_heard_as_loud_as_their_force_once_a_reader_wants_it(third: Page) -> None:
    third.evaluate(HEARD)
    scene = third.locator("#third")
    on_scene(third, "el.time = 0;", name="third")
    forward = scene.locator(".carts-forward")
    forward.click()
    assert third.evaluate("window.heard") == []
    scene.locator(".carts-choose summary").click()
    scene.locator('[data-choice="sound"]').check()
    assert len(third.evaluate("window.heard")) == 1  # so soft is the softest
    on_scene(third, AT_PEAK.replace(".t;", ".t - 0.0001;"), name="third")
    forward.click()
    loud = third.evaluate("window.heard")
    assert len(loud) == 2
    assert loud[1] > 5 * loud[0]
    third.reload()
    live(third, "third")
    scene.locator(".carts-choose summary").click()
    expect(scene.locator('[data-choice="sound"]')).to_be_checked()  # remembered in this tab


@pytest.mark.one_browser
def test_a_page_has_one_sound_machine_and_says_where_there_is_none(third: Page) -> None:
    third.reload()  # one that was made before is of this page no more
    live(third, "third")
    third.evaluate(HEARD)
    third.evaluate(
        """() => {
          window.heard.made = 0;
          window.AudioContext = class extends window.AudioContext {
            constructor() { super(); window.heard.made += 1; }
            resume() { if (window.heard.broken) throw new Error("no loudspeaker"); }
          };
        }"""
    )
    scene = third.locator("#third")
    scene.locator(".carts-choose summary").click()
    box = scene.locator('[data-choice="sound"]')
    box.check()
    scene.evaluate("(el) => el.after(el.cloneNode(true))")
    boxes = third.locator('[data-choice="sound"]')
    expect(boxes).to_have_count(2)
    boxes.nth(1).evaluate("(box) => { box.checked = false; box.click(); }")
    assert third.evaluate("[window.heard.length, window.heard.made]") == [2, 1]
    third.evaluate("window.heard.broken = true")
    boxes.nth(1).evaluate("(box) => { box.checked = false; box.click(); }")
    for k in range(2):
        expect(boxes.nth(k)).not_to_be_checked()
    third.reload()
