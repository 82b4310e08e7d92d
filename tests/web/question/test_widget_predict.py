"""A prediction: kept at every input, locked once, and until then nothing is told."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import SharePage
from tests.web.question.answering import guess
from tests.web.scene.given.widget_site import AT_REST, live, lock, on_scene, widget_site

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture


@pytest.mark.one_browser
def test_nothing_is_told_before_the_lock(shared_page: SharePage, widget_site: Path) -> None:
    page = live(shared_page(widget_site / "arrows.html"), "arrows")
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
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "guessed.html"), "guessed")
    page.locator("#guessed").evaluate(AT_REST)  # tables are filled a while after the run is there
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    values = page.locator('#guessed [data-body="A"] .carts-value')
    assert values.all_inner_texts() == ["5", "0.500", "1.00", "–", "–"]
    assert page.locator("#guessed .carts-graph td").count() == 0
    assert page.locator("#guessed .carts-curve[d^='M46']").count() == 0
    page.evaluate("dispatchEvent(new Event('afterprint'))")


@pytest.mark.one_browser
def test_after_the_lock_a_graph_says_what_it_cannot_draw(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "guessed.html"), "guessed")
    page.get_by_label("It stops", exact=True).check()
    lock(page, "guessed")
    force = page.locator('#guessed [data-quantity="F"] .carts-key')
    expect(force).to_contain_text("too large and too short to draw: see the impulses")
    acceleration = page.locator('#guessed [data-quantity="a"] .carts-key')
    expect(acceleration).to_contain_text("the acceleration is too large and too short to draw")
    expect(page.locator('#guessed [data-body="A"] [data-quantity="F"]')).to_have_text("0.00")


@pytest.mark.one_browser
def test_arrows_are_drawn_kept_locked_and_compared(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "arrows.html"), "arrows")
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


@pytest.mark.one_browser
def test_arrows_that_were_locked_are_not_to_be_drawn_on_paper_while_the_run_still_plays(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "arrows.html"), "arrows")
    to_draw = """() => [...document.querySelectorAll("#arrows .carts-guess")].map(
        (line) => getComputedStyle(line, "::after").content !== "none")"""
    page.emulate_media(media="print")
    assert page.evaluate(to_draw) == [True, True]
    page.emulate_media(media="null")
    guess(page, "A", 2)
    guess(page, "B", 6)
    if (sure := page.locator("#arrows .carts-certainty input")).count():
        sure.first.check()
    page.locator("#arrows .carts-lock").click()
    expect(page.locator("#arrows .carts-results")).to_be_visible()
    page.emulate_media(media="print")
    assert page.evaluate(to_draw) == [False, False]


def test_arrows_are_pulled_in_the_picture_until_they_are_locked(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "arrows.html"), "arrows")
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
def test_a_long_arrow_is_typed_and_drawn_cut(shared_page: SharePage, widget_site: Path) -> None:
    page = live(shared_page(widget_site / "arrows.html"), "arrows")
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
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "arrows.html"), "arrows")
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
def test_an_option_or_a_sentence_is_enough(shared_page: SharePage, widget_site: Path) -> None:
    page = live(shared_page(widget_site / "choice.html"), "choice")
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
    page = live(shared_page(widget_site / "words.html"), "words")
    page.locator("#words .carts-words").fill("It turns back, <b>I think</b>.")
    expect(page.locator("#words .carts-saved")).to_have_text("Saved.")
    page.reload()
    expect(page.locator("#words .carts-words")).to_have_value("It turns back, <b>I think</b>.")


@pytest.mark.one_browser
def test_what_is_locked_is_no_form_any_more(shared_page: SharePage, widget_site: Path) -> None:
    """It stood there greyed, with its button, until all of the run was seen: as if not done."""
    page = live(shared_page(widget_site / "choice.html"), "choice")
    page.get_by_label("It stops", exact=True).check()
    page.locator("#choice .carts-lock").click()
    expect(page.locator("#choice .carts-lock")).to_be_hidden()
    assert page.locator("#choice .carts-compared").is_hidden()
    labels = page.locator("#choice .carts-options label").locator("visible=true")
    assert labels.all_inner_texts() == ["It stops"]
