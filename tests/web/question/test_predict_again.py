"""Predictions that are kept, changed once after talking, shown to a class, begun again."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage, SharePage
from tests.web.question.answering import guess
from tests.web.scene.given.widget_site import (
    ARROWS,
    CHOICE,
    CURVE,
    WORDS,
    live,
    lock,
    on_scene,
    widget_site,
    write_page,
)

__all__ = ["widget_site"]  # a fixture

pytestmark = pytest.mark.browser


@pytest.mark.one_browser
def test_a_prediction_comes_back_after_a_reload(shared_page: SharePage, widget_site: Path) -> None:
    page = shared_page(widget_site / "arrows.html")
    page.locator(".carts-guess [type=text]:enabled").first.wait_for()
    guess(page, "A", 2)
    expect(page.locator("#arrows .carts-saved")).to_have_text("Saved.")
    page.reload()
    expect(page.locator('.carts-guess[data-on="A"] [type=text]')).to_have_value("2.0")
    guess(page, "B", 6)
    lock(page, "arrows")
    expect(page.locator("#arrows .carts-compared")).to_be_visible(timeout=20_000)
    expect(page.locator("#arrows .carts-saved")).to_have_text("Saved.")  # that it was watched
    page.reload()
    expect(page.locator("#arrows .carts-compared")).to_contain_text("2.0 N", timeout=20_000)
    expect(page.locator("#arrows .carts-lock")).to_be_hidden()


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
    expect(page.locator("#choice")).to_have_attribute("data-unshown", "")  # for text that waits


@pytest.mark.one_browser
def test_after_talking_a_prediction_is_changed_once_and_explained(
    shared_page: SharePage, widget_site: Path
) -> None:
    talk = {**CHOICE, "id": "talk", "predict": {**CHOICE["predict"], "talk": True}}
    path = write_page(widget_site, "talk", talk)
    page = live(shared_page(path), "talk")
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
    scene.locator(".carts-why textarea").fill("It was pushed back by B.\n" * 9)
    page.emulate_media(media="print")  # all nine lines, and none to be written on
    inside = "el => el.clientHeight >= el.scrollHeight && el.scrollHeight"
    assert scene.locator(".carts-why textarea").evaluate(inside) > 9 * 12
    expect(scene.locator(".carts-write")).to_be_hidden()
    scene.locator(".carts-why textarea").fill("")
    expect(scene.locator(".carts-why textarea")).to_be_hidden()
    expect(scene.locator(".carts-write")).to_be_visible()


@pytest.mark.one_browser
@pytest.mark.parametrize(
    ("given", "first"),
    [
        (ARROWS, ".carts-guess input"),
        (CHOICE, "input:checked"),
        (CURVE, ".carts-height"),
        (WORDS, "textarea"),
    ],
    ids=["arrows", "choice", "curve", "words"],
)
def test_who_changes_a_prediction_by_keyboard_is_at_what_can_be_changed(
    shared_page: SharePage, widget_site: Path, given: dict[str, Any], first: str
) -> None:
    talk = {**given, "id": "keys", "predict": {**given["predict"], "talk": True}}
    page = live(shared_page(write_page(widget_site, f"keys-{given['id']}", talk)), "keys")
    scene = page.locator("#keys")
    if given is ARROWS:
        guess(page, "A", 2)
        guess(page, "B", 6)
    if given is CHOICE:
        scene.get_by_label("It turns back", exact=True).check()
    for box in scene.locator(".carts-height, textarea").filter(visible=True).all():
        box.fill("2")
    scene.locator(".carts-lock").click()
    expect(scene.locator(".carts-talk")).to_be_focused()  # no button: Enter may still be held
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")  # to “Change it once”
    page.keyboard.press("Enter")
    expect(scene.locator(".carts-predict").locator(first).first).to_be_focused()


@pytest.mark.one_browser
def test_on_the_projector_hands_are_counted_and_the_run_is_revealed(
    shared_page: SharePage, widget_site: Path
) -> None:
    first, second = CHOICE, {**CHOICE, "id": "second"}
    page = shared_page(
        write_page(widget_site, "class", first, second), window={"width": 1024, "height": 768}
    )
    live(page, "choice")
    live(page, "second")
    scene = page.locator("#choice")
    scene.locator(".carts-play").evaluate("el => el.closest('carts-scene').focus()")
    scene.locator(".carts-project").click()
    expect(scene.locator(".carts-project")).to_have_text("Leave projector (Esc)")
    size = scene.locator(".carts-ask").evaluate("el => parseFloat(getComputedStyle(el).fontSize)")
    assert size >= 28
    picture = scene.locator(".carts-world").bounding_box()
    assert picture
    assert picture["height"] > 500  # no white below it
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
    expect(page.locator("#second .carts-project")).to_have_text("projector")
    page.reload()
    live(page, "choice")
    expect(scene.locator(".carts-results")).to_be_hidden()  # nothing was kept


@pytest.mark.one_browser
def test_the_next_student_can_start_again(shared_page: SharePage, widget_site: Path) -> None:
    page = live(shared_page(widget_site / "choice.html"), "choice")
    again, asked = page.locator("#choice .carts-again"), page.locator("#choice .carts-forget")
    expect(again).to_be_hidden()
    page.get_by_label("It turns back", exact=True).check()
    page.locator("#choice .carts-lock").click()
    expect(page.locator("#choice .carts-results")).to_be_visible()
    on_scene(page, "el.time = 3", name="choice")
    again.click()
    expect(asked).to_contain_text("Forget this prediction and what was written below it?")
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
    asked_once = """let answers = 0;
    const detail = { message: { kind: "run" }, answer: () => (answers += 1) };
    el.dispatchEvent(new CustomEvent("carts-asked", { detail }));
    return answers;"""
    assert on_scene(page, asked_once, name="choice") == 1  # not once more for each student
    page.get_by_label("It turns back", exact=True).check()  # a second time in the same page
    page.locator("#choice .carts-lock").click()
    expect(page.locator("#choice .carts-results")).to_be_visible()
    expect(page.locator("#choice .carts-play")).to_be_enabled()
