"""A scene's sliders without Python: from one prepared run to the next, and a prediction too."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage
from tests.web.scene.given.prepared_site import prepared_site
from tests.web.scene.given.widget_site import LIVE, lock, on_scene, widget_site

pytestmark = pytest.mark.browser

__all__ = ["prepared_site", "widget_site"]  # fixtures

LAST = """
    const drawn = new Promise((done) => el.addEventListener("carts-update", done, { once: true }));
    await Promise.race([drawn, new Promise((done) => setTimeout(done, 500))]);
    return el.trajectory.v.B.at(-1);
"""


def failed(page: Page, name: str) -> Page:
    page.wait_for_selector(f'#{name}[data-state="failed"]', timeout=LIVE)
    return page


def values(page: Page, name: str, changes: dict[str, Any]) -> dict[str, Any]:
    """What is on the screen after these changes."""
    script = """
        await el.set(argument);
        const { trajectory } = el;
        const boxes = [...el.querySelectorAll(".carts-number-box")].map((box) => box.value);
        return { boxes, v: trajectory.v.B[trajectory.t.length - 1] };
    """
    return dict(on_scene(page, script, changes, name))


def test_without_python_the_sliders_go_from_one_exact_run_to_the_next(
    open_page: OpenPage, prepared_site: Path
) -> None:
    page = failed(open_page(prepared_site / "slides-without.html"), "slides")
    expect(page.locator("#slides .carts-note")).to_contain_text("prepared run")
    told = values(page, "slides", {"A.mass": 2.04, "A.velocity": "3.1 km/h"})
    mass, speed = (float(text) for text in told["boxes"])
    assert abs(mass - 2.04) < 0.2  # the nearest of some fifteen
    assert abs(speed - 3.1) <= 0.5
    # momentum and e = 0.8: w = (1 + e) m v / (m + 1)
    assert told["v"] == pytest.approx(1.8 * mass * speed / 3.6 / (mass + 1), rel=1e-9)


@pytest.mark.one_browser
def test_without_python_a_slider_is_moved_by_hand_and_its_box_says_the_value_of_the_run(
    open_page: OpenPage, prepared_site: Path
) -> None:
    page = failed(open_page(prepared_site / "slides-without.html"), "slides")
    slider = page.locator('#slides [data-set="A.mass"] .carts-slider')
    before = on_scene(page, LAST, name="slides")
    slider.focus()
    for _ in range(5):
        slider.press("ArrowRight")
    assert on_scene(page, LAST, name="slides") > before
    told = values(page, "slides", {})
    mass = float(told["boxes"][0])
    assert mass > 1
    assert told["v"] == pytest.approx(1.8 * mass * 2 / 3.6 / (mass + 1), rel=1e-9)


@pytest.mark.one_browser
def test_without_python_a_link_is_followed_to_the_nearest_run_and_one_that_cannot_be_is_told(
    open_page: OpenPage, prepared_site: Path
) -> None:
    page = failed(open_page(prepared_site / "slides-without.html"), "slides")
    mass = page.locator('#slides [data-set="A.mass"] .carts-number-box')
    page.evaluate("location.hash = '#carts:slides?A.mass=9%20kg&t=0.5'")
    expect(page.locator("#slides .carts-clock")).to_have_text(re.compile(r"^0\.50"))
    page.evaluate("location.hash = '#carts:slides?A.mass=2.04%20kg'")
    expect(mass).not_to_have_value("1")
    assert abs(float(mass.input_value()) - 2.04) < 0.2
    page.evaluate("location.hash = '#carts:slides?B.mass=3%20kg'")
    note = page.locator("#slides .carts-note")
    expect(note).to_contain_text("This change needs Python")
    expect(note).to_contain_text("prepared run")  # what was said before stays
    page.evaluate("location.hash = '#carts:slides?B.mass=4%20kg'")
    expect(mass).to_be_visible()
    assert (note.text_content() or "").count("This link does not fit") == 1


@pytest.mark.one_browser
def test_without_python_a_slider_leaves_the_boxes_to_tick_as_they_are(
    open_page: OpenPage, prepared_site: Path
) -> None:
    """Friction that acts from the start was gone with the first step of any slider."""
    page = failed(open_page(prepared_site / "rubs-without.html"), "rubs")
    box = page.locator("#rubs [data-switch]")
    last = "await el.set(argument); return el.trajectory.v.A.at(-1);"
    assert on_scene(page, last, {"A.mass": 2}, "rubs") == 0
    expect(box).to_be_checked()
    box.uncheck()
    assert on_scene(page, last, {"A.mass": 1}, "rubs") == 0.5
    expect(box).not_to_be_checked()


@pytest.mark.one_browser
def test_without_python_what_was_not_prepared_is_refused_and_the_run_stays(
    open_page: OpenPage, prepared_site: Path
) -> None:
    page = failed(open_page(prepared_site / "slides-without.html"), "slides")
    page.locator("#slides .carts-preset").click()
    page.wait_for_selector("#slides .carts-undo:enabled")
    quick = on_scene(page, LAST, name="slides")
    assert quick == pytest.approx(1.8 * 4.2 / 3.6 / 2, rel=1e-9)
    box = page.locator('#slides [data-set="A.mass"] .carts-number-box')
    box.fill("700 g")
    box.press("Enter")
    expect(page.locator("#slides .carts-control .carts-error").first).to_contain_text("Python")
    assert on_scene(page, LAST, name="slides") == quick
    box.fill("3")
    box.press("Enter")
    assert on_scene(page, LAST, name="slides") > 1.3 * quick


@pytest.mark.one_browser
def test_without_python_a_prediction_is_locked_and_its_run_watched_and_changed(
    open_page: OpenPage, prepared_site: Path
) -> None:
    page = failed(open_page(prepared_site / "asks-without.html"), "asks")
    assert "__cartsParts" not in page.evaluate("Object.keys(window).join()")
    assert page.locator("script[src*=prepared]").count() == 0
    page.get_by_role("radio", name="It turns back").check()
    lock(page, "asks")
    page.wait_for_selector("#asks[data-watched]")
    told = values(page, "asks", {"A.mass": 0.5})
    assert told["v"] == pytest.approx(1.8 * 0.5 * 2 / 3.6 / 1.5, rel=1e-9)


@pytest.mark.one_browser
def test_without_python_text_that_waits_opens_by_a_prepared_run_and_closes_for_the_next_reader(
    open_page: OpenPage, prepared_site: Path
) -> None:
    page = failed(open_page(prepared_site / "asks-without.html"), "asks")
    opened = page.locator("carts-after[data-opened]")
    page.get_by_role("radio", name="It turns back").check()
    assert opened.count() == 0
    lock(page, "asks")
    opened.wait_for()
    page.locator("#asks .carts-again").click()
    page.locator("#asks .carts-forget-yes").click()
    page.locator("#asks .carts-lock:enabled").wait_for()
    assert opened.count() == 0
    page.get_by_role("radio", name="It stops").check()
    lock(page, "asks")
    opened.wait_for()


@pytest.mark.one_browser
def test_while_python_starts_a_prepared_run_is_shown_and_then_the_exact_one(
    open_page: OpenPage, prepared_site: Path
) -> None:
    page = open_page(prepared_site / "slides.html")
    shown = on_scene(
        page,
        """
        const seen = [];
        const box = el.querySelector('[data-set="A.mass"] .carts-number-box');
        const state = el.dataset.state;
        const set = el.set({ "A.mass": 2.04 });
        for (let k = 0; k < 400 && el.dataset.state !== "live"; k += 1) {
          seen.push(Number(box.value));
          await new Promise((done) => setTimeout(done, 5));
        }
        await set;
        return { state, seen, last: Number(box.value) };
        """,
        name="slides",
    )
    assert shown["state"] in ("still", "starting")
    between = set(shown["seen"]) - {1, 2.04}
    assert all(abs(mass - 2.04) < 0.2 for mass in between)
    assert between  # a prepared one was there first
    assert shown["last"] == pytest.approx(2.04)


def test_a_script_with_runs_that_is_gone_is_told_and_the_picture_stays(
    open_page: OpenPage, prepared_site: Path, tmp_path: Path
) -> None:
    page_text = (prepared_site / "slides-without.html").read_text(encoding="utf-8")
    gone = re.sub(r"slides\.0\.[0-9a-f]+\.js", "slides.0.000000000000.js", page_text)
    (prepared_site / "gone.html").write_text(gone, encoding="utf-8")
    page = failed(open_page(prepared_site / "gone.html"), "slides")
    said = on_scene(
        page, "return el.set({ 'A.mass': 2 }).catch((error) => error.message)", name="slides"
    )
    assert "missing" in said
    assert on_scene(page, "return el.trajectory.t.length", name="slides") > 2
