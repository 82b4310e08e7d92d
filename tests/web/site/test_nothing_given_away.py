"""The lesson on the third law tells no result before its run was watched, however one reads it."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import LIVE

pytestmark = [pytest.mark.browser, pytest.mark.slow]

RESULTS = (
    "2.4 N", "2.53 N", "0.264", "0.67 m/s", "0.34 kg", "are at every moment equal",
    "Impulse on each", "it acts on both bodies", "N on each", "four times as much",
)  # fmt: skip
"""Numbers and sentences that a student is to find; none is an option of a prediction."""

DECISIVE = "third-heavy-into-light"

TEXT = """() => {
    const copy = document.body.cloneNode(true);
    for (const one of copy.querySelectorAll("script, style, template, noscript")) one.remove();
    const shown = [...document.querySelectorAll("body *")].filter((one) => one.checkVisibility());
    const attributes = shown.flatMap((one) => [...one.attributes]
        .filter(({ name }) => /^(aria-|title$|alt$|value$|placeholder$)/.test(name))
        .map(({ value }) => value));
    return [document.body.innerText, ...attributes].join("\\n");
}"""

PLACED_FIRST = """() => {
    const after = document.querySelector("carts-after");
    const scene = document.getElementById(after.dataset.after);
    const place = document.createComment("");
    scene.replaceWith(place);
    place.before(after);
    place.replaceWith(scene);
}"""
"""The page made anew, as teacher mode does it: what waits is put there before its scene."""


def found(page: Page) -> list[str]:
    """The results that can be read, heard or printed now."""
    texts = [page.evaluate(TEXT), page.locator("body").aria_snapshot()]
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    texts.append(page.evaluate(TEXT))
    page.emulate_media(media="screen")
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    return [result for result in RESULTS if any(result in text for text in texts)]


@pytest.mark.one_browser
def test_the_third_law_lesson_gives_nothing_away(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "worksheets" / "newtons-third-law.html", folder=site)
    assert found(page) == []
    scene = page.locator(f"#{DECISIVE}")
    expect(scene).to_have_attribute("data-state", "live", timeout=LIVE)
    for slider in scene.locator(".carts-guess input[type=range]").all():
        slider.focus()
        page.keyboard.press("PageUp")
    expect(scene.locator(".carts-relation")).to_contain_text("equally large")
    scene.get_by_label("I think so").check()
    scene.locator(".carts-lock").click()
    scene.locator(".carts-talk-run").click()
    expect(scene.locator(".carts-play")).to_be_enabled(timeout=LIVE)
    expect(scene.locator(".carts-stage .carts-guessed")).to_have_count(0)  # the carts leave them
    scene.evaluate("scene => { scene.time = 0 }")
    assert found(page) == []
    touch, apart = scene.evaluate(
        """scene => ["contact", "separate"].map((kind) =>
            scene.trajectory.events.find((event) => event.kind === kind).t)"""
    )
    scene.evaluate(f"scene => {{ scene.time = {(touch + apart) / 2 - 1e-3} }}")
    assert found(page) == []
    scene.locator(".carts-end").click()
    expect(scene.locator(".carts-compared")).to_contain_text("equally large")
    assert {"2.53 N", "Impulse on each"} <= set(found(page))


@pytest.mark.one_browser
def test_text_below_a_prediction_waits_for_its_run(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "worksheets" / "momentum-and-restitution.html", folder=site)
    text = page.get_by_text("what stays the same only with e = 1")
    line = page.locator("carts-after").get_by_text("This part opens when you have watched")
    expect(page.locator("carts-after")).to_have_count(1)
    expect(line).to_be_visible()
    expect(text).to_be_hidden()
    page.emulate_media(media="print")
    expect(text).to_be_hidden()
    page.emulate_media(media="screen")
    page.evaluate(PLACED_FIRST)
    expect(text).to_be_hidden()
    scene = page.locator("#momentum-bounce")
    expect(scene).to_have_attribute("data-state", "live", timeout=LIVE)
    scene.evaluate("scene => scene.reveal()")
    scene.locator(".carts-end:enabled").click()
    expect(text).to_be_visible()
    expect(line).to_be_hidden()
    index = (site / "search" / "search_index.js").read_text(encoding="utf-8")
    assert "They stay together" in index
    assert "the same only with e = 1" not in " ".join(index.split())
