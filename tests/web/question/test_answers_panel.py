"""“My answers”: code words, files, a shared laptop; forms that open and are handed in."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import (
    KEEP_FILES,
    answer_everything,
    continue_as,
    saved,
    saved_file,
)
from tests.web.question.question_site import question_site, ready

pytestmark = pytest.mark.browser

__all__ = ["question_site"]  # a fixture

IN_READINGS = """(act) => new Promise((resolve, reject) => {
  const opening = indexedDB.open("carts:question-tests-measured", 1);
  opening.onupgradeneeded = () => opening.result.createObjectStore("answers");
  opening.onerror = () => reject(opening.error);
  opening.onsuccess = () => {
    const work = opening.result.transaction("answers", "readwrite");
    const asked = act(work.objectStore("answers"));
    work.oncomplete = () => { opening.result.close(); resolve(asked.result); };
  };
})"""
KEEP_READINGS = f"() => ({IN_READINGS})((kept) => kept.put({{ text: '0 0.1' }}, 'page/film'))"
WRITE = "(box, text) => { box.value = text; box.dispatchEvent(new Event('input')); }"
COUNT_READINGS = f"() => ({IN_READINGS})((kept) => kept.count())"


@pytest.mark.one_browser
def test_answers_are_listed_as_their_questions_stand(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    page.locator("#why textarea").fill("last on the page")
    saved(page, "why")
    page.get_by_label("The one on the van").check()
    saved(page, "pick-one")
    page.locator(".carts-bar-open").click()
    said = page.locator(".carts-answers-said dd:not(.carts-quiet)")
    expect(said).to_have_count(2)
    assert "The one on the van" in said.nth(0).inner_text()
    assert said.nth(1).inner_text() == "last on the page"


@pytest.mark.one_browser
def test_a_file_counts_as_the_line_at_the_foot_does_and_says_what_is_more(
    open_page: OpenPage, question_site: Path
) -> None:
    """“14 of 17” stood beside “21 answers”."""
    page = ready(open_page(question_site / "kinds.html"))
    answer_everything(page)
    expect(page.locator(".carts-bar-count")).to_have_text("7 of 7")
    page.locator(".carts-bar-open").click()
    held = page.locator(".carts-answers-name")
    expect(held).to_contain_text("7 of 7 answered + 1 more answer ·")
    expect(held).not_to_contain_text("8 answers")


@pytest.mark.one_browser
def test_a_student_sees_nobody_elses_answers(open_page: OpenPage, question_site: Path) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    page.locator("#why textarea").fill("from somebody")
    saved(page, "why")
    continue_as(page, "BLUE-FOX-27", "They are mine")
    expect(page.locator("#why textarea")).to_have_value("from somebody")
    page.get_by_label("its weight").check()
    saved(page, "pick-many")
    page.evaluate("() => sessionStorage.setItem('carts-watched', '[1]')")  # what a tab remembers
    continue_as(page, "RED-OWL-13", "Yes, somebody else")
    assert page.evaluate("() => Object.keys(sessionStorage)") == []
    expect(page.locator("#why textarea")).to_have_value("")
    expect(page.get_by_label("its weight")).not_to_be_checked()
    page.locator(".carts-bar-open").click()
    assert "BLUE" not in page.get_by_role("dialog").inner_text()
    page.keyboard.press("Escape")
    page.locator("#why textarea").fill("the owl's")
    saved(page, "why")
    continue_as(page, "BLUE-FOX-27")
    expect(page.locator("#why textarea")).to_have_value("from somebody")
    expect(page.get_by_label("its weight")).to_be_checked()
    content = saved_file(page)
    assert content["student"] == "BLUE-FOX-27"
    assert len(content["items"]) == 2
    page.locator(".carts-bar-open").click()
    page.locator(".carts-answers-clear button").first.click()
    with page.expect_navigation():
        page.get_by_role("button", name="Clear my answers").click()
    ready(page)
    expect(page.locator(".carts-bar-who")).to_have_text("no code word yet")
    expect(page.locator("#why textarea")).to_have_value("")
    continue_as(page, "RED-OWL-13")
    expect(page.locator("#why textarea")).to_have_value("the owl's")
    page.evaluate(KEEP_READINGS)  # of real carts, by whoever used that page
    page.locator(".carts-bar-open").click()
    page.locator(".carts-answers-delete button").first.click()
    with page.expect_navigation():
        page.get_by_role("button", name="Delete all of them").click()
    ready(page)
    assert page.evaluate(COUNT_READINGS) == 0
    continue_as(page, "RED-OWL-13")
    expect(page.locator("#why textarea")).to_have_value("")


@pytest.mark.one_browser
def test_a_file_without_a_code_word_is_asked_for_one_and_takes_it(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    page.locator("#why textarea").fill("nobody's yet")
    saved(page, "why")
    page.locator(".carts-bar-open").click()
    page.evaluate(KEEP_FILES)
    page.locator(".carts-answers-save").first.click()
    assert page.evaluate("window.files.length") == 0
    page.locator(".carts-answers-whose input").fill("blue fox 27")
    page.locator("#why textarea").evaluate(WRITE, "written behind it")  # takes away nothing typed
    saved(page, "why")
    with page.expect_navigation():
        page.locator(".carts-answers-with-code").click()
        name = page.evaluate("window.files[0].text()")
        assert '"student": "BLUE-FOX-27"' in name
    ready(page)
    expect(page.locator(".carts-bar-who")).to_have_text("BLUE-FOX-27")
    expect(page.locator("#why textarea")).to_have_value("written behind it")


KEEP_FOX = f"""() => ({IN_READINGS.replace("-measured", "")})(
  (kept) => kept.put({{ id: "why", value: "the fox's", last: "2027" }}, "@BLUE-FOX-27/page#why"))"""


@pytest.mark.one_browser
def test_a_code_word_typed_for_a_file_alone_takes_nothing_to_answers_that_are_here_under_it(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    page.evaluate(KEEP_FOX)
    page.locator("#why textarea").fill("nobody's yet")
    saved(page, "why")
    page.locator(".carts-bar-open").click()
    page.locator(".carts-answers-save").first.click()
    page.locator(".carts-answers-whose input").fill("blue fox 27")
    with page.expect_download():
        page.locator(".carts-answers-with-code").click()
    expect(page.locator(".carts-answers-whose")).to_contain_text("are on this computer already")
    expect(page.locator(".carts-bar-who")).to_have_text("no code word yet")


@pytest.mark.one_browser
def test_a_browser_that_refuses_to_clear_the_answers_is_told_of(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    page.locator("#why textarea").fill("still here")
    saved(page, "why")
    refuse = "IDBObjectStore.prototype.delete = () => { throw new Error('refused'); }"
    page.evaluate(f"() => {{ {refuse} }}")
    page.locator(".carts-bar-open").click()
    part = page.locator(".carts-answers-leave")
    part.get_by_role("button", name="Clear my answers here").click()
    sure = part.get_by_role("button", name="Clear my answers")
    expect(sure).to_have_accessible_description(
        "Is your file saved? Your answers on this computer will be gone."
    )
    sure.click()
    expect(part.get_by_role("status")).to_contain_text("answers are still on this computer")


def bring_back(page: Page, name: str, text: str) -> None:
    page.locator(".carts-bar-open").click()
    expect(page.locator("dialog.carts-answers[open]")).to_be_visible()
    page.locator(".carts-answers-open").set_input_files(
        {"name": name, "mimeType": "application/json", "buffer": text.encode("utf-8")}
    )


@pytest.mark.one_browser
def test_a_file_brings_answers_back_without_losing_what_is_there(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    answer_everything(page)
    content = saved_file(page)
    fresh = ready(open_page(question_site / "kinds.html"))
    fresh.locator("#why textarea").fill("written later")
    saved(fresh, "why")
    bring_back(fresh, "kinds.worksheet.no-code.carts.json", json.dumps(content))
    expect(fresh.locator(".carts-answers-status").nth(1)).to_contain_text("nothing that was here")
    expect(fresh.locator("#how-fast input")).to_have_value("30 cm/s")
    fresh.keyboard.press("Escape")
    expect(fresh.locator("#why textarea")).to_have_value("written later")
    expect(fresh.locator("#why .carts-q-earlier")).to_contain_text("less mass")
    values = [item["value"] for item in saved_file(fresh)["items"] if item["id"] == "why"]
    assert values == ["Same force,\nless mass. <b>Äöü</b> 力", "written later"]


@pytest.mark.one_browser
def test_a_damaged_or_foreign_file_changes_nothing(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    page.locator("#why textarea").fill("mine")
    saved(page, "why")
    good = saved_file(page)
    item = good["items"][0]
    for text, told in (
        (json.dumps(good)[:-40], "damaged"),
        (json.dumps({**good, "format": 2}), "newer version"),
        (json.dumps({**good, "site": "another-school"}), "another site"),
        (json.dumps({**good, "items": [{**item, "value": {"__proto__": {"x": 1}}}]}), "damaged"),
        (" " * 10_000_000, "too large"),
        ("[]", "not a file of answers"),
    ):
        bring_back(page, "x.json", text)
        expect(page.locator(".carts-answers-status").nth(1)).to_contain_text(told)
        page.keyboard.press("Escape")
    page.reload()
    ready(page)
    expect(page.locator("#why textarea")).to_have_value("mine")
    assert saved_file(page)["items"] == good["items"]


@pytest.mark.one_browser
def test_a_mistyped_code_word_is_corrected_and_the_answers_come_along(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    page.locator("#why textarea").fill("my own words")
    saved(page, "why")
    continue_as(page, "HELLO-THERE", "They are mine")
    continue_as(page, "BLUE-FOX-27", "No, that is me")
    expect(page.locator("#why textarea")).to_have_value("my own words")
    assert saved_file(page)["student"] == "BLUE-FOX-27"
    continue_as(page, "HELLO-THERE", "Yes, somebody else")  # nothing is left there
    expect(page.locator("#why textarea")).to_have_value("")
