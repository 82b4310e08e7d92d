"""Worlds of beliefs on a lesson's page: after the run was watched, beside it, called impossible."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage
from tests.web.site.pages_of import DRAWN

pytestmark = pytest.mark.browser

LESSON = "worksheets/newtons-third-law.html"
SCENE = "third-heavy-into-light"


def predict_and_watch(page: Page, on_a: str, on_b: str) -> None:
    """Two relative arrows, locked; the run is shown to its end."""
    scene = page.locator(f"#{SCENE}")
    arrows = scene.locator(".carts-guess input[type=range]")
    arrows.nth(0).fill(on_a)
    arrows.nth(1).fill(on_b)
    scene.locator(".carts-certainty input").first.check()  # asked for before it locks
    scene.locator(".carts-lock").click()
    scene.get_by_role("button", name="Keep it and show the run").click()
    scene.locator(".carts-end").click()


@pytest.mark.one_browser
def test_a_belief_is_taken_at_its_word_beside_the_real_run(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / LESSON, folder=site, viewport={"width": 1366, "height": 768})
    page.wait_for_selector(f"#{SCENE}[data-state=live]", timeout=60_000)
    worlds = page.locator(f"carts-worlds[data-for={SCENE}]")
    expect(worlds).to_be_hidden()
    assert worlds.locator("button").count() == 0  # what is impossible would tell what is so
    predict_and_watch(page, "0.3", "0.9")
    expect(worlds).to_be_visible()
    worlds.get_by_role("button", name="the heavier one pushes harder").click()
    expect(worlds.locator("figure")).to_have_count(2)
    expect(worlds.locator(".carts-impossible svg text.carts-impossible-sign").first).to_have_text(
        "impossible"
    )
    expect(worlds.locator(".carts-worlds-yours")).to_have_text("This is the world of your arrows.")
    rows = worlds.locator(".carts-worlds-ends tr").all_inner_texts()
    assert any(row.split("\t")[1:] == ["2.53 N", "0.87 N"] for row in rows), rows
    assert any(row.endswith("0.800 → 0.800 N s\t0.800 → 1.054 N s") for row in rows), rows
    expect(worlds.locator(".carts-worlds-broken li").first).to_have_text(
        "0.25 N s of momentum came from nowhere."
    )


@pytest.mark.one_browser
def test_arrows_of_our_own_world_are_no_worlds_arrows_and_start_again_hides_all(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / LESSON, folder=site, viewport={"width": 1366, "height": 768})
    page.wait_for_selector(f"#{SCENE}[data-state=live]", timeout=60_000)
    predict_and_watch(page, "0.8", "0.8")
    worlds = page.locator(f"carts-worlds[data-for={SCENE}]")
    worlds.get_by_role("button", name="the one that moves pushes harder").click()
    expect(worlds.locator("figure")).to_have_count(2)
    expect(worlds.locator(".carts-worlds-yours")).to_have_count(0)
    scene = page.locator(f"#{SCENE}")
    scene.locator(".carts-again").click()
    scene.locator(".carts-forget-yes").click()
    expect(worlds).to_be_hidden()
    assert worlds.locator("button").count() == 0


@pytest.mark.one_browser
def test_what_a_world_shows_goes_when_the_values_of_its_scene_change(
    site: Path, open_page: OpenPage
) -> None:
    """The old run had gone on to be called “Our world”, beside another one above it."""
    page = open_page(site / LESSON, folder=site, viewport={"width": 1366, "height": 768})
    page.wait_for_selector(f"#{SCENE}[data-state=live]", timeout=60_000)
    predict_and_watch(page, "0.8", "0.8")
    worlds = page.locator(f"carts-worlds[data-for={SCENE}]")
    pressed = worlds.locator("[aria-pressed=true]")
    note = worlds.locator(".carts-worlds-note")
    scene = page.locator(f"#{SCENE}")
    heavier = worlds.get_by_role("button", name="the heavier one pushes harder")
    heavier.click()
    expect(worlds.locator("figure")).to_have_count(2)
    scene.evaluate('(el) => el.set({ "A.mass": 0.5 })')
    expect(note).to_have_text("The values have changed: press again.")
    expect(worlds.locator("figure, .carts-worlds-ends")).to_have_count(0)
    expect(pressed).to_have_count(0)
    heavier.click()
    expect(worlds.locator("figure")).to_have_count(2)
    expect(note).to_have_text("")
    rows = worlds.locator(".carts-worlds-ends tr").all_inner_texts()
    assert any("0.200 → 0.200 N s\t0.200 → 0.200 N s" in row for row in rows), rows
    expect(worlds.locator(".carts-worlds-broken li")).to_contain_text("nothing breaks")
    scene.evaluate('(el) => el.set({ "A.mass": 0.5 })')  # the same values once more
    page.evaluate(DRAWN)
    expect(worlds.locator("figure")).to_have_count(2)
