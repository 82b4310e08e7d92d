"""A reader who answers, for the tests of questions."""

from __future__ import annotations

import json
from typing import Any

from playwright.sync_api import Page, expect

from sim.lesson.answer_file import read_answer_file
from tests.web.question.question_site import ready

KEEP_FILES = """() => {
  const make = URL.createObjectURL;
  window.files = Object.assign([], { make });
  URL.createObjectURL = (blob) => { window.files.push(blob); return make.call(URL, blob); };
}"""
FILES_GO = "() => { URL.createObjectURL = window.files.make; delete window.files; }"


def saved(page: Page, question: str) -> None:
    expect(page.locator(f"#{question} .carts-q-saved")).to_have_text("Saved")


def answer_everything(page: Page) -> None:
    page.get_by_label("The one on the van").check()
    page.locator("#pick-one .carts-q-sure").get_by_label("I think so").check()
    page.get_by_label("its weight").check()
    page.get_by_label("the support by the road").check()
    page.locator("#how-fast input").fill("30 cm/s")
    page.locator("#resultant input").fill("Zero!")
    page.locator("#why textarea").fill("Same force,\nless mass. <b>Äöü</b> 力")
    page.locator('#story [data-line="b"] .carts-q-down').click()
    page.locator("#partners select").first.select_option("b")
    page.locator("#how-sure").get_by_label("I am sure").check()
    for question in ("pick-one", "pick-many", "how-fast", "resultant", "why", "story"):
        saved(page, question)
    saved(page, "partners")
    saved(page, "how-sure")


def saved_file(page: Page, k: int = 0) -> dict[str, Any]:
    """The answer file that “Save file” makes."""
    page.locator(".carts-bar-open").click()
    page.evaluate(KEEP_FILES)
    page.locator(".carts-answers-save").nth(k).click()
    without = page.locator(".carts-answers-without-code")
    if without.count():  # nobody has said yet who works here
        without.click()
    text = page.evaluate("window.files[0].text()")
    page.evaluate(FILES_GO)
    page.locator(".carts-answers-close").click()
    read_answer_file(text)
    return dict(json.loads(text))


def continue_as(page: Page, code: str, button: str | None = None) -> None:
    page.locator(".carts-bar-open").click()
    page.locator(".carts-answers-code").fill(code)
    with page.expect_navigation():
        page.locator(".carts-answers-go").click()
        if button:
            page.get_by_role("button", name=button).click()
    ready(page)
    expect(page.locator(".carts-bar-who")).to_have_text(code)


def guess(page: Page, on: str, value: float) -> None:
    box = page.locator(f'.carts-guess[data-on="{on}"] [type=text]')
    box.press("ControlOrMeta+a")  # keys, as a reader's: Firefox tells no change of a set value
    box.press_sequentially(str(value))
    box.press("Tab")


def find(page: Page, typed: str, name: str = "hidden", which: str = "B, while it touches A") -> str:
    """Types the mean force on one cart into the box of the scene `name`; what is said of it."""
    finder = page.locator(f"#{name} .carts-find")
    if finder.get_attribute("open") is None:
        finder.locator("summary").click()
    finder.locator("select").select_option(label=which)
    box = finder.locator("input")
    before = page.locator(f"#{name} .carts-find-note").text_content()
    box.press("ControlOrMeta+a")
    box.press_sequentially(typed)
    box.press("Enter")
    # It is answered at once, or when what is right is kept: then the box is empty, or gone.
    page.wait_for_function(
        """([name, typed, before]) => {
          const box = document.querySelector(`#${name} .carts-find input`);
          const note = document.querySelector(`#${name} .carts-find-note`);
          return !box || box.value !== typed || note?.textContent !== before;
        }""",
        arg=[name, typed, before],
    )
    note = page.locator(f"#{name} .carts-find-note")
    return note.inner_text() if note.count() else ""
