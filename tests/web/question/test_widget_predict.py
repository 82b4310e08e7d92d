"""A prediction: kept at every input, locked once, and until then nothing is told."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import guess
from tests.web.scene.given.widget_site import live, lock, on_scene, widget_site, write_page

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture


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


@pytest.mark.one_browser
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


PUSHED = {
    "id": "pushed", "title": "A steady push, then none", "slow": "never", "until": "2.6 s",
    "carts": {"A": {"mass": "0.5 kg", "position": "0.3 m"}}, "track": {"length": "2.4 m"},
    "effects": [{"push": {"cart": "A", "force": "0.2 N", "until": "2 s"}}],
    "predict": {"ask": "Draw the velocity of A.", "curve": "v.A"},
}  # fmt: skip


@pytest.mark.one_browser
@pytest.mark.parametrize(
    ("drawn", "evenly", "level"),
    [
        ((0, 3, 6, 9, 9), "yes", "yes"),
        ((0, 9, 9, 9, 0), "no", "no"),
        ((0, 5, 8, 9, 9), "no", "yes"),
    ],
    ids=["as the run", "as fast as pushed", "gains less and less"],
)
def test_a_velocity_that_goes_with_the_push_differs_from_one_that_grows_with_it(
    open_page: OpenPage, widget_site: Path, drawn: tuple[int, ...], evenly: str, level: str
) -> None:
    page = live(open_page(write_page(widget_site, "pushed", PUSHED)), "pushed")
    for k, height in enumerate(drawn):
        page.locator("#pushed .carts-height").nth(k).fill(str(height))
    lock(page, "pushed")
    compared = page.locator("#pushed .carts-compared")
    for feature, mine in (
        ("changes evenly in the first half", evenly),
        ("stays the same in the last quarter", level),
    ):
        expect(compared).to_contain_text(f"{feature}: your curve {mine}, the run yes")
    expect(compared).not_to_contain_text("turns round")


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
