"""A prediction is kept with its question, and in the file where nothing else can be."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import saved_file
from tests.web.question.broken_stores import NO_DATABASE, NO_TEXT_STORE, REFUSING, again_with
from tests.web.question.question_site import question_site, ready

__all__ = ["question_site"]  # a fixture

pytestmark = pytest.mark.browser

FORGET = """indexedDB.databases()
  .then((all) => all.map(({ name }) => indexedDB.deleteDatabase(name)))"""

BUMP = """```scene
id: bump
carts:
  A: {mass: 0.5 kg, position: 0.40 m, velocity: 0.60 m/s}
  B: {mass: 1.0 kg, position: 1.20 m}
until: 3 s
predict: {ask: "What does A do?", choice: [It stops, It turns back]}
```

```question
id: bump-drawn
type: drawn
ask: Say it in the scene.
scene: bump
```
"""


@pytest.mark.one_browser
def test_a_prediction_is_kept_with_its_question_and_asked_anew_when_that_changes(
    open_page: OpenPage, question_site: Path
) -> None:
    from tests.web.question.question_site import write_page

    place = write_page(question_site, "bump", BUMP)
    page = ready(open_page(place))
    page.get_by_role("radio", name="It turns back").check()
    page.locator("#bump .carts-lock").click()
    expect(page.locator("#bump-drawn .carts-q-done")).to_have_text("✓ done")
    expect(page.locator(".carts-bar-count")).to_have_text("1 of 1")
    (item,) = saved_file(page)["items"]
    assert (item["id"], item["type"], item["said"]) == ("bump", "choice", "It turns back")
    write_page(question_site, "bump", BUMP.replace("It stops", "It sticks"))
    page.reload()
    ready(page)
    expect(page.get_by_role("radio", name="It turns back")).to_be_enabled()
    expect(page.get_by_role("radio", name="It turns back")).not_to_be_checked()
    expect(page.locator(".carts-bar-count")).to_have_text("0 of 1")
    page.get_by_role("radio", name="It sticks").check()
    expect(page.locator("#bump .carts-saved")).to_have_text("Saved.")
    said = [item["said"] for item in saved_file(page)["items"]]
    assert said == ["It turns back", "It sticks"]


@pytest.mark.one_browser
@pytest.mark.parametrize("script", [NO_DATABASE + NO_TEXT_STORE, REFUSING], ids=["none", "full"])
def test_a_prediction_that_cannot_be_kept_is_in_the_file_all_the_same(
    open_page: OpenPage, question_site: Path, script: str
) -> None:
    from tests.web.question.question_site import write_page

    page = again_with(open_page(write_page(question_site, "bump-full", BUMP)), script)
    page.get_by_role("radio", name="It turns back").check()
    expect(page.locator("#bump .carts-saved")).to_contain_text("keep")
    assert [item["said"] for item in saved_file(page)["items"]] == ["It turns back"]


def two_tabs(open_page: OpenPage, site: Path, name: str, script: str = "") -> tuple[Page, Page]:
    """The page of a prediction twice; `script` runs in the second tab first."""
    from tests.web.question.question_site import write_page

    page = ready(open_page(write_page(site, name, BUMP)))
    other = page.context.new_page()
    if script:
        other.add_init_script(script)
    other.goto(page.url)
    return page, ready(other)


def back(page: Page) -> Locator:
    return page.get_by_role("radio", name="It turns back")


@pytest.mark.one_browser
def test_a_prediction_that_is_locked_in_one_tab_is_locked_in_the_other(
    open_page: OpenPage, question_site: Path
) -> None:
    page, other = two_tabs(open_page, question_site, "two-tabs")
    other.get_by_role("radio", name="It stops").check()
    expect(page.get_by_role("radio", name="It stops")).to_be_checked()
    back(page).check()
    expect(back(other)).to_be_checked()
    page.locator("#bump .carts-lock").click()
    expect(back(other)).to_be_disabled()
    expect(back(other)).to_be_checked()
    expect(other.locator(".carts-bar-count")).to_have_text("1 of 1")


@pytest.mark.one_browser
def test_a_prediction_that_is_forgotten_in_one_tab_is_forgotten_in_the_other(
    open_page: OpenPage, question_site: Path
) -> None:
    page, other = two_tabs(open_page, question_site, "forgotten")
    back(page).check()
    page.locator("#bump .carts-lock").click()
    expect(back(other)).to_be_disabled()
    other.locator("#bump .carts-again").click()
    other.get_by_role("button", name="Forget it").click()
    for tab in (page, other):
        expect(back(tab)).to_be_enabled()
        expect(back(tab)).not_to_be_checked()
        expect(tab.locator(".carts-bar-count")).to_have_text("0 of 1")
        expect(tab.locator("#bump-drawn .carts-q-done")).to_have_text("")
    page.get_by_role("radio", name="It stops").check()
    expect(other.get_by_role("radio", name="It stops")).to_be_checked()
    for tab in (page, other):
        assert [item["said"] for item in saved_file(tab)["items"]] == ["It stops"]


@pytest.mark.one_browser
def test_a_tab_that_hears_nothing_loses_no_locked_prediction(
    open_page: OpenPage, question_site: Path
) -> None:
    deaf = "delete window.BroadcastChannel"
    page, other = two_tabs(open_page, question_site, "deaf-tab", deaf)
    back(page).check()
    page.locator("#bump .carts-lock").click()
    expect(page.locator(".carts-bar-count")).to_have_text("1 of 1")
    other.get_by_role("radio", name="It stops").check()
    expect(other.locator("#bump .carts-saved")).to_have_text("Saved.")
    items = saved_file(other)["items"]
    assert [(item["said"], "locked" in item) for item in items] == [
        ("It stops", False), ("It turns back", True),
    ]  # fmt: skip


@pytest.mark.one_browser
def test_a_prediction_from_a_file_is_as_open_as_it_was(
    open_page: OpenPage, question_site: Path
) -> None:
    from tests.web.question.question_site import write_page

    page = ready(open_page(write_page(question_site, "bump-open", BUMP)))
    back(page).check()
    expect(page.locator("#bump .carts-saved")).to_have_text("Saved.")
    content = json.dumps(saved_file(page)).encode()
    page.evaluate(FORGET)
    page.reload()
    ready(page)
    page.locator(".carts-bar-open").click()
    page.locator(".carts-answers input[type=file]").set_input_files(
        {"name": "a.json", "mimeType": "application/json", "buffer": content}
    )
    expect(back(page)).to_be_checked()
    page.reload()
    ready(page)
    expect(back(page)).to_be_checked()
    expect(back(page)).to_be_enabled()
