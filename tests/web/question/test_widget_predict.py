"""A prediction: kept at every input, locked once, and until then nothing is told."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage
from tests.web.scene.widget_site import CHOICE, live, lock, on_scene, widget_site, write_page

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture


def guess(page: Page, on: str, value: float) -> None:
    box = page.locator(f'.carts-guess[data-on="{on}"] [type=text]')
    box.press("ControlOrMeta+a")  # keys, as a reader's: Firefox tells no change of a set value
    box.press_sequentially(str(value))
    box.press("Tab")


def test_nothing_is_told_before_the_lock(open_page: OpenPage, widget_site: Path) -> None:
    page = live(open_page(widget_site / "arrows.html"), "arrows")
    told = on_scene(
        page,
        """const error = await el.set({ "A.mass": 2 }).catch((e) => e.message);
        el.time = 3;
        return { trajectory: el.trajectory, plan: el.plan, time: el.time, error };""",
        name="arrows",
    )
    assert told == {
        "trajectory": None,
        "plan": [],
        "time": 0,
        "error": "Make your prediction and lock it first.",
    }
    expect(page.locator("#arrows .carts-results")).to_be_hidden()
    expect(page.locator("#arrows .carts-play")).to_be_disabled()
    expect(page.locator("#arrows .carts-push").first).to_be_hidden()
    assert page.locator("#arrows .carts-announcer").inner_text() == ""
    assert "equally hard" not in (page.locator("#arrows").text_content() or "")
    assert page.locator("#arrows .carts-event").count() == 0
    page.emulate_media(media="print") if page.context.browser.browser_type.name == "chromium" else 0
    expect(page.locator("#arrows .carts-results")).to_be_hidden()


@pytest.mark.one_browser
def test_before_the_lock_cards_and_tables_hold_the_start_state_only(
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(widget_site / "guessed.html"), "guessed")
    page.wait_for_timeout(500)  # tables are filled when the page has come to rest
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    values = page.locator('#guessed [data-body="A"] .carts-value')
    assert values.all_inner_texts() == ["5", "0.500", "1.00", "–", "–"]
    assert page.locator("#guessed .carts-graph td").count() == 0
    assert page.locator("#guessed .carts-curve[d^='M46']").count() == 0
    page.evaluate("dispatchEvent(new Event('afterprint'))")


@pytest.mark.one_browser
def test_after_the_lock_a_graph_says_what_it_cannot_draw(
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(widget_site / "guessed.html"), "guessed")
    page.get_by_label("It stops", exact=True).check()
    lock(page, "guessed")
    force = page.locator('#guessed [data-quantity="F"] .carts-key')
    expect(force).to_contain_text("too large and too short to draw: see the impulses")
    acceleration = page.locator('#guessed [data-quantity="a"] .carts-key')
    expect(acceleration).to_contain_text("the acceleration is too large and too short to draw")
    expect(page.locator('#guessed [data-body="A"] [data-quantity="F"]')).to_have_text("0.00")


def test_arrows_are_drawn_kept_locked_and_compared(open_page: OpenPage, widget_site: Path) -> None:
    page = live(open_page(widget_site / "arrows.html"), "arrows")
    page.locator("#arrows .carts-lock").click()
    expect(page.locator("#arrows .carts-predict-error")).to_contain_text("Set every arrow first")
    guess(page, "A", 2)
    guess(page, "B", 6)
    expect(page.locator("#arrows .carts-saved")).to_have_text("Saved.")
    assert page.locator("#arrows .carts-stage-wide .carts-guessed").count() == 2
    lock(page, "arrows")
    expect(page.locator("#arrows .carts-results")).to_be_visible()
    compared = page.locator("#arrows .carts-compared").inner_text()
    assert "2.0 N" in compared
    assert "6.0 N" in compared
    assert compared.count("6.9 N") == 2  # the run: equal
    assert page.locator("#arrows .carts-guessed:visible").count() == 2  # in the comparison only
    assert on_scene(page, "return el.trajectory.events.length", name="arrows") > 3
    expect(page.locator("#arrows .carts-play")).to_be_enabled()


def test_arrows_are_pulled_in_the_picture_until_they_are_locked(
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(widget_site / "arrows.html"), "arrows")
    stage = page.locator("#arrows .carts-stage:visible")
    box = page.locator('#arrows .carts-guess[data-on="B"] .carts-number-box')
    handles = stage.locator(".carts-pull circle.carts-pull-room")
    expect(handles).to_have_count(2)
    assert stage.locator(".carts-guessed").count() == 0  # a handle is no arrow yet

    def pull(way: float) -> None:
        place = handles.nth(1).bounding_box()
        assert place
        x, y = place["x"] + place["width"] / 2, place["y"] + place["height"] / 2
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x + way / 2, y)
        page.mouse.move(x + way, y)
        page.mouse.up()

    pull(30)
    first = float(box.input_value())
    assert first > 0
    pull(20)
    assert float(box.input_value()) > first
    pull(-200)
    assert float(box.input_value()) == 0
    guess(page, "A", 2)
    lock(page, "arrows")
    expect(handles).to_have_count(0)


@pytest.mark.one_browser
def test_a_long_arrow_is_typed_and_drawn_cut(open_page: OpenPage, widget_site: Path) -> None:
    page = live(open_page(widget_site / "arrows.html"), "arrows")
    error = page.locator("#arrows .carts-predict-error")
    force = page.locator('.carts-guess[data-on="A"]')
    full = float(force.locator("[type=range]").get_attribute("max") or 0)
    guess(page, "B", 2)
    guess(page, "A", 11 * full)
    expect(force.locator(".carts-error")).to_contain_text(f"0 to {10 * full:g} N, please.")
    page.locator("#arrows .carts-lock").click()
    expect(error).to_contain_text("does not work yet: force on A by B")
    guess(page, "A", 9 * full)
    expect(force.locator(".carts-error")).to_be_hidden()
    guess(page, "A", 110 * full)  # its first figures would do, but nobody meant them
    expect(force.locator(".carts-error")).to_contain_text(f"{9 * full:.1f} N is kept.")
    drawn = page.locator('#arrows .carts-stage-wide .carts-guessed[data-on="A"]')
    assert (drawn.get_attribute("d") or "").count("Z") == 2  # a gap
    lock(page, "arrows")
    compared = page.locator("#arrows .carts-compared")
    expect(compared).to_contain_text(f"{9 * full:.1f} N, arrow cut")


def test_the_lock_by_keyboard_leads_to_play_and_is_read_out(
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(widget_site / "arrows.html"), "arrows")
    guess(page, "A", 2)
    guess(page, "B", 6)
    page.locator("#arrows .carts-lock").focus()
    page.keyboard.press("Enter")
    expect(page.locator("#arrows .carts-play")).to_be_focused()
    page.locator("#arrows .carts-end").click()
    expect(page.locator("#arrows .carts-announcer")).to_contain_text(
        "force on A by B: you 2.0 N, the run 6.9 N."
    )


@pytest.mark.one_browser
def test_the_next_student_can_start_again(open_page: OpenPage, widget_site: Path) -> None:
    page = live(open_page(widget_site / "choice.html"), "choice")
    again, asked = page.locator("#choice .carts-again"), page.locator("#choice .carts-forget")
    expect(again).to_be_hidden()
    page.get_by_label("It turns back", exact=True).check()
    page.locator("#choice .carts-lock").click()
    expect(page.locator("#choice .carts-results")).to_be_visible()
    on_scene(page, "el.time = 3", name="choice")
    again.click()
    expect(asked).to_contain_text("Forget this prediction?")
    page.get_by_role("button", name="Keep it").click()
    expect(asked).to_be_hidden()
    expect(again).to_be_focused()
    again.click()
    page.get_by_role("button", name="Forget it").click()
    for _ in range(2):  # in the page, and after a reload
        expect(page.locator("#choice .carts-results")).to_be_hidden()
        expect(page.locator("#choice .carts-play")).to_be_disabled()
        expect(page.get_by_label("It turns back", exact=True)).not_to_be_checked()
        expect(page.get_by_label("It turns back", exact=True)).to_be_enabled()
        expect(again).to_be_hidden()
        told = on_scene(page, "return [el.trajectory, el.plan, el.time]", name="choice")
        assert told == [None, [], 0]
        page.reload()
    live(page, "choice")
    page.get_by_label("It stops", exact=True).check()
    page.locator("#choice .carts-lock").click()
    expect(page.locator("#choice .carts-results")).to_be_visible()
    again.click()
    page.get_by_role("button", name="Forget it").click()
    page.get_by_label("It turns back", exact=True).check()  # a second time in the same page
    page.locator("#choice .carts-lock").click()
    expect(page.locator("#choice .carts-results")).to_be_visible()
    expect(page.locator("#choice .carts-play")).to_be_enabled()


def test_a_prediction_comes_back_after_a_reload(open_page: OpenPage, widget_site: Path) -> None:
    page = open_page(widget_site / "arrows.html")
    page.locator(".carts-guess [type=text]:enabled").first.wait_for()
    guess(page, "A", 2)
    expect(page.locator("#arrows .carts-saved")).to_have_text("Saved.")
    page.reload()
    expect(page.locator('.carts-guess[data-on="A"] [type=text]')).to_have_value("2.0")
    guess(page, "B", 6)
    lock(page, "arrows")
    expect(page.locator("#arrows .carts-compared")).to_be_visible(timeout=20_000)
    page.reload()
    expect(page.locator("#arrows .carts-compared")).to_contain_text("2.0 N", timeout=20_000)
    expect(page.locator("#arrows .carts-lock")).to_be_hidden()


def test_a_curve_is_typed_or_drawn_and_compared_by_features(
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(widget_site / "curve.html"), "curve")
    heights = page.locator("#curve .carts-height")
    for k, height in enumerate((0, 5, 9, 5)):
        heights.nth(k).fill(str(height))
    page.locator("#curve .carts-pad").scroll_into_view_if_needed()
    pad = page.locator("#curve .carts-pad").bounding_box()
    assert pad
    page.mouse.click(pad["x"] + pad["width"] * 350 / 360, pad["y"] + pad["height"] * 94 / 170)
    expect(heights.nth(4)).to_have_value("3")
    lock(page, "curve")
    compared = page.locator("#curve .carts-compared")
    expect(compared).to_contain_text("starts from zero: your curve yes, the run yes")
    expect(compared).to_contain_text("is zero again at the end: your curve no, the run yes")


@pytest.mark.one_browser
def test_curves_of_velocity_and_position_have_a_direction_and_need_no_contact(
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(widget_site / "speed.html"), "speed")
    for k, height in enumerate((6, 4, 2, -2, -2)):
        page.locator("#speed .carts-height").nth(k).fill(str(height))
    lock(page, "speed")
    compared = page.locator("#speed .carts-compared")
    expect(compared).to_contain_text("stays the same from start to end: your curve no, the run yes")
    expect(compared).to_contain_text("turns round: your curve yes, the run no")
    drawn = page.locator("#speed .carts-pad [data-part=answer]").get_attribute("d") or ""
    heights = {point.split()[1] for point in drawn.lstrip("M").split("L")}
    assert heights == {"10"}, "one height, above the line of rest: to the right"


@pytest.mark.one_browser
def test_an_option_or_a_sentence_is_enough(open_page: OpenPage, widget_site: Path) -> None:
    page = live(open_page(widget_site / "choice.html"), "choice")
    page.locator("#choice .carts-lock").click()
    expect(page.locator("#choice .carts-predict-error")).to_be_visible()
    page.get_by_label("It turns back", exact=True).check()
    lock(page, "choice")
    compared = page.locator("#choice .carts-compared")
    expect(compared).to_contain_text("You said: “It turns back”")
    first = page.locator("#choice .carts-options").get_by_label("It turns back", exact=True)
    expect(first).to_be_checked()
    expect(first).to_be_disabled()
    compared.get_by_label("It stops", exact=True).check()  # the same question once more
    expect(page.locator("#choice .carts-saved")).to_have_text("Saved.")
    page.reload()
    page = live(page, "choice")
    expect(compared.get_by_label("It stops", exact=True)).to_be_checked(timeout=20_000)
    expect(first).to_be_checked()
    page = live(open_page(widget_site / "words.html"), "words")
    page.locator("#words .carts-words").fill("It turns back, <b>I think</b>.")
    expect(page.locator("#words .carts-saved")).to_have_text("Saved.")
    page.reload()
    expect(page.locator("#words .carts-words")).to_have_value("It turns back, <b>I think</b>.")


@pytest.mark.one_browser
def test_without_python_a_prediction_is_kept_and_the_reader_told(
    open_page: OpenPage, widget_site: Path, tmp_path: Path
) -> None:
    site = tmp_path / "broken"
    shutil.copytree(widget_site, site)
    shutil.rmtree(site / "assets" / "carts" / "runtime")
    page = open_page(site / "choice.html")
    page.wait_for_selector('#choice[data-state="failed"]', timeout=10_000)
    page.get_by_label("It turns back", exact=True).check()
    expect(page.locator("#choice .carts-saved")).to_have_text("Saved.")
    page.locator("#choice .carts-lock").click()
    expect(page.locator("#choice .carts-predict-error")).to_contain_text("prediction is kept")


@pytest.mark.one_browser
def test_after_talking_a_prediction_is_changed_once_and_explained(
    open_page: OpenPage, widget_site: Path
) -> None:
    talk = {**CHOICE, "id": "talk", "predict": {**CHOICE["predict"], "talk": True}}
    path = write_page(widget_site, "talk", talk)
    page = live(open_page(path), "talk")
    scene = page.locator("#talk")
    scene.locator("input[type=radio]").first.check()
    scene.locator(".carts-lock").click()
    expect(scene.locator(".carts-talk")).to_be_visible()
    expect(scene.locator(".carts-results")).to_be_hidden()  # nothing is told yet
    expect(scene.locator("input[type=radio]").first).to_be_disabled()
    expect(scene.locator(".carts-saved")).to_have_text("Saved.")
    page.reload()
    live(page, "talk")
    scene.locator(".carts-talk-change").click()
    scene.locator("input[type=radio]").nth(1).check()
    lock(page, "talk")
    expect(scene.locator(".carts-compared")).to_contain_text(
        "First you said: It stops. After talking you said: It turns back."
    )
    scene.locator(".carts-why textarea").fill("B pushes A to the left.")
    expect(scene.locator(".carts-saved")).to_have_text("Saved.")
    page.reload()
    expect(scene.locator(".carts-why textarea")).to_have_value("B pushes A to the left.")


@pytest.mark.one_browser
def test_on_the_projector_hands_are_counted_and_the_run_is_revealed(
    open_page: OpenPage, widget_site: Path
) -> None:
    first, second = CHOICE, {**CHOICE, "id": "second"}
    page = open_page(
        write_page(widget_site, "class", first, second), viewport={"width": 1024, "height": 768}
    )
    live(page, "choice")
    live(page, "second")
    scene = page.locator("#choice")
    scene.locator(".carts-play").evaluate("el => el.closest('carts-scene').focus()")
    scene.locator(".carts-project").click()
    size = scene.locator(".carts-ask").evaluate("el => parseFloat(getComputedStyle(el).fontSize)")
    assert size >= 28
    for box, hands in zip(scene.locator(".carts-hands input").all(), ("18", "6"), strict=True):
        box.fill(hands)
    expect(scene.locator(".carts-hands").first).to_contain_text("18 of 24")
    scene.locator(".carts-project-bar button").first.click()  # Reveal
    expect(scene.locator(".carts-results")).to_be_visible()
    scene.locator(".carts-project-bar button", has_text="Next").click()
    expect(scene).not_to_have_class(re.compile("carts-projector"))
    expect(page.locator("#second")).to_have_class(re.compile("carts-projector"))
    page.keyboard.press("p")
    expect(page.locator("#second")).not_to_have_class(re.compile("carts-projector"))
    page.reload()
    live(page, "choice")
    expect(scene.locator(".carts-results")).to_be_hidden()  # nothing was kept
