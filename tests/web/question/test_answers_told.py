"""“My answers” says what it did, and what went wrong as an error."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import continue_as, saved, saved_file
from tests.web.question.question_site import question_site, ready

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

__all__ = ["question_site"]  # a fixture

MIDDLES = """(all) => all.map((one) => one.getBoundingClientRect())
    .map(({ top, bottom }) => (top + bottom) / 2)"""
MALAY = {"who": "belum ada kata kod", "count": "0 daripada 17", "open": "Jawapan saya"}
"""What stands at the foot in the longest of our languages."""


def begun(open_page: OpenPage, site: Path, **context: object) -> Page:
    page = ready(open_page(site / "kinds.html", **context))
    page.locator("#why textarea").fill("mine")
    saved(page, "why")
    return page


def give(page: Page, name: str, text: str) -> None:
    file = {"name": name, "mimeType": "application/json", "buffer": text.encode("utf-8")}
    page.get_by_label("Bring answers back from a file").set_input_files(file)


def test_who_clears_the_answers_may_keep_them_and_is_told_that_they_are_gone(
    open_page: OpenPage, question_site: Path
) -> None:
    page = begun(open_page, question_site)
    page.locator(".carts-bar-open").click()
    part = page.locator(".carts-answers-leave")
    part.get_by_role("button", name="Clear my answers here").click()
    part.get_by_role("button", name="Keep them").click()
    part.get_by_role("button", name="Clear my answers here").click()
    part.get_by_role("button", name="Clear my answers").click()
    told = page.locator(".carts-bar").get_by_text("Cleared. The next student can begin.")
    expect(told).to_be_visible()
    expect(page.locator("#why textarea")).to_have_value("")


def test_from_a_file_of_somebody_else_one_press_leads_to_these_answers(
    open_page: OpenPage, question_site: Path
) -> None:
    page = begun(open_page, question_site)
    continue_as(page, "RED-FOX-12", "They are mine")
    text = json.dumps(saved_file(page))
    fresh = ready(open_page(question_site / "kinds.html"))
    fresh.locator(".carts-bar-open").click()
    give(fresh, "mine.json", text)
    expect(fresh.get_by_text("This file is of RED-FOX-12.")).to_be_visible()
    expect(fresh.get_by_text("Nothing has been answered yet.")).to_be_hidden()
    fresh.get_by_role("button", name="Continue as RED-FOX-12").click()
    expect(fresh.locator(".carts-bar-who")).to_have_text("RED-FOX-12")
    expect(fresh.locator("#why textarea")).to_have_value("mine")


def test_a_wrong_file_is_named_in_the_colour_of_errors(
    open_page: OpenPage, question_site: Path
) -> None:
    page = begun(open_page, question_site)
    page.locator(".carts-bar-open").click()
    give(page, "holiday.json", "no answers")
    told = page.locator(".carts-answers-files [role=status]")
    expect(told).to_have_text("holiday.json: This file is damaged, or it is not a file of answers.")
    expect(told).to_have_css("color", "rgb(179, 38, 30)")
    page.locator(".carts-answers-who input").fill("x!")
    page.locator(".carts-answers-go").click()
    bad = page.locator(".carts-answers-who [role=status]")
    expect(bad).to_have_css("color", "rgb(179, 38, 30)")
    page.locator(".carts-answers-who input").fill("RED-FOX-12")
    page.locator(".carts-answers-go").click()
    expect(bad).not_to_have_css("color", "rgb(179, 38, 30)")


def test_more_contrast_leaves_no_pale_words_and_a_choice_has_a_frame_in_forced_colours(
    open_page: OpenPage, question_site: Path
) -> None:
    page = begun(open_page, question_site)
    page.locator(".carts-q-option input").first.check()
    page.locator(".carts-bar-open").click()
    quiet = page.locator("dialog .carts-quiet").first
    ink = quiet.evaluate("(one) => getComputedStyle(one.closest('.carts')).color")
    expect(quiet).not_to_have_css("color", ink)
    page.emulate_media(contrast="more")
    expect(quiet).to_have_css("color", ink)
    page.emulate_media(contrast="no-preference", forced_colors="active")
    expect(page.locator(".carts-q-option:has(:checked)").first).to_have_css("outline-width", "2px")


def test_on_the_smallest_phone_the_line_at_the_foot_is_one_row(
    open_page: OpenPage, question_site: Path
) -> None:
    page = begun(open_page, question_site, viewport={"width": 320, "height": 640})
    for part, words in MALAY.items():
        page.locator(f".carts-bar-{part}").evaluate(
            "(one, words) => (one.textContent = words)", words
        )
    page.evaluate("document.documentElement.style.fontSize = '20px'")  # as in the theme
    rows = page.locator(".carts-bar-row > :not(progress)").evaluate_all(MIDDLES)
    assert max(rows) - min(rows) < 3
