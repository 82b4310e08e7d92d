"""A reader switches an effect off and on: the picture, the words and the run follow."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import live, widget_site, write_page

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture

ROUGH: dict[str, Any] = {
    "id": "rough",
    "carts": {"A": {"mass": "0.5 kg", "position": "0.40 m", "velocity": "0.40 m/s"}},
    "track": {"length": "2.4 m"},
    "effects": [
        {"friction": {"coefficient": "0.02"}},
        {"push": {"cart": "A", "force": "0.1 N", "from": "1 s", "until": "2 s"}},
    ],
    "until": "4 s",
    "show": ["v"],
    "controls": [
        {"switch": "friction"},
        {"set": "friction.coefficient", "from": "0.01", "to": "0.1", "step": "0.01"},
    ],
}


@pytest.mark.one_browser
def test_without_friction_the_cart_goes_on(open_page: OpenPage, widget_site: Path) -> None:
    page = live(open_page(write_page(widget_site, "rough", ROUGH)), "rough")
    scene = page.locator("#rough")
    friction = scene.get_by_role("checkbox", name="friction")
    words = scene.locator(".carts-acting")
    by_track = scene.locator('.carts-stage-wide [data-key="name friction A"]')
    events = scene.locator(".carts-events")
    expect(words).to_contain_text("friction by the track, μ = 0.02")
    expect(by_track).to_have_text("on A by the track: 0.0981 N")
    expect(events).to_contain_text("The push on A by hand ends.")
    expect(events).to_contain_text("A stops: the track holds it.")
    friction.uncheck()
    expect(words).not_to_contain_text("μ")
    expect(words).to_contain_text("Left out: friction")
    expect(by_track).to_have_count(0)
    expect(scene.locator(".carts-rough")).to_have_count(0)
    expect(events).not_to_contain_text("A stops")
    friction.check()
    expect(by_track).to_have_text("on A by the track: 0.0981 N")
    scene.get_by_label("friction coefficient μ", exact=True).fill("0.04")
    scene.get_by_label("friction coefficient μ", exact=True).press("Enter")
    expect(by_track).to_have_text("on A by the track: 0.196 N")
    scene.get_by_role("button", name="Reset all values").click()
    expect(words).to_contain_text("μ = 0.02")
