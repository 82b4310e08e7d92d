"""Nothing that an author or a student writes, and nothing in a file, is ever run."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from sim.lesson import read_question
from sim.lesson.kinds.unformatted import unformatted
from sim.pages.question.render import render_question
from sim.scene.problem import Problem
from tests.web.conftest import OpenPage
from tests.web.question.question_site import PAGE, SITE_ID, question_site, ready
from tests.web.question.xss import payloads

__all__ = ["question_site"]  # a fixture

LISTEN = "window.ran = 0; window.pwned = () => { window.ran += 1; };"
UNSAFE = """() => {
  const found = [];
  const parts = [document, ...[...document.querySelectorAll("template")].map((t) => t.content)];
  for (const element of parts.flatMap((part) => [...part.querySelectorAll("*")])) {
    for (const { name, value } of element.attributes) {
      const address = ["href", "src", "action", "data", "srcdoc"].includes(name);
      if (name.startsWith("on") || name === "style" || name === "srcdoc") found.push(name);
      else if (address && /^\\s*(java|vb)script:|^\\s*data:text/i.test(value)) found.push(value);
    }
    const tag = element.tagName;
    if (["IFRAME", "OBJECT", "EMBED", "BASE", "STYLE"].includes(tag)) found.push(tag);
    const own = tag === "SCRIPT" && (element.src.includes("/assets/carts/") || element.type);
    if (tag === "SCRIPT" && !own) found.push(element.outerHTML);
  }
  return found;
}"""


def poisoned(k: int, payload: str) -> dict[str, object]:
    """A question of some kind with the payload in every text that an author writes."""
    refused: list[Problem] = []  # where a page shows only what is typed
    unformatted({"start": payload}, (), refused)
    typed = "b" if refused else payload
    common = {"id": f"q-{k}", "ask": payload, "hints": [payload], "explain": payload}
    kinds: tuple[dict[str, object], ...] = (
        {
            "type": "single",
            "options": [
                {"text": payload, "correct": True, "feedback": payload},
                {"text": f"b {payload}", "feedback": payload},
            ],
        },
        {"type": "short", "accept": [payload], "start": typed, "words": [typed]},
        {"type": "ordering", "order": [f"1 {payload}", f"2 {payload}", f"3 {payload}"]},
        {
            "type": "matching",
            "pairs": [{"left": payload, "right": payload}, {"left": "b", "right": f"b {payload}"}],
        },
        {"type": "long", "rubric": {"0": payload, "1": payload}, "start": typed},
    )
    return {**common, **kinds[k % len(kinds)]}


@pytest.fixture(scope="module")
def poisoned_page(question_site: Path) -> Path:
    """A page without a policy, so that only the generator and the script protect the reader."""
    body = "".join(
        render_question(read_question(poisoned(k, payload)), number=k)
        for k, payload in enumerate(payloads())
    )
    page = PAGE.format(csp="", site_id=SITE_ID, name="poison", body=body, outline="null", scenes="")
    page = page.replace('<meta http-equiv="Content-Security-Policy" content="">\n', "")
    path = question_site / "poison.html"
    path.write_text(page, encoding="utf-8")
    return path


def test_there_are_more_than_200_payloads() -> None:
    assert len(set(payloads())) > 200


@pytest.mark.one_browser
@pytest.mark.browser
def test_nothing_that_an_author_writes_is_run(open_page: OpenPage, poisoned_page: Path) -> None:
    page = open_page(poisoned_page)
    page.add_init_script(LISTEN)
    page.reload()
    ready(page)
    page.evaluate("""() => {
      for (const input of document.querySelectorAll("carts-question :is(input, textarea)")) {
        if (input.type === "radio") input.click();
        else { input.value = "x"; input.dispatchEvent(new Event("input", { bubbles: true })); }
      }
      const press = ".carts-q-check, .carts-q-hint, .carts-q-up, .carts-q-down";
      for (const button of document.querySelectorAll(press)) button.click();
    }""")
    expect(page.locator("#q-0 .carts-q-saved")).to_have_text("Saved")
    assert page.evaluate(UNSAFE) == []
    assert page.evaluate("window.ran") == 0


def give(page: Page, content: object, name: str = "x.json") -> None:
    page.locator(".carts-bar-open").click()
    page.locator(".carts-answers-open").set_input_files(
        {"name": name, "mimeType": "application/json", "buffer": json.dumps(content).encode()}
    )


@pytest.mark.browser
def test_nothing_that_a_student_writes_or_a_file_holds_is_run(
    open_page: OpenPage, poisoned_page: Path
) -> None:
    page = open_page(poisoned_page)
    page.add_init_script(LISTEN)
    page.reload()
    ready(page)
    time = "2026-11-21T08:00:00.000Z"
    items = [
        {"id": f"old-{k}", "hash": "0123456789ab", "type": "long", "value": text, "said": text,
         "asked": text, "unit": text, "sure": text, "first": time, "last": time, "tries": 1}
        for k, text in enumerate(payloads())
    ]  # fmt: skip
    for text in payloads():
        again = {"hash": "ba9876543210", "value": f"{text}!", "said": f"{text}!"}
        items.append({**items[0], **again})
    head = {"format": 1, "kind": "newtons-carts-answers", "site": SITE_ID, "lesson": payloads()[0],
            "lessonHash": "", "student": "", "form": "worksheet", "created": time, "saved": time,
            "page": "worksheets/poison"}  # fmt: skip
    give(page, {**head, "items": items}, "<img src=x onerror=pwned()>.json")
    expect(page.locator(".carts-answers-files [role=status]")).to_contain_text(
        "taken from the file",
        timeout=60_000,  # two answers to each of some 200 questions
    )
    page.keyboard.press("Escape")
    page.locator(".carts-bar-open").click()
    page.locator(".carts-answers-code").fill("<img src=x onerror=pwned()>")
    page.locator(".carts-answers-go").click()
    expect(page.locator(".carts-answers-who")).to_contain_text("letters, digits and hyphens")
    assert page.locator(".carts-answers-said dd").count() > 200
    assert page.evaluate(UNSAFE) == []
    assert page.evaluate("window.ran") == 0
