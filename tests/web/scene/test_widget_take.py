"""What a reader takes along from a page: a link with the state, files, a program, a code."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import PLAY, live, on_scene, widget_site, write_page

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture

SAVED = """() => {
  window.saved = {};
  HTMLAnchorElement.prototype.click = function () {
    const name = this.download;
    const blob = window.blobs.at(-1);
    blob.slice(0, 7).text().then((text) => { window.saved[name] = text; });
  };
  window.blobs = [];
  const make = URL.createObjectURL;
  URL.createObjectURL = (blob) => { window.blobs.push(blob); return make.call(URL, blob); };
}"""


@pytest.mark.one_browser
def test_a_link_restores_the_state_and_files_are_saved(
    open_page: OpenPage, widget_site: Path
) -> None:
    play = live(open_page(write_page(widget_site, "play", PLAY)), "play")
    on_scene(play, "await el.set({ 'A.mass': 3 }); el.time = 1;", name="play")
    play.locator("#play .carts-take summary").click()
    play.locator("#play [data-take=link]").click()
    address = play.locator("#play .carts-take textarea")
    expect(address).to_have_value(re.compile(r"#carts:play\?A\.mass=3&t=1$"))
    play.evaluate(SAVED)  # Firefox's driver tells of no downloads
    for kind, start in (("csv", "t in"), ("svg", "<svg xm"), ("png", "\ufffdPNG\r\n\x1a")):
        play.locator(f"#play [data-take={kind}]").click()
        play.evaluate(
            """async (name) => { while (!window.saved[name])
                await new Promise((resolve) => setTimeout(resolve, 50)); }""",
            f"play.{kind}",
        )
        assert play.evaluate(f"window.saved['play.{kind}']") == start
    other = open_page(widget_site / "play.html")
    other.goto("about:blank")
    other.goto(address.input_value())
    live(other, "play")
    expect(other.locator('#play [data-set="A.mass"] .carts-number-box')).to_have_value("3.0")
    # Where the page is open already, only what comes after # changes.
    other.goto((widget_site / "play.html").as_uri() + "#carts:play?A.mass=2&t=0.5")
    expect(other.locator('#play [data-set="A.mass"] .carts-number-box')).to_have_value("2.0")
    # What a link does not name is as the lesson has it, whatever the reader changed before.
    on_scene(other, "await el.set({ 'contact.restitution': 0.5 })", name="play")
    other.goto((widget_site / "play.html").as_uri() + "#carts:play?t=1")
    expect(other.locator('#play [data-set="A.mass"] .carts-number-box')).to_have_value("0.5")
    bounce = other.locator('#play [data-set="contact.restitution"] .carts-number-box')
    expect(bounce).to_have_value("0.80")
    other.goto("about:blank")
    other.goto((widget_site / "play.html").as_uri() + "#carts:play?A.mass=-1")
    live(other, "play")
    expect(other.locator("#play .carts-note")).to_contain_text("does not fit this scene")


@pytest.mark.one_browser
def test_a_program_of_the_values_on_screen_can_be_taken_along(
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(widget_site / "meeting.html"))
    on_scene(page, "await el.set({ 'A.mass': 2.5 })")
    page.locator("#meeting .carts-take summary").click()
    page.evaluate(SAVED)  # Firefox's driver tells of no downloads
    page.locator("#meeting [data-take=program]").click()
    page.evaluate(
        """async () => { while (!window.saved["meeting.py"])
            await new Promise((resolve) => setTimeout(resolve, 50)); }"""
    )  # the policy forbids the driver's own way of waiting
    text = page.locator("#meeting .carts-take textarea").input_value()
    assert "mass = [2.5, 1.0]" in text
    compile(text, "meeting.py", "exec")


@pytest.mark.one_browser
def test_a_hosted_page_shows_its_link_as_a_code_for_phones(
    open_page: OpenPage, widget_site: Path, site_server: Callable[[Path], str]
) -> None:
    address = site_server(widget_site)
    page = live(open_page(f"{address}/meeting.html", folder=widget_site))
    page.locator("#meeting .carts-take summary").click()
    page.locator("#meeting [data-take=link]").click()
    picture = page.get_by_role("img", name="QR code of the link")
    expect(picture).to_be_visible()
    box = picture.bounding_box()
    assert box and box["width"] == box["height"] >= 100
    page.locator("#meeting [data-take=block]").click()
    expect(picture).to_have_count(0)
