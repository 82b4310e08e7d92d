"""An interaction diagram: drawn by pointer or keys, or listed; marked link by link."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page, expect

from sim.pages.findings import AuthorError
from sim.pages.question.diagram import BOX, PLACES, diagram
from tests.web.conftest import OpenPage
from tests.web.question.answering import saved, saved_file
from tests.web.question.question_site import question_site, questions_page, ready, write_page

__all__ = ["question_site"]  # a fixture

ODD = "<b>Earth</b>"  # text, never markup
DIAGRAM = f"""
```question
id: book
type: interactions
ask: Draw.
objects: [book, table, "{ODD}"]
contact: [[book, table], [table, "{ODD}"]]
distance: [[book, "{ODD}"]]
focus: book
missing:
  - {{between: [book, "{ODD}"], feedback: "Why does it fall, if you let go?"}}
wrong:
  - between: [book, "{ODD}"]
    by: contact
    belief: weight-is-passed-on
    feedback: Do they touch?
```
"""
TOUCH = 44  # px, the least size of what is touched


def node(page: Page, name: str) -> Locator:
    return page.locator("#book .carts-q-node", has_text=name)


def drag(page: Page, one: str, other: str) -> None:
    for k, name in enumerate((one, other)):
        box = node(page, name).bounding_box()
        assert box
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2, steps=3)
        if k == 0:
            page.mouse.down()
    page.mouse.up()


def add(page: Page, one: str, how: str, other: str) -> None:
    page.get_by_label("First object").select_option(one)
    page.get_by_label("How", exact=True).select_option(how)
    page.get_by_label("Second object").select_option(other)
    page.locator("#book .carts-q-add button").click()


@pytest.mark.one_browser
@pytest.mark.browser
def test_a_diagram_is_drawn_marked_and_comes_back(open_page: OpenPage, question_site: Path) -> None:
    page = ready(open_page(write_page(question_site, "book", DIAGRAM)))
    lines, rows = (
        page.locator("#book .carts-q-drawn path"),
        page.locator("#book .carts-q-linked li"),
    )
    drag(page, "table", "book")  # a pointer, backwards
    expect(rows.locator(".carts-q-pair-forces")).to_have_text(
        ["force on book by table · force on table by book"]
    )
    expect(page.locator("#book .carts-q-focus li")).to_have_text(["force on book by table"])
    heard = page.locator("#book .carts-q-picked")
    expect(heard).to_have_text("Added: book and table touch")
    node(page, "table").focus()  # keys: the arrow goes to the next box
    page.keyboard.press("Enter")
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Enter")
    expect(lines).to_have_count(2)
    add(page, "book", "contact", ODD)  # the list
    expect(lines).to_have_count(3)
    saved(page, "book")
    page.locator("#book .carts-q-check").click()
    expect(page.locator("#book .carts-q-feedback")).to_contain_text("Do they touch?")
    expect(page.locator("#book .carts-q-feedback")).to_contain_text("if you let go?")
    expect(rows.locator(".carts-q-cell-mark")).to_have_text(["✓ right", "✗ not yet", "✓ right"])
    drag(page, "book", ODD)  # the way is still “touch”: the same line again takes it away
    expect(lines).to_have_count(2)
    expect(heard).to_have_text(f"Removed: book and {ODD} touch")
    page.locator("#book .carts-q-check").click()
    expect(page.locator("#book .carts-q-verdict")).to_contain_text("Partly right")
    page.locator("#book .carts-q-ways").get_by_label("without touching").check()
    node(page, "book").click()
    expect(page.locator("#book .carts-q-picked")).to_contain_text("book and …")
    node(page, ODD).click()
    page.locator("#book .carts-q-check").click()
    expect(page.locator("#book .carts-q-verdict")).to_have_text("Right.")
    saved(page, "book")
    (item,) = saved_file(page)["items"]
    assert item["value"] == [
        {"between": ["book", "table"], "by": "contact"},
        {"between": ["book", ODD], "by": "distance"},
        {"between": ["table", ODD], "by": "contact"},
    ]
    page.reload()
    ready(page)
    expect(lines).to_have_count(3)
    page.get_by_role("button", name=f"Remove: book and {ODD}").click()
    expect(lines).to_have_count(2)
    expect(page.locator("#book b")).to_have_count(0)


@pytest.mark.browser
@pytest.mark.one_browser
def test_what_is_touched_is_large_enough_on_a_phone(
    open_page: OpenPage, question_site: Path
) -> None:
    path = write_page(question_site, "small", DIAGRAM)
    page = ready(open_page(path, viewport={"width": 360, "height": 740}))
    add(page, "book", "distance", ODD)
    touched = "#book :is(.carts-q-node, .carts-q-add select, .carts-q-links button)"
    for one in page.locator(touched).all():
        box = one.bounding_box()
        assert box
        assert min(box["width"], box["height"]) >= TOUCH, one.inner_text()
    assert page.evaluate("document.documentElement.scrollWidth") <= 360


@pytest.mark.browser
@pytest.mark.one_browser
def test_without_a_script_and_on_paper_the_boxes_are_left_to_join(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(write_page(question_site, "paper", DIAGRAM)))
    add(page, "book", "contact", "table")
    page.evaluate("document.documentElement.classList.add('carts-print-empty')")
    page.emulate_media(media="print")
    expect(page.locator("#book .carts-q-node")).to_have_count(3)
    for hidden in (".carts-q-drawn", ".carts-q-add", ".carts-q-linked", ".carts-q-focus li"):
        expect(page.locator(f"#book {hidden}")).to_be_hidden()
    made = questions_page("still", DIAGRAM)[0]
    assert made.count('class="carts-q-node"') == 3
    assert "Join the objects that push or pull each other" in made


@pytest.mark.parametrize("count", PLACES)
def test_boxes_of_the_longest_names_stand_apart_and_inside(count: int) -> None:
    made = diagram(["x" * 14] * count)
    for k, one in enumerate(made.boxes):
        assert one.width / 2 <= one.x <= 320 - one.width / 2
        assert BOX / 2 <= one.y <= made.height - BOX / 2
        for other in made.boxes[:k]:
            beside = abs(one.x - other.x) >= (one.width + other.width) / 2
            assert beside or abs(one.y - other.y) > BOX


def test_a_box_is_as_wide_as_its_name_in_chinese() -> None:
    """Five characters of 14 px stood out of the box of five letters."""
    upper, lower = diagram(["上面的磁铁", "书"]).boxes
    assert upper.width >= 5 * 14 + 2 * 6
    assert lower.width == diagram(["book", "red"]).boxes[1].width


@pytest.mark.parametrize(
    ("wrong", "code"),
    [
        (DIAGRAM.replace("objects: [book, table,", "objects: [book, book,"), "not-a-list"),
        (DIAGRAM.replace("[book, table,", "[book, much too long one,"), "not-a-list"),
        (DIAGRAM.replace("[[book, table], ", "[[book, book], "), "not-a-choice"),
        (DIAGRAM.replace("[[book, table], ", "[[book, table], [table, book], "), "twice"),
        (DIAGRAM.replace("focus: book", "focus: pencil"), "not-a-choice"),
        (DIAGRAM.replace("by: contact", "by: distance"), "not-a-choice"),
        (DIAGRAM.replace("weight-is-passed-on", "weight-passes"), "unknown-belief"),
        (DIAGRAM.replace("by: contact", "by: glue"), "not-a-choice"),
        (DIAGRAM.replace("contact: [[", "contacts: [["), "unknown-key"),
    ],
)  # fmt: skip
def test_a_diagram_that_makes_no_sense_is_refused(wrong: str, code: str) -> None:
    with pytest.raises(AuthorError) as refused:
        questions_page("lesson", wrong)
    assert code in {finding.code for finding in refused.value.findings}
