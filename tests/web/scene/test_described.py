"""Who does not see the picture hears the instant that it shows."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import SharePage
from tests.web.scene.given.widget_site import live, widget_site

__all__ = ["widget_site"]  # a fixture

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]


def test_the_description_follows_the_clock_and_steps_say_what_came(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "meeting.html"), "meeting")
    scene = page.locator("#meeting")
    described = page.locator("#meeting-described")
    expect(described).to_contain_text("At the start:")
    peak = scene.evaluate("one => one.trajectory.events.find((event) => event.kind === 'peak').t")
    scene.evaluate(f"one => {{ one.time = {peak} }}")
    expect(described).to_contain_text(f"At {peak:.3f} s: A at ")
    expect(described).to_contain_text("Force on A by B: ")
    page.locator("#meeting .carts-world").focus()
    page.keyboard.press("ArrowRight")
    said = page.locator("#meeting .carts-announcer")
    expect(said).to_contain_text("Force on B by A: ")
    page.keyboard.press("ArrowLeft")
    expect(said).to_contain_text(f"At {peak:.3f} s: A at ")
    scene.evaluate("one => { one.time = one.trajectory.t.at(-1) }")
    expect(described).not_to_contain_text("Force on")


def test_the_table_of_forces_has_nine_instants_within_each_contact(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "meeting.html"), "meeting")
    table = page.locator('#meeting .carts-graph[data-quantity="F"] details')
    table.locator("summary").click()
    touch, apart = page.locator("#meeting").evaluate(
        """one => ["contact", "separate"].map((kind) =>
            one.trajectory.events.find((event) => event.kind === kind).t)"""
    )
    times = [float(t) for t in table.locator("tbody th, tbody tr > :first-child").all_inner_texts()]
    assert sum(touch < t < apart for t in times) >= 9
