"""The lesson on the third law, over two days: predictions and answers in one file to hand in."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import continue_as, find, saved, saved_file
from tests.web.question.question_site import ready
from tests.web.scene.given.widget_site import lock

pytestmark = [pytest.mark.browser, pytest.mark.slow]


def test_a_lesson_over_two_days_gives_one_file(
    site: Path, open_page: OpenPage, browser_name: str
) -> None:
    if browser_name == "firefox":
        pytest.skip("the same modules are tested in Firefox on lighter pages")
    lesson = site / "worksheets" / "newtons-third-law.html"
    page = ready(open_page(lesson, folder=site))
    continue_as(page, "BLUE-FOX-27")
    page.get_by_label("Ana: the force on the trailer is larger.").check()
    saved(page, "third-first-idea")
    scene = page.locator("#third-equal")
    for on, key in (("A", "ArrowRight"), ("B", "PageUp")):
        slider = page.locator(f'#third-equal .carts-guess[data-on="{on}"] [type=range]:enabled')
        slider.focus()
        page.keyboard.press(key)
    expect(scene.locator(".carts-relation")).to_contain_text("B by A is larger")
    lock(page, "third-equal")
    expect(scene.locator(".carts-compared")).to_be_visible(timeout=40_000)
    page.context.new_page().goto((site / "index.html").as_uri())
    page.close()

    page = page.context.new_page()  # the next day
    page.goto(lesson.as_uri())
    ready(page)
    expect(page.locator(".carts-bar-who")).to_have_text("BLUE-FOX-27")
    expect(page.get_by_label("Ana: the force on the trailer is larger.")).to_be_checked()
    run = page.locator("#third-light-into-heavy")
    expect(run).to_have_attribute("data-state", "live", timeout=40_000)
    expect(page.locator("#third-read-a input")).to_be_hidden()  # it waits for its run
    run.evaluate("scene => scene.reveal()")
    answer = page.locator("#third-read-a")
    answer.locator("input").fill("-0.26")
    answer.locator(".carts-q-check").click()
    expect(answer.locator(".carts-q-verdict")).to_have_text("Right.")
    name = "third-light-into-heavy"
    find(page, "-2.41", name, "A, while it touches B")
    find(page, "2.41", name, "B, while it touches A")  # the next question is on what was found
    page.locator("#third-why-flies").get_by_label("Same force; four times").check()
    saved(page, "third-why-flies")

    content = saved_file(page)
    items = {item["id"]: item for item in content["items"]}
    assert (content["lesson"], content["student"]) == ("newtons-third-law", "BLUE-FOX-27")
    assert items["third-equal"]["type"] == "arrows"
    assert items["third-equal"]["locked"]
    assert len(items["third-equal"]["hash"]) == 12
    assert items["third-read-a"]["value"] == -0.26
    assert items["third-read-a"]["own"] == pytest.approx(-0.264, abs=1e-6)
    assert items["third-why-flies"]["value"] == "a"
    asked = {"third-first-idea", "third-equal", "third-read-a", "third-why-flies"}
    assert set(items) == {*asked, f"{name}-forces"}
    # One of the four stands in an optional part, which is not counted.
    assert page.locator(".carts-bar-count").inner_text().startswith("3 of ")
