"""What a question says to an answer, and what it keeps of presses, first ideas, watched runs."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import saved, saved_file
from tests.web.question.question_site import question_site, ready, write_page

pytestmark = pytest.mark.browser

__all__ = ["question_site"]  # a fixture


@pytest.mark.one_browser
def test_check_says_what_fits_the_answer_and_hints_come_one_by_one(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    one = page.locator("#pick-one")
    one.locator(".carts-q-check").click()
    expect(one.locator(".carts-q-error")).to_have_text("Answer first.")
    page.get_by_label("The one on the van").check()
    one.locator(".carts-q-check").click()
    expect(one.locator(".carts-q-feedback")).to_have_text(
        "Not yet. Think again. Compare the two arrows.", use_inner_text=True
    )
    one.locator(".carts-q-hint").click()
    expect(one.get_by_text("Look at both bumpers.")).to_be_visible()
    expect(one.get_by_text("Which object does each force act on?")).to_be_hidden()
    page.get_by_label("They are equal").check()
    expect(one.locator(".carts-q-feedback")).to_be_empty()
    one.locator(".carts-q-check").click()
    expect(one.locator(".carts-q-feedback")).to_contain_text("The two forces are a pair.")
    number = page.locator("#how-fast")
    for typed, told in (
        ("1,000", "can mean 1 or 1000"),
        ("3 kg", "does not fit here"),
        ("4.8", "You multiplied."),
        ("-0.3", "The size is right. What about its sign?"),
        ("0,301", "Right."),
    ):
        number.locator("input").fill(typed)
        number.locator(".carts-q-check").click()
        expect(number).to_contain_text(told)
    words = page.locator("#resultant")
    words.locator("input").fill("I do not think that there is one")
    words.locator(".carts-q-check").click()
    expect(words).to_contain_text("This page does not know that answer.")
    why = page.locator("#why")
    why.locator("textarea").fill("Less mass.")
    why.locator(".carts-q-check").click()
    expect(why.locator(".carts-q-feedback")).to_contain_text("the mass is not")
    assert "Larger force on the light cart" not in page.content()  # the rubric is the teacher's


@pytest.mark.one_browser
def test_what_was_said_to_a_checked_answer_is_there_after_a_reload_until_it_changes(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    one = page.locator("#pick-one")
    said = one.locator(".carts-q-feedback")
    for answer in ("The one on the van", "They are equal", "The one on the van"):
        page.get_by_label(answer).check()
        one.locator(".carts-q-check").click()  # the third time the explanation is told as well
    told = said.inner_text()
    assert told.startswith("Not quite right. Read why.")  # nobody thinks again below the answer
    assert "Compare the two arrows." in told and "The two forces are a pair." in told
    saved(page, "pick-one")
    page.reload()
    ready(page)
    expect(said).to_have_text(told, use_inner_text=True)
    page.get_by_label("They are equal").check()
    expect(said).to_be_empty()
    saved(page, "pick-one")
    page.reload()
    ready(page)
    expect(page.get_by_label("They are equal")).to_be_checked()
    expect(said).to_be_empty()
    items = {item["id"]: item for item in saved_file(page)["items"]}
    assert items["pick-one"]["tries"] == 3
    assert "judged" not in items["pick-one"]


IDEA = """# Two vans

```question
id: guess-first
type: idea
ask: Before you try. Who is right?
options: [Ana, Ben]
```

```question
id: think-again
type: long
ask: And now?
idea: guess-first
rubric:
  1: says what changed
  0: anything else
```
"""


@pytest.mark.one_browser
def test_a_first_idea_is_kept_never_marked_and_stands_beside_the_last_answer(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(write_page(question_site, "ideas", IDEA)))
    first = page.locator("#think-again .carts-q-first")
    page.get_by_label("Ana").check()
    saved(page, "guess-first")
    expect(page.locator("#guess-first .carts-q-check")).to_have_count(0)
    expect(page.locator("#guess-first .carts-q-feedback")).to_be_empty()
    expect(first).to_be_hidden()
    page.locator("#think-again textarea").fill("It was Ben.")
    expect(first).to_have_text("Your first idea was: A: Ana")
    page.reload()
    ready(page)
    expect(page.get_by_label("Ana")).to_be_checked()
    expect(first).to_have_text("Your first idea was: A: Ana")


# A scene that was watched, as the elements of scenes tell it (sim/web/src/scene/time/watch.js).
WATCH = """(scene) => {
  scene.dataset.watched = "";
  scene.dispatchEvent(new Event("carts-watched", { bubbles: true }));
}"""
SCENES = """() => {
  const scene = (id) => Object.assign(document.createElement("carts-scene"), { id });
  const question = document.getElementById("pick-one");
  question.before(scene("other"), document.createElement("h2"), scene("beside"));
}"""


@pytest.mark.one_browser
def test_the_press_that_was_right_and_the_answer_before_the_run_are_kept(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    page.evaluate(SCENES)
    one = page.locator("#pick-one")
    page.get_by_label("The one on the van").check()
    one.locator(".carts-q-check").click()
    page.locator("#other").evaluate(WATCH)  # stands under another heading
    page.get_by_label("The one on the trailer").check()
    page.locator("#beside").evaluate(WATCH)
    for answer in ("They are equal", "The one on the van"):  # what was right stays so
        page.get_by_label(answer).check()
        one.locator(".carts-q-check").click()
    page.locator("#beside").evaluate(WATCH)
    page.locator("#resultant input").fill("zero")  # after the run, with nothing before it
    saved(page, "pick-one")
    saved(page, "resultant")
    items = {item["id"]: item for item in saved_file(page)["items"]}
    assert (items["pick-one"]["tries"], items["pick-one"]["right"]) == (3, 2)
    assert items["pick-one"]["before"]["value"] == "c"
    assert "before" not in items["resultant"] and "right" not in items["resultant"]
