"""A page in another language says everything in it, whoever made the sentence."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from sim.pages.blocks import makers
from sim.pages.language import speaking, told
from sim.pages.language.extract import sentences
from tests.pages.given.interface_words import BRACKETS, rebuilt, sent_of_runs
from tests.web.conftest import OpenPage
from tests.web.question import question_site as question_pages
from tests.web.question.question_site import question_site
from tests.web.scene.given.widget_site import (
    AT_REST,
    MEETING,
    QUESTIONS,
    in_node,
    live,
    lock,
    widget_site,
    write_page,
)

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]
__all__ = ["question_site", "widget_site"]  # fixtures
EVERYTHING: dict[str, Any] = {
    "id": "everything",
    "title": "Ω",
    "carts": {
        "A": {"mass": "0.5 kg", "position": "0.40 m", "velocity": "0.60 m/s"},
        "B": {"mass": "1.0 kg", "position": "1.30 m"},
        "C": {"mass": "1.0 kg", "position": "1.90 m"},
    },
    "track": {"length": "2.6 m", "left": "wall", "right": "wall"},
    "contact": {"restitution": "0.8", "stiffness": "90 N/m"},
    "effects": [
        {"friction": {"coefficient": "0.01", "static": "0.02"}},
        {"incline": {"angle": "1 deg"}},
        {"drag": {"linear": "0.02 kg/s", "carts": ["A"]}},
        {"push": {"cart": "A", "force": "0.2 N", "until": "1 s"}},
        {"spring": {"between": ["B", "C"], "stiffness": "5 N/m", "length": "0.40 m"}},
    ],
    "until": "4 s",
    "show": ["x", "v", "a", "F", "p", "energy"],
    "controls": [
        {"set": "A.mass", "from": "0.5 kg", "to": "4 kg", "step": "0.1 kg"},
        {"set": "contact.restitution", "from": "0.1", "to": "1", "step": "0.05"},
        {"set": "friction.coefficient", "from": 0, "to": "0.1", "step": "0.01"},
        {"switch": "drag"},
    ],
}
HIDDEN = {**MEETING, "id": "hidden", "title": "Ω", "forces": "hidden"}
WORDS_SCRIPT = f"globalThis.cartsWords = {json.dumps(BRACKETS)};"
WORDS_BODY = '<body><script src="words.js"></script>'
# All that a reader sees or hears: texts, names of controls, hints.
SAID = """() => {
  const WHOLE = ".carts-find > p"; // a sentence with a formula in it
  const found = [];
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    if (!texts.currentNode.parentElement.closest("script, template, textarea, noscript"))
      found.push(texts.currentNode.parentElement.closest(WHOLE)?.textContent
        ?? texts.currentNode.data);
  }
  for (const element of document.querySelectorAll("[aria-label], body [title]"))
    found.push(element.getAttribute("aria-label") ?? "", element.getAttribute("title") ?? "");
  for (const element of document.querySelectorAll("[aria-valuetext]"))
    found.push(element.getAttribute("aria-valuetext"));
  return found;
}"""
# Names that are the same in every language.
NAMES = {"Euler", "RK4", "Words", "before", "after"}


@pytest.fixture(scope="module")
def bracket_site(widget_site: Path) -> Path:
    """Pages in a language that a test can see: [each sentence in brackets]."""
    (widget_site / "words.js").write_text(WORDS_SCRIPT, encoding="utf-8")
    with speaking(BRACKETS):
        for fence in (EVERYTHING, HIDDEN, {**QUESTIONS["arrows"], "title": "Ω"}):
            page = write_page(widget_site, f"brackets-{fence['id']}", fence)
            script = '<script src="words.js"></script>\n<script src="assets'
            text = page.read_text(encoding="utf-8").replace('<script src="assets', script, 1)
            page.write_text(text, encoding="utf-8")
    return widget_site


def unheard(page: Page) -> set[str]:
    """What stands on the page in no brackets, and has letters of a sentence."""
    found = set()
    for text in page.evaluate(SAID):
        rest = text
        while (shorter := re.sub(r"\[[^\[\]]*\]", "", rest)) != rest:
            rest = shorter
        if set(re.findall(r"[A-Za-z]{4,}", rest)) - NAMES:
            found.add(text.strip())
    return found - {"Words before.", "Words after."}


def open_all(page: Page) -> None:
    page.evaluate("for (const part of document.querySelectorAll('details')) part.open = true")


def test_the_page_tells_what_comes_from_python_as_the_generator_does() -> None:
    asked = [*sent_of_runs(), *sentences(), "Do A and B stick?", "A and B", "mass"]
    there = in_node(
        """globalThis.cartsWords = data.words;
        const { told } = await import(view + "/language.js");
        give(data.asked.map(told));""",
        {"words": BRACKETS, "asked": asked},
    )
    with speaking(BRACKETS):
        assert there == [told(rebuilt(one)) for one in asked]


def test_nothing_on_a_scene_is_said_in_another_language(
    bracket_site: Path, open_page: OpenPage
) -> None:
    page = live(open_page(bracket_site / "brackets-everything.html"), "everything")
    open_all(page)
    for choice in page.locator(".carts-choices input").all():
        choice.check()
    for sign in page.locator(".carts-sign:not(.carts-project)").all():
        sign.click()
    page.locator(".carts-how-method").select_option("euler")
    expect(page.locator(".carts-how-told tbody tr").first).to_be_visible()
    page.locator(".carts-number-box").first.fill("1,000")
    page.locator(".carts-number-box").first.press("Enter")
    page.locator("#everything").evaluate("el => { el.time = 1.5 }")
    page.locator("#everything").evaluate("el => el.set({ 'A.position': 9 }).catch(() => {})")
    assert unheard(page) == set()


def test_nothing_in_a_prediction_or_a_search_for_a_force_is_said_in_another_language(
    bracket_site: Path, open_page: OpenPage
) -> None:
    page = live(open_page(bracket_site / "brackets-arrows.html"), "arrows")
    page.locator(".carts-lock").click()  # too early: it says what is missing
    assert unheard(page) == set()
    for box in page.locator(".carts-guess .carts-number-box").all():
        box.fill("2")
        box.press("Enter")
    lock(page, "arrows")
    expect(page.locator(".carts-compared")).to_be_visible()
    open_all(page)
    assert unheard(page) == set()
    page.goto((bracket_site / "brackets-hidden.html").as_uri())
    live(page, "hidden")
    open_all(page)
    for guess in ("x", "-1", "2", "3"):
        page.locator(".carts-find-value input").fill(guess)
        page.locator(".carts-find-form button").click()
        assert unheard(page) == set()


def test_nothing_among_questions_is_said_in_another_language(
    question_site: Path,
    open_page: OpenPage,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What the author wrote stays; everything around it is told."""
    monkeypatch.setattr(makers, "words", lambda _: BRACKETS)
    monkeypatch.setattr(question_pages, "PAGE", question_pages.PAGE.replace("<body>", WORDS_BODY))
    site = Path(shutil.copytree(question_site, tmp_path / "site"))
    (site / "words.js").write_text(WORDS_SCRIPT, encoding="utf-8")
    bank = (question_pages.BANK / "test.md").read_text(encoding="utf-8")
    for name, text in (("kinds", question_pages.ALL_KINDS), ("test", bank)):
        question_pages.write_page(site, name, text, question_pages.BANK)
        page = question_pages.ready(open_page(site / f"{name}.html"))
        for check in page.locator(".carts-q-check:visible").all():
            check.click()
        for typed in page.locator("input.carts-q-typed:visible").all():
            typed.fill("5 furlong")
        for check in page.locator(".carts-q-check:visible").all():
            check.click()
        for part in page.locator(".carts-q-hint, .carts-quiz-hand-in").all():
            if part.is_visible():
                part.click()
        page.locator(".carts-bar-open").click()
        page.locator(".carts-answers-delete button").first.click()
        page.locator(".carts-answers-go").click()  # without a code word: it says what is missing
        if name == "kinds":  # somebody has answered here: were those answers theirs?
            page.locator(".carts-answers-code").fill("BLUE-FOX-27")
            page.locator(".carts-answers-go").click()
            expect(page.locator(".carts-answers-mine")).to_be_visible()
        banks = "".join(p.read_text(encoding="utf-8") for p in question_pages.BANK.glob("*.yml"))
        own = re.sub(r"\W+", " ", f"{text}{banks} BLUE-FOX-27 5 furlong {name}")
        missed = {one for one in unheard(page) if re.sub(r"\W+", " ", one).strip() not in own}
        assert missed == set(), name


@pytest.mark.parametrize("width", [360, 1280])
def test_a_page_from_right_to_left_keeps_the_track_and_its_room(
    widget_site: Path, open_page: OpenPage, width: int
) -> None:
    """+ is to the right for everybody: the picture is the same, and nothing gets wider."""
    page = open_page(widget_site / "meeting.html", viewport={"width": width, "height": 900})
    live(page)
    open_all(page)
    places = """() => [...document.querySelectorAll(".carts-cart, .carts-stage text")]
      .filter((part) => part.checkVisibility())
      .map((part) => Math.round(part.getBoundingClientRect().left
        - part.closest("svg").getBoundingClientRect().left))"""
    before = page.evaluate(places)
    page.evaluate("document.documentElement.dir = 'rtl'")
    page.locator("#meeting").evaluate(AT_REST)
    assert page.evaluate(places) == before
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    slider = page.locator(".carts-slider").first
    assert slider.evaluate("(el) => getComputedStyle(el).direction") == "ltr"
    heading = page.locator(".carts-title")
    assert heading.evaluate("(el) => getComputedStyle(el).direction") == "rtl"
