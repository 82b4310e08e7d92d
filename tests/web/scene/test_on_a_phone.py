"""In the order of a phone what is needed now stands right below the picture."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import SharePage
from tests.web.scene.given.widget_site import CHOICE, live, widget_site, write_page

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

__all__ = ["widget_site"]  # a fixture

UNSET: dict[str, Any] = {**CHOICE, "id": "unset", "controls": [], "watch": "first"}


def in_order(page: Page, name: str) -> list[str]:
    """Classes of the parts of a scene that are seen, from top to bottom."""
    found: list[str] = page.locator(f"#{name} > .carts-frame > *").evaluate_all(
        """(parts) => parts.map((one) => [one.getBoundingClientRect(), one.classList[0]])
          .filter(([{ height }]) => height > 2).sort(([a], [b]) => a.top - b.top)
          .map(([, name]) => name.replace("carts-", ""))"""
    )
    return [one for one in found if one in ("world", "transport", "predict", "results", "side")]


def test_on_a_phone_what_is_asked_then_graphs_then_the_comparison_stand_below_the_picture(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(write_page(widget_site, "unset", UNSET)), "unset")
    page.set_viewport_size({"width": 360, "height": 740})
    assert in_order(page, "unset") == ["world", "predict", "transport", "side"]
    unasked = page.locator("#unset .carts-unasked").locator("visible=true")
    assert unasked.count() == 0  # no force is shown
    page.get_by_label("It stops", exact=True).check()
    page.locator("#unset .carts-lock").click()
    expect(page.locator("#unset .carts-down")).to_be_visible()
    assert in_order(page, "unset") == ["world", "transport", "results", "predict", "side"]
    assert unasked.count() == 1
    page.locator("#unset .carts-end").click()
    expect(page.locator("#unset .carts-compared")).to_be_visible()
    assert in_order(page, "unset") == ["world", "transport", "predict", "results", "side"]


def test_on_a_phone_sliders_stay_below_play_and_a_link_leads_to_the_graphs(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "choice.html"), "choice")
    page.set_viewport_size({"width": 360, "height": 740})
    page.get_by_label("It stops", exact=True).check()
    page.locator("#choice .carts-lock").click()
    expect(page.locator("#choice .carts-down")).to_be_visible()
    assert in_order(page, "choice") == ["world", "transport", "side", "results", "predict"]
    page.locator("#choice .carts-down").click()
    expect(page.locator("#choice .carts-graph").first).to_be_in_viewport()
