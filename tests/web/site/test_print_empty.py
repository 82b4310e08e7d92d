"""“Print empty”: a lesson on few sheets, to be filled in by hand."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import continue_as
from tests.web.runtime.boot_site import ROOT
from tests.web.site.pages_of import SHEET

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

SHEETS = 6  # of A4, for the core of a lesson of 45 minutes


@pytest.fixture(scope="module")
def third(site: Path, open_for_all: OpenPage) -> Page:
    """The third law, beside a printer that is not there; it is only printed and looked at."""
    page = open_for_all(site / "worksheets" / "newtons-third-law.html", folder=site)
    page.evaluate("window.print = () => {}")
    return page


@pytest.fixture
def printed(third: Page) -> Page:
    """The third law as it goes to the printer."""
    page = third
    page.emulate_media(media="null")
    if page.locator("html.carts-print-empty").count():  # of the test before
        page.evaluate("dispatchEvent(new Event('afterprint'))")
        expect(page.locator("html")).not_to_have_class(re.compile("carts-print-empty"))
    page.get_by_role("button", name="My answers").click()
    page.get_by_role("button", name="Print empty").click()
    expect(page.locator("html")).to_have_class(re.compile("carts-print-empty"))
    return page


def test_the_core_of_a_lesson_takes_six_sheets(printed: Page) -> None:
    assert len(SHEET.findall(printed.pdf(format="A4"))) <= SHEETS


def test_a_core_sheet_leaves_out_what_is_optional_and_what_a_run_shows(printed: Page) -> None:
    printed.emulate_media(media="print")
    for left_out in ("#third-equal", "#third-changed", "#third-own .carts-story"):
        expect(printed.locator(left_out).first).to_be_hidden()
    for kept in ("#third-wall .carts-stage", "#third-wall .carts-write", "#third-own .carts-stage"):
        expect(printed.locator(kept).locator("visible=true").first).to_be_visible()
    expect(printed.locator(".carts-model").first).to_be_hidden()
    assert printed.locator(".carts-q-waits").locator("visible=true").count() == 0


def test_arrows_that_are_pulled_on_the_screen_have_room_to_be_drawn_on_paper(
    printed: Page,
) -> None:
    printed.emulate_media(media="print")
    scene = printed.locator("#third-pushed-along")
    expect(scene.get_by_text("draw an arrow from each dot")).to_be_visible()
    expect(scene.get_by_text("Pull each arrow")).to_be_hidden()
    guesses = scene.locator(".carts-guess").all()
    assert guesses
    for guess in guesses:
        box = guess.bounding_box()
        assert box
        assert box["height"] > 40  # px: a line of text, and below it a finger's breadth


OUTLINE = "() => JSON.parse(document.getElementById('carts-lesson').textContent).items"


def test_what_is_optional_is_not_counted_as_missing(printed: Page) -> None:
    text = (ROOT / "worksheets" / "newtons-third-law.md").read_text(encoding="utf-8")
    core = text.partition("The lesson ends here.")[0]
    ids = set(re.findall(r"^id: ([\w-]+)$", core, re.MULTILINE))
    asked = [one for one in printed.evaluate(OUTLINE) if one["id"] in ids]
    assert 0 < len(asked) < len(printed.evaluate(OUTLINE))
    expect(printed.locator(".carts-bar-count")).to_have_text(f"0 of {len(asked)}")


def test_questions_that_wait_for_a_run_are_on_the_sheet(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "worksheets" / "return-week-1.html", folder=site)
    page.evaluate("window.print = () => {}")
    form = page.locator("carts-quiz")
    expect(form).to_be_hidden()
    expect(page.locator("carts-after > .carts-q-waits")).to_be_visible()
    page.get_by_role("button", name="My answers").click()
    page.get_by_role("button", name="Print empty").click()
    page.emulate_media(media="print")
    assert form.locator("carts-question").locator("visible=true").count() == 3
    assert page.locator(".carts-q-waits").locator("visible=true").count() == 0
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    page.emulate_media(media="screen")
    expect(form).to_be_hidden()


CURVES = ".carts-graph .carts-curve, .carts-compared, .carts-story li"


def test_what_was_answered_and_watched_is_not_on_an_empty_sheet(
    site: Path, open_page: OpenPage
) -> None:
    """A teacher tries the lesson, and prints it for the class."""
    page = open_page(site / "worksheets" / "momentum-and-restitution.html", folder=site)
    scene = page.locator("#momentum-stays")
    expect(scene).to_have_attribute("data-state", "live", timeout=60_000)
    scene.locator(".carts-predict [type=radio]").nth(1).check()
    scene.locator(".carts-lock").click()
    scene.locator(".carts-end:enabled").click(timeout=60_000)
    expect(scene.locator(".carts-compared")).to_be_visible()
    continue_as(page, "RED-FOX-12", "They are mine")
    expect(scene.locator(".carts-compared")).to_be_visible(timeout=60_000)
    scene.evaluate("scene => { scene.time = 2.5; }")
    page.locator("#momentum-before input").fill("0.3")
    page.evaluate("window.print = () => {}")
    page.get_by_role("button", name="My answers").click()
    page.get_by_role("button", name="Print empty").click()
    page.emulate_media(media="print")
    assert page.locator(CURVES).locator("visible=true").count() == 0
    expect(page.locator(".carts-print-head")).not_to_contain_text("RED-FOX-12")
    sheet = page.locator("carts-blank")
    assert sheet.locator(".carts-options label").locator("visible=true").count() == 4
    assert sheet.locator(".carts-options :checked").count() == 0
    expect(sheet.locator(".carts-stage").locator("visible=true")).to_have_count(1)
    expect(scene).to_be_hidden()
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    page.emulate_media(media="screen")
    expect(sheet).to_have_count(0)
    expect(scene.locator(".carts-compared")).to_be_visible()
    expect(page.locator(".carts-print-head")).to_contain_text("RED-FOX-12")
    expect(page.locator("#momentum-stays-ask")).to_have_count(1)


def test_a_lesson_that_nobody_has_worked_in_is_an_empty_sheet_by_the_browsers_way_to_print(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "worksheets" / "newtons-third-law.html", folder=site)
    page.locator(".carts-bar[data-ready]").wait_for()
    root = page.locator("html")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    expect(root).to_have_class(re.compile("carts-print-empty"))
    head = page.locator(".carts-print-head")
    expect(head).to_contain_text(
        "To print the questions that wait, too: “My answers”, “Print empty”."
    )
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    expect(head).not_to_contain_text("To print")
    expect(root).not_to_have_class(re.compile("carts-print-empty"))
    page.locator("carts-question [type=radio]").first.check()
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    expect(root).not_to_have_class(re.compile("carts-print-empty"))


APART = """(parts) => parts.slice(0, parts.findIndex((one) => one.matches(".carts-predict")))
    .filter((one) => one.checkVisibility() && getComputedStyle(one).breakAfter !== "avoid")
    .map((one) => one.className.baseVal ?? one.className)"""


def test_a_prediction_is_printed_on_the_page_of_its_picture(
    site: Path, open_page: OpenPage
) -> None:
    """As a lesson is printed, and as an empty sheet of it."""
    page = open_page(site / "worksheets" / "momentum-and-restitution.html", folder=site)
    page.emulate_media(media="print")
    frame = page.locator("#momentum-stays > .carts-frame")
    assert frame.locator("> *").evaluate_all(APART) == []
    page.evaluate("document.documentElement.classList.add('carts-print-empty')")
    expect(frame).to_have_css("border-top-width", "0px")
    assert frame.locator("> *").evaluate_all(APART) == []


SMALLEST = 5.5  # points: the small print of a label; two carts of unequal mass had 4


def test_the_numbers_in_a_picture_are_large_enough_on_an_empty_sheet(printed: Page) -> None:
    printed.emulate_media(media="print")
    points = printed.locator(".carts-stage text:not(.carts-name)").evaluate_all(
        """(texts) => texts.filter((one) => one.checkVisibility() && one.textContent)
            .map((one) => 0.75 * parseFloat(getComputedStyle(one).fontSize)
                * one.ownerSVGElement.getBoundingClientRect().height
                / one.ownerSVGElement.viewBox.baseVal.height)"""
    )
    assert points
    assert min(points) > SMALLEST


def test_a_form_that_is_not_open_takes_no_sheet(site: Path, open_page: OpenPage) -> None:
    """The test after the lessons opens with the teacher's word: only its title was printed."""
    page = open_page(site / "worksheets" / "test-forces-and-motion.html", folder=site)
    expect(page.get_by_text("It opens with your teacher's word.")).to_be_visible()
    page.evaluate("window.print = () => {}")
    page.get_by_role("button", name="My answers").click()
    page.get_by_role("button", name="Print empty").click()
    page.emulate_media(media="print")
    expect(page.locator("carts-quiz").locator("visible=true")).to_have_count(1)
    assert len(SHEET.findall(page.pdf(format="A4"))) == SHEETS - 1
