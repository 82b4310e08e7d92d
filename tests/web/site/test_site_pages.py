"""The built site in both browsers: search, formulas, palette, policy, without scripts."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage
from tests.web.question.broken_stores import BLOCKED
from tests.web.site.pages_of import listen

pytestmark = [pytest.mark.browser, pytest.mark.slow]


def search(page: Page, word: str) -> None:
    page.locator(".md-search__input").click()
    page.keyboard.type(word)
    expect(page.locator(".md-search-result__item").first).to_be_visible()
    expect(page.locator(".md-search-result__meta")).to_contain_text("matching document")


def test_search_works_from_disk(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "index.html")
    heard = listen(page)
    search(page, "supply pod")
    page.locator(".md-search-result__link").first.click()
    expect(page).to_have_title("Newton's first law - Newton's Carts")
    assert heard == []


@pytest.mark.one_browser
def test_search_works_in_a_folder_further_down(site: Path, open_page: OpenPage) -> None:
    search(open_page(site / "physics" / "index.html", folder=site), "momentum")


@pytest.mark.one_browser
@pytest.mark.parametrize("built", ["site", "hosted_site"])
def test_search_works_from_a_server(
    built: str,
    open_page: OpenPage,
    site_server: Callable[[Path], str],
    request: pytest.FixtureRequest,
) -> None:
    page = open_page(f"{site_server(request.getfixturevalue(built))}/about.html")
    heard = listen(page)
    search(page, "supply pod")
    assert heard == []


def test_the_policy_stops_what_is_not_ours(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "index.html")
    stopped = page.evaluate(
        """async () => {
          const stopped = [];
          addEventListener("securitypolicyviolation", (e) => stopped.push(e.effectiveDirective));
          const script = document.createElement("script");
          script.textContent = "window.pwned = 1";
          document.head.append(script);
          const image = document.createElement("img");
          image.setAttribute("onerror", "window.pwned = 1");
          image.src = "data:,";
          document.body.append(image);
          await fetch("https://example.invalid/").catch(() => {});
          await new Promise((done) => setTimeout(done, 200));
          return { stopped, pwned: "pwned" in window };
        }"""
    )
    assert stopped["pwned"] is False
    assert {"script-src-elem", "script-src-attr", "connect-src"} <= set(stopped["stopped"])


def test_formulas_are_drawn(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "physics" / "index.html", folder=site)
    expect(page.locator(".arithmatex .katex").first).to_be_visible()
    assert page.locator(".arithmatex:not(:has(.katex))").count() == 0
    assert page.locator(".katex-error").count() == 0


DRAWN_BY_THE_PAGE = """(script) => {
    (0, eval)(script);
    const { setAttribute } = Element.prototype;  // the policy allows the style object only
    Element.prototype.setAttribute = function (name, value) {
        if (name === "style") this.style.cssText = value;
        else setAttribute.call(this, name, value);
    };
    const room = ({ width, height }) => [width, height].map((one) => Math.round(10 * one) / 10);
    return [...document.querySelectorAll(".arithmatex")].map((place) => {
        const size = () => room(place.querySelector(".katex-html").getBoundingClientRect());
        const tex = place.querySelector("annotation").textContent;
        const built = size();
        place.textContent = "";
        katex.render(tex, place, { displayMode: place.localName === "div" });
        return { tex, built, drawn: size() };
    });
}"""


@pytest.mark.one_browser
def test_a_formula_of_the_build_is_as_large_as_one_that_katex_draws_in_the_page(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "physics" / "index.html", folder=site)
    script = (site / "assets" / "carts" / "katex" / "katex.min.js").read_text(encoding="utf-8")
    page.evaluate("() => document.fonts.ready.then(() => null)")
    found = page.evaluate(f"({DRAWN_BY_THE_PAGE})({json.dumps(script)})")
    assert len(found) > 10
    assert [one for one in found if one["built"] != one["drawn"]] == []


@pytest.mark.one_browser
def test_the_palette_switches_and_is_remembered(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "index.html")  # browsers under test prefer light
    body = page.locator("body")
    expect(body).to_have_attribute("data-md-color-scheme", "default")
    page.locator("label[title=Dark]").click()
    expect(body).to_have_attribute("data-md-color-scheme", "slate")
    page.reload()
    expect(body).to_have_attribute("data-md-color-scheme", "slate")


@pytest.mark.one_browser
def test_where_all_cookies_are_blocked_the_theme_goes_on(site: Path, open_page: OpenPage) -> None:
    """Search and colours ended there with the theme's first question to the store of texts."""
    page = open_page(site / "about.html")
    page.add_init_script(BLOCKED)
    heard = listen(page)
    page.reload()
    page.locator("label[title=Dark]").click()
    expect(page.locator("body")).to_have_attribute("data-md-color-scheme", "slate")
    search(page, "supply pod")
    assert heard == []


def test_a_page_without_javascript_can_be_read(
    site: Path, open_page: OpenPage, browser_name: str
) -> None:
    if browser_name == "firefox":
        pytest.skip("Firefox cannot be told to run no scripts through this driver")
    page = open_page(site / "physics" / "index.html", folder=site, java_script_enabled=False)
    expect(page.locator("h1")).to_be_visible()
    expect(page.locator(".arithmatex .katex-html").first).to_be_visible()


@pytest.mark.one_browser
def test_bars_of_momentum_stand_in_their_table(site: Path, open_page: OpenPage) -> None:
    """All style sheets together: a rule for the bar of answers once took them out of it."""
    page = open_page(site / "sandbox.html")
    scene = page.locator("carts-scene").first
    expect(scene).to_have_attribute("data-state", "live", timeout=60_000)
    scene.locator("summary", has_text="Choose what to see").click()
    scene.get_by_label("momentum before and now").check()
    table = scene.locator("table", has=page.locator(".carts-bars"))
    bar = table.locator('tbody [data-part="before"]').first
    expect(bar).to_be_visible()
    inner, outer = bar.bounding_box(), table.bounding_box()
    assert inner and outer and inner["width"] > 10
    assert outer["x"] <= inner["x"] <= outer["x"] + outer["width"]
    assert outer["y"] <= inner["y"] <= outer["y"] + outer["height"]


@pytest.mark.one_browser
@pytest.mark.parametrize("language", ["", "ms", "ta", "zh-Hans"])
def test_a_table_that_a_question_is_about_is_seen_whole_on_a_phone(
    language: str, site: Path, open_page: OpenPage
) -> None:
    """All style sheets together: the theme's wide cells once hid four of its six columns."""
    lesson = site / "worksheets" / language / "test-forces-and-motion.html"
    page = open_page(lesson, folder=site, viewport={"width": 360, "height": 740})
    asked = page.locator(".carts-q-ask:has(table)").first
    expect(asked).to_be_visible()
    question, inside = asked.bounding_box(), asked.locator("table").bounding_box()
    assert question and inside and inside["width"] > 200
    assert inside["x"] >= question["x"]
    assert inside["x"] + inside["width"] <= question["x"] + question["width"]


@pytest.fixture(scope="module")
def searched(site: Path, open_for_all: OpenPage) -> Page:
    """A page in which one word is looked for after another: the index is read once."""
    return open_for_all(site / "about.html")


@pytest.mark.one_browser
@pytest.mark.parametrize("word", ["homework", "Excel", "print", "answers"])
def test_a_teachers_word_finds_a_page_for_teachers(word: str, searched: Page) -> None:
    """Among the first results."""
    field = searched.locator(".md-search__input")
    field.fill("")
    expect(searched.locator(".md-search-result__item")).to_have_count(0)
    search(searched, word)
    links = searched.locator(".md-search-result__link")
    first = [links.nth(k).get_attribute("href") or "" for k in range(min(3, links.count()))]
    assert any("teachers/" in href for href in first), first
