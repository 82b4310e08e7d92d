"""The lesson on the third law, over two days: predictions and answers in one file to hand in."""

from __future__ import annotations

import re
import threading
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage
from tests.web.held_back import holding_back
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
    run.locator(".carts-end:enabled").click()
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


@pytest.mark.one_browser
def test_under_a_code_word_a_second_prediction_says_that_the_run_was_seen(
    site: Path, open_page: OpenPage
) -> None:
    lesson = site / "worksheets" / "momentum-and-restitution.html"
    page = ready(open_page(lesson, folder=site))
    scene = page.locator("#momentum-stays")

    def predicted() -> dict[str, Any]:
        scene.locator(".carts-predict [type=radio]").first.check()
        scene.locator(".carts-lock").click()
        expect(scene.locator(".carts-results")).to_be_visible(timeout=40_000)
        expect(scene.locator(".carts-saved")).to_have_text("Saved.")
        (made,) = saved_file(page)["items"]
        scene.locator(".carts-again").click()
        scene.locator(".carts-forget-yes").click()
        expect(scene.locator(".carts-results")).to_be_hidden()
        return dict(made)

    continue_as(page, "FOX-12")
    first = predicted()
    assert "again" not in first
    assert predicted()["again"] == first["locked"]
    page.reload()  # it is the browser that knows
    ready(page)
    assert predicted()["again"] == first["locked"]
    continue_as(page, "OWL-34", "Yes, somebody else: begin anew")
    assert "again" not in predicted()


@pytest.mark.one_browser
def test_a_page_whose_scripts_come_slowly_shows_no_prediction_of_another_question(
    site: Path, open_page: OpenPage
) -> None:
    """A server answers files one by one: the store is read before the page is."""
    lesson = site / "worksheets" / "momentum-and-restitution.html"
    with holding_back(site, "/tour.js") as (address, go_on):
        go_on.set()
        _with_slow_scripts(open_page(f"{address}/worksheets/{lesson.name}"), lesson, go_on)


def _with_slow_scripts(page: Page, lesson: Path, go_on: threading.Event) -> None:
    ready(page)
    choice = page.locator("#momentum-stays .carts-predict [type=radio]").first
    choice.check()
    page.locator("#momentum-stays .carts-lock").click()
    expect(page.locator("#momentum-stays .carts-saved")).to_have_text("Saved.")
    text = lesson.read_text(encoding="utf-8")
    changed = re.sub(r'("momentum-stays","hash":")\w{12}', r"\g<1>000000000000", text)
    assert changed != text  # as the page will be when the teacher has changed the question

    as_html = {"body": changed, "content_type": "text/html; charset=utf-8"}
    page.route(f"**/{lesson.name}", lambda route: route.fulfill(**as_html))
    go_on.clear()
    threading.Timer(2.0, go_on.set).start()
    page.reload()
    ready(page)
    expect(choice).to_be_enabled()
    expect(choice).not_to_be_checked()
