"""What counts as a try: an answer that is another one than that checked before."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Locator, expect

from tests.web.conftest import OpenPage, SharePage
from tests.web.question.answering import find, saved, saved_file
from tests.web.question.question_site import question_site, ready
from tests.web.scene.given.widget_site import MEETING, live, widget_site, write_page

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

__all__ = ["question_site", "widget_site"]  # fixtures

HIDDEN = {**MEETING, "id": "hidden", "forces": "hidden", "show": ["v"]}


def hold_enter(element: Locator) -> None:
    element.focus()
    for _ in range(4):  # down and not up: the key repeats
        element.page.keyboard.down("Enter")
    element.page.keyboard.up("Enter")


def test_a_held_enter_and_the_same_answer_again_are_one_try(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    number, one = page.locator("#how-fast"), page.locator("#pick-one")
    number.locator("input").fill("4.8")
    hold_enter(number.locator("input"))
    hold_enter(number.locator(".carts-q-check"))
    expect(number.locator(".carts-q-feedback")).to_contain_text("You multiplied.")
    page.get_by_label("The one on the van").check()
    for _ in range(3):
        one.locator(".carts-q-check").click()
    expect(one.locator(".carts-q-feedback")).to_contain_text("Not yet. Think again.")
    for question in ("how-fast", "pick-one"):
        saved(page, question)
    items = {item["id"]: item["tries"] for item in saved_file(page)["items"]}
    assert items == {"how-fast": 1, "pick-one": 1}


def test_a_force_that_is_checked_again_is_no_other_try(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(write_page(widget_site, "hidden", HIDDEN)), "hidden")
    assert "Not yet" in find(page, "123")
    hold_enter(page.locator("#hidden .carts-find input"))
    expect(page.locator("#hidden .carts-find-note")).not_to_contain_text("m = 1")
    page.locator("#hidden .carts-find input").fill("0.001")
    page.keyboard.press("Enter")
    assert "m = 1" in find(page, "1234")
