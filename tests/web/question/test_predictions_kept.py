"""A prediction is kept with its question, and in the file where nothing else can be."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import saved_file
from tests.web.question.broken_stores import NO_DATABASE, NO_TEXT_STORE, REFUSING, again_with
from tests.web.question.question_site import question_site, ready

__all__ = ["question_site"]  # a fixture

pytestmark = pytest.mark.browser


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
