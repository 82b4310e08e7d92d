"""A run is watched before it is known: nothing of it is on the page before it has happened."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import SharePage
from tests.web.scene.given.widget_site import (
    AT_REST,
    CHOICE,
    LIVE,
    MEETING,
    live,
    on_scene,
    widget_site,
)
from tests.web.scene.given.widget_site import write_page as put

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture

WATCHED = {**MEETING, "id": "watched", "watch": "first"}
ASKED = {**CHOICE, "id": "asked"}
KNOWN = {**CHOICE, "id": "known", "watch": "free"}
PRESETS = {
    **CHOICE,
    "id": "presets",
    "presets": {
        "as it is": {"A.mass": "0.5 kg"},
        "elastic": {"contact.restitution": 1},
        "heavy": {"A.mass": "4 kg"},
    },
}

SEEN = """const copy = el.cloneNode(true);
    for (const script of copy.querySelectorAll("script, template")) script.remove();
    const text = copy.textContent.replace(/\\s+/g, " ");
    const attributes = [...el.querySelectorAll("*")].flatMap((one) =>
      [...one.attributes].filter(({ name }) => name.startsWith("aria")).map(({ value }) => value));
    const ends = [...el.querySelectorAll(".carts-curve[d^='M']")].map((path) => {
      const box = path.closest(".carts-plot") && path.getBBox();
      return box ? box.x + box.width : 0;
    });
    const cursor = el.querySelector(".carts-cursor")?.getAttribute("transform") ?? "";
    return { events: el.querySelectorAll(".carts-events li").length,
      bands: el.querySelectorAll(".carts-contact-band").length,
      marks: el.querySelectorAll(".carts-event").length,
      rows: Math.max(0, ...[...el.querySelectorAll(".carts-graph tbody")]
        .map((body) => body.children.length)),
      model: el.querySelector(".carts-model").getClientRects().length,
      said: [text, ...attributes].join(" "), right: Math.max(...ends),
      cursor: Number((cursor.match(/[\\d.]+/) ?? [0])[0]) };"""


def told(page: Page, name: str = "watched") -> dict[str, object]:
    return dict(on_scene(page, SEEN, name=name))


@pytest.fixture
def watched(shared_page: SharePage, widget_site: Path) -> Page:
    return live(shared_page(put(widget_site, "watched", WATCHED)), "watched")


@pytest.mark.one_browser
def test_before_it_is_played_the_page_holds_the_start_alone(watched: Page) -> None:
    # Tables are filled a while after the run is there.
    watched.locator("#watched").evaluate(AT_REST)
    watched.evaluate("dispatchEvent(new Event('beforeprint'))")
    seen = told(watched)
    assert (seen["events"], seen["bands"], seen["marks"], seen["model"]) == (0, 0, 0, 0)
    assert seen["rows"] == 1
    assert seen["right"] == pytest.approx(seen["cursor"], abs=0.5)


@pytest.mark.one_browser
def test_half_way_through_a_contact_nothing_is_there_of_what_comes_after(watched: Page) -> None:
    events = on_scene(watched, "return el.trajectory.events", name="watched")
    touch = next(event["t"] for event in events if event["kind"] == "contact")
    apart = next(event["t"] for event in events if event["kind"] == "separate")
    half = touch + 0.4 * (apart - touch)
    on_scene(watched, f"el.time = {half}", name="watched")
    seen = told(watched)
    assert (seen["events"], seen["bands"]) == (1, 1)
    assert seen["right"] == pytest.approx(seen["cursor"], abs=0.5)
    for word in (
        "separate",
        "squeezed the most",
        "push hardest",
        "End of the run",
        "Impulse on each",
    ):
        assert word not in str(seen["said"])
    band, axis = watched.locator(".carts-contact-band"), watched.locator(".carts-scrub")
    whole = float(axis.get_attribute("max") or 0)
    width = float((band.get_attribute("width") or "").rstrip("%"))
    assert width == pytest.approx(100 * (half - touch) / whole, abs=0.01)


@pytest.mark.one_browser
def test_on_paper_are_axes_to_draw_in_and_no_empty_list_and_table(watched: Page) -> None:
    watched.emulate_media(media="print")
    dead = [watched.locator(one).first for one in (".carts-story", ".carts-timeline")]
    tables = watched.locator(".carts-graph .carts-more")
    for part in (*dead, tables.first):
        expect(part).to_be_hidden()
    expect(watched.locator(".carts-graph .carts-plot").first).to_be_visible()
    watched.emulate_media(media="screen")
    watched.locator(".carts-end").click()
    watched.emulate_media(media="print")
    for part in (*dead, tables.first):
        expect(part).to_be_visible()


@pytest.mark.one_browser
def test_a_reader_goes_back_at_once_and_forth_as_far_as_was_seen(watched: Page) -> None:
    on_scene(watched, "el.time = 0.3", name="watched")
    watched.locator(".carts-scrub").focus()
    watched.keyboard.press("Home")
    expect(watched.locator(".carts-clock")).to_have_text(re.compile(r"^0\.000?$"))
    watched.keyboard.press("End")
    expect(watched.locator(".carts-clock")).to_have_text(re.compile(r"^0\.300?$"))
    watched.locator(".carts-end").click()
    expect(watched.locator(".carts-events li").last).to_contain_text("End of the run")
    expect(watched.locator(".carts-model")).to_be_visible()
    watched.keyboard.press("Escape")
    on_scene(watched, "el.time = 0", name="watched")
    expect(watched.locator(".carts-events li").last).to_contain_text("End of the run")
    watched.reload()
    live(watched, "watched")
    expect(watched.locator(".carts-events li").last).to_contain_text("End of the run")


@pytest.mark.one_browser
def test_after_the_lock_it_plays_by_itself_and_is_compared_at_its_end(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(put(widget_site, "asked", ASKED)), "asked")
    scene = page.locator("#asked")
    scene.locator("input[type=radio]").first.check()
    scene.locator(".carts-lock").click()
    expect(scene.locator(".carts-transport")).to_have_class(re.compile("carts-is-playing"))
    expect(scene.locator(".carts-compared")).to_be_hidden()
    expect(scene.locator(".carts-slider").first).to_be_disabled()
    page.reload()  # before it was watched: it is there to be played, and tells nothing
    live(page, "asked")
    expect(scene.locator(".carts-play")).to_be_enabled(timeout=LIVE)
    expect(scene.locator(".carts-compared")).to_be_hidden()
    expect(scene.locator(".carts-transport")).not_to_have_class(re.compile("carts-is-playing"))
    assert on_scene(page, "return el.time", name="asked") == 0
    assert told(page, "asked")["events"] == 0
    scene.locator(".carts-end").click()
    expect(scene.locator(".carts-compared")).to_be_visible()
    expect(scene.locator(".carts-slider").first).to_be_enabled()
    expect(scene.locator(".carts-saved")).to_have_text("Saved.")
    page.reload()
    expect(scene.locator(".carts-compared")).to_be_visible(timeout=LIVE)


@pytest.mark.one_browser
def test_where_a_lesson_has_it_free_everything_is_there_after_the_lock(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(put(widget_site, "known", KNOWN)), "known")
    page.locator("#known input[type=radio]").first.check()
    page.locator("#known .carts-lock").click()
    expect(page.locator("#known .carts-compared")).to_be_visible(timeout=LIVE)
    expect(page.locator("#known .carts-events li").last).to_contain_text("End of the run")
    expect(page.locator("#known .carts-end")).to_have_count(0)
    assert on_scene(page, "return el.time", name="known") == 0


@pytest.mark.one_browser
def test_on_the_projector_a_class_watches_too_and_one_run_is_enough(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(put(widget_site, "class-watched", PRESETS)), "presets")
    scene = page.locator("#presets")
    scene.locator(".carts-project").click()
    scene.locator(".carts-project-bar button").first.click()  # Reveal
    expect(scene.locator(".carts-transport")).to_have_class(re.compile("carts-is-playing"))
    assert told(page, "presets")["events"] == 0
    scene.locator(".carts-end").click()
    assert told(page, "presets")["events"] != 0
    expect(scene).to_have_attribute("data-watched", "")
    page.keyboard.press("Escape")  # what the class has seen is no student's prediction
    expect(scene.locator(".carts-results")).to_be_hidden()
    expect(scene.locator(".carts-lock")).to_be_visible()


@pytest.mark.one_browser
def test_a_changed_run_is_watched_anew_until_one_was_seen_to_its_end(watched: Page) -> None:
    on_scene(watched, "el.time = 1", name="watched")
    on_scene(watched, 'el.time = 0; await el.set({ "A.mass": 2 })', name="watched")
    assert told(watched)["events"] == 0
    watched.locator("#watched .carts-end").click()
    on_scene(watched, 'el.time = 0; await el.set({ "A.mass": 3 })', name="watched")
    assert told(watched)["events"] != 0


@pytest.mark.one_browser
def test_of_ready_made_settings_each_is_watched_before_all_of_them_are_known(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(put(widget_site, "presets", PRESETS)), "presets")
    scene, left = page.locator("#presets"), page.locator("#presets .carts-presets-left")
    heading = scene.locator(".carts-predict > .carts-heading")
    scene.locator("input[type=radio]").first.check()
    expect(heading).to_have_text("Predict first")
    scene.locator(".carts-lock").click()
    expect(heading).to_have_text("Your prediction")  # also while others are still to be watched
    scene.locator(".carts-end").click()
    expect(left).to_have_text("Still to watch: elastic, heavy")
    expect(scene.locator(".carts-slider").first).to_be_enabled()
    scene.locator("[data-preset=elastic]").click()
    expect(scene.locator(".carts-transport")).to_have_class(re.compile("carts-is-playing"))
    assert told(page, "presets")["events"] == 0
    scene.locator(".carts-end").click()
    assert told(page, "presets")["events"] != 0  # all of it, as of the first, before anything moves
    expect(left).to_have_text("Still to watch: heavy")
    expect(scene.locator(".carts-compared")).to_be_hidden()
    assert scene.get_attribute("data-watched") is None
    scene.locator("[data-preset=elastic]").click()  # seen before: it stands there whole
    expect(scene.locator(".carts-clock")).to_have_text(re.compile(r"^0\.000?$"))
    assert told(page, "presets")["events"] != 0
    scene.locator("[data-preset=heavy]").click()
    expect(scene.locator(".carts-transport")).to_have_class(re.compile("carts-is-playing"))
    scene.locator(".carts-reset").click()  # left half-way: what was watched before is there
    assert told(page, "presets")["events"] != 0
    expect(scene.locator(".carts-end")).to_be_hidden()
    expect(left).to_have_text("Still to watch: heavy")
    scene.locator("[data-preset=heavy]").click()
    scene.locator(".carts-end").click()
    expect(left).to_have_text("All watched.")
    assert scene.get_attribute("data-watched") == ""
    expect(scene.locator(".carts-compared")).to_be_visible()
    scene.locator(".carts-end").click()  # it leads to the comparison now
    expect(scene.locator(".carts-compared")).to_be_focused()


@pytest.mark.one_browser
def test_the_touches_offered_to_the_graphs_are_those_of_the_run_on_the_page(watched: Page) -> None:
    touches = watched.locator("#watched .carts-window option")
    on_scene(watched, "el.time = 1.5", name="watched")
    before = touches.all_text_contents()
    on_scene(watched, 'await el.set({ "A.velocity": 1.3 })', name="watched")
    after = touches.all_text_contents()
    assert len(after) == len(before) > 1
    assert after[1:] != before[1:]
