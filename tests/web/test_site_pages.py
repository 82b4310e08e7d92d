"""Every page of the built site in both browsers: no complaint of the policy, search from disk."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage

pytestmark = [pytest.mark.browser, pytest.mark.slow]


def pages(site: Path) -> list[str]:
    """The addresses of all pages, from the site's folder."""
    return sorted(path.relative_to(site).as_posix() for path in site.rglob("*.html"))


def listen(page: Page) -> list[str]:
    """What the page's console and its scripts complain of, from now on."""
    heard: list[str] = []
    page.on("console", lambda m: heard.append(m.text) if m.type in ("error", "warning") else None)
    page.on("pageerror", lambda error: heard.append(str(error)))
    return heard


def settle(page: Page) -> None:
    """Wait until all is loaded and Python runs in every scene, so that all has been heard."""
    expect(page.locator("html.js")).to_be_attached()
    page.wait_for_load_state()
    expect(page.locator("carts-scene:not([data-state=live])")).to_have_count(0, timeout=60_000)


def search(page: Page, word: str) -> None:
    page.locator(".md-search__input").click()
    page.keyboard.type(word)
    expect(page.locator(".md-search-result__item").first).to_be_visible()
    expect(page.locator(".md-search-result__meta")).to_contain_text("matching document")


def test_no_page_breaks_its_policy_from_disk(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "index.html")
    heard = listen(page)
    for name in pages(site):
        page.goto((site / name).as_uri())
        settle(page)
    assert heard == []


@pytest.mark.parametrize("built", ["site", "hosted_site"])
def test_no_page_breaks_its_policy_from_a_server(
    built: str,
    open_page: OpenPage,
    site_server: Callable[[Path], str],
    request: pytest.FixtureRequest,
) -> None:
    folder = request.getfixturevalue(built)
    address = site_server(folder)
    page = open_page(f"{address}/index.html")
    heard = listen(page)
    for name in pages(folder):
        page.goto(f"{address}/{name}")
        settle(page)
    assert heard == []


def test_search_works_from_disk(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "index.html")
    heard = listen(page)
    search(page, "supply pod")
    page.locator(".md-search-result__link").first.click()
    expect(page).to_have_title("Newton's first law - Newton's Carts")
    assert heard == []


def test_search_works_in_a_folder_further_down(site: Path, open_page: OpenPage) -> None:
    search(open_page(site / "physics" / "index.html", folder=site), "momentum")


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


def test_the_palette_switches_and_is_remembered(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "index.html")  # browsers under test prefer light
    body = page.locator("body")
    expect(body).to_have_attribute("data-md-color-scheme", "default")
    page.locator("label[title=Dark]").click()
    expect(body).to_have_attribute("data-md-color-scheme", "slate")
    page.reload()
    expect(body).to_have_attribute("data-md-color-scheme", "slate")


def test_a_page_without_javascript_can_be_read(
    site: Path, open_page: OpenPage, browser_name: str
) -> None:
    if browser_name == "firefox":
        pytest.skip("Firefox cannot be told to run no scripts through this driver")
    page = open_page(site / "physics" / "index.html", folder=site, java_script_enabled=False)
    expect(page.locator("h1")).to_be_visible()
    expect(page.locator(".arithmatex").first).to_contain_text("\\(")


MOST_SHIFT = 0.01  # cumulative layout shift: a tenth of what counts as good

COUNT_SHIFTS = """
  window.shifted = 0;
  new PerformanceObserver((list) => {
    for (const entry of list.getEntries()) window.shifted += entry.value;
  }).observe({ type: "layout-shift", buffered: true });
"""


@pytest.mark.parametrize("width", [1280, 360])
def test_nothing_jumps_while_a_page_is_read_in(
    site: Path, open_page: OpenPage, browser_name: str, width: int
) -> None:
    if browser_name == "firefox":
        pytest.skip("Firefox does not measure layout shifts")
    page = open_page(site / "index.html", viewport={"width": width, "height": 800})
    page.add_init_script(COUNT_SHIFTS)
    for name in pages(site):
        page.goto((site / name).as_uri())
        page.wait_for_load_state()
        page.evaluate("document.fonts.ready")
        page.wait_for_timeout(300)  # what moves late moves within this
        assert page.evaluate("window.shifted") <= MOST_SHIFT, name


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [1280, 360])
def test_every_text_can_be_told_from_what_lies_behind_it(
    site: Path, open_page: OpenPage, browser_name: str, width: int, scheme: str
) -> None:
    if browser_name == "firefox":
        pytest.skip("colours are the same, and Firefox ESR cannot be told to prefer dark")
    page = open_page(
        site / "index.html", viewport={"width": width, "height": 800}, color_scheme=scheme
    )
    pale = (Path(__file__).parent / "contrast.js").read_text(encoding="utf-8")
    for name in pages(site):
        page.goto((site / name).as_uri())
        page.wait_for_load_state()
        assert page.evaluate(pale) == [], name


def test_what_is_printed_from_a_dark_screen_can_be_read(
    site: Path, open_page: OpenPage, browser_name: str
) -> None:
    if browser_name == "firefox":
        pytest.skip("Firefox ESR cannot be told to prefer dark")
    page = open_page(site / "index.html", color_scheme="dark")
    pale = (Path(__file__).parent / "contrast.js").read_text(encoding="utf-8")
    for name in pages(site):
        page.goto((site / name).as_uri())
        page.emulate_media(media="print", color_scheme="dark")
        page.wait_for_timeout(500)  # the theme fades colours of links
        assert page.evaluate(pale) == [], name
