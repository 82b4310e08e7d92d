"""A computer on which Python takes long to start: what its reader is told, and where."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage

pytestmark = pytest.mark.browser


@pytest.mark.one_browser
def test_a_computer_that_is_slow_is_not_given_up_and_its_reader_is_told(
    site: Path, open_page: OpenPage
) -> None:
    """A worker that says nothing for eight seconds; the sliders work meanwhile."""
    page = open_page(site / "about.html")
    page.add_init_script(
        "const Own = Worker; window.Worker = class extends Own { constructor(...given) {"
        " super(...given); setTimeout(() => this.terminate(), 10); } };"
    )
    page.goto((site / "index.html").as_uri())
    scene = page.locator("#home")
    expect(scene.locator(".carts-note")).to_contain_text("still trying", timeout=30_000)
    expect(scene).to_have_attribute("data-state", "starting")
    scene.locator(".carts-slider").first.press("ArrowRight")
    expect(scene.locator(".carts-note")).not_to_contain_text("not run here")


@pytest.mark.one_browser
def test_what_is_said_of_a_slow_computer_covers_no_prediction_and_no_picture_on_paper(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "about.html")
    page.add_init_script("window.Worker = class extends EventTarget { postMessage() {} };")
    page.goto((site / "worksheets" / "newtons-third-law.html").as_uri())
    scene = page.locator("#third-heavy-into-light")
    scene.scroll_into_view_if_needed()
    note = scene.locator(".carts-note")
    expect(note).to_contain_text("still trying", timeout=30_000)
    said, asked = note.bounding_box(), scene.locator(".carts-predict").bounding_box()
    assert said is not None
    assert asked is not None
    assert said["x"] + said["width"] <= asked["x"], "beside it"
    page.emulate_media(media="print")
    expect(note).to_be_hidden()
