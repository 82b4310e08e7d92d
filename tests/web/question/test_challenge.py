"""A challenge counts the runs that were watched, and says honestly which one reached the goal."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

from sim.pages.findings import AuthorError
from tests.web.conftest import OpenPage
from tests.web.question.answering import saved_file
from tests.web.question.question_site import questions_page
from tests.web.scene.given.widget_site import AT_REST

pytestmark = pytest.mark.browser

SCENE = """
```scene
id: two
carts:
  A: {mass: 1 kg, position: 0.3 m, velocity: 0.5 m/s}
  B: {mass: 1 kg, position: 0.8 m}
contact: {restitution: 1, stiffness: 400 N/m}
controls: [{set: B.mass, from: 1 kg, to: 3 kg, step: 0.5 kg}]
until: 1.5 s
```
"""
DEAD = "```challenge\nscene: two\nask: Stop A dead.\ngoal: {}\n```\n"


@pytest.mark.parametrize(
    ("block", "code"),
    [
        (DEAD.format("v.C = 0"), "unknown-path"),
        (DEAD.format("soon"), "not-a-goal"),
        (DEAD.format("v.A = 0").replace("two", "three"), "no-such-scene"),
        (DEAD.format("v.A = 0") + DEAD.format("v.A = 0"), "id-taken"),
        (DEAD.format("v.A = 0").replace("goal", "gaol"), "unknown-key"),
    ],
)
def test_a_challenge_that_makes_no_sense_is_refused(block: str, code: str) -> None:
    with pytest.raises(AuthorError) as refused:
        questions_page("lesson", SCENE + block)
    assert code in {finding.code for finding in refused.value.findings}


@pytest.mark.one_browser
def test_runs_are_counted_once_and_the_first_that_reaches_the_goal_is_told(
    site: Path, open_page: OpenPage
) -> None:
    """On the home page, whose challenge is to stop A dead; a run counts when it was watched."""
    page = open_page(site / "index.html", viewport={"width": 1366, "height": 768})
    tries = page.locator("#home-challenge .carts-challenge-tries")
    found = page.locator("#home-challenge .carts-challenge-found")
    page.wait_for_selector("#home[data-state=live]", timeout=60_000)
    expect(tries).to_be_hidden()
    put: Callable[[str], object] = lambda values: page.evaluate(  # noqa: E731
        f"document.getElementById('home').set({values})"
    )
    page.evaluate("document.getElementById('home').time = 1e9")
    expect(tries).to_have_text("Runs you have tried: 1. None of them does it.")
    put("{'A.mass': 1}")
    expect(tries).to_contain_text("tried: 2.")
    put("{'A.mass': 1, 'contact.restitution': 1}")
    expect(tries).to_have_text("Found in run 3 of 3.")
    expect(found).to_contain_text("1 kg")
    put("{'A.mass': 2}")
    expect(tries).to_have_text("Found in run 3 of 4.")
    page.reload()
    expect(tries).to_have_text("Found in run 3 of 4.")
    put("{'A.mass': 1, 'contact.restitution': 1}")  # that one again
    put("{'A.mass': 3}")
    expect(tries).to_have_text("Found in run 3 of 5.")


@pytest.mark.one_browser
def test_what_was_tried_in_a_lesson_is_kept_with_the_answers(
    site: Path, open_page: OpenPage
) -> None:
    lesson = site / "worksheets" / "newtons-third-law.html"
    page = open_page(lesson, folder=site)
    tries = page.locator("#third-break .carts-challenge-tries")
    page.wait_for_selector("#third-own[data-state=live]", timeout=60_000)
    page.locator("#third-own .carts-predict input[type=radio]").first.check()
    page.locator("#third-own .carts-certainty input").first.check()
    page.locator("#third-own .carts-lock").click()
    page.locator("#third-own .carts-end").click()
    expect(tries).to_contain_text("tried: 1.")
    page.evaluate("document.getElementById('third-own').set({'B.mass': 1})")
    expect(tries).to_contain_text("tried: 2.")
    expect(page.locator("#third-own .carts-saved")).to_have_text("Saved.")
    (kept,) = (item for item in saved_file(page)["items"] if item["type"] == "challenge")
    assert kept["value"] == {"runs": 2, "found": 0, "values": ""}
    assert kept["asked"].startswith("Find a contact")
    again = page.context.new_page()  # another tab, another day
    again.goto(page.url)
    expect(again.locator("#third-break .carts-challenge-tries")).to_contain_text("tried: 2.")
    again.wait_for_selector("#third-own[data-state=live]", timeout=60_000)
    # The run that it opens with is none that was tried.
    again.locator("#third-own").evaluate(AT_REST)
    expect(again.locator("#third-break .carts-challenge-tries")).to_contain_text("tried: 2.")
    page.evaluate("document.getElementById('third-own').set({'B.mass': 1.5})")
    expect(again.locator("#third-break .carts-challenge-tries")).to_contain_text("tried: 3.")
