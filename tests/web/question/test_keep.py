"""“Keep this on your tablet”: said on pages of a web server, as each browser can do it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import ROOT, bundle

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.one_browser]

IPAD = (
    "Mozilla/5.0 (Macintosh; Intel Mac OS X 10_15_7) AppleWebKit/605.1.15 (KHTML, like Gecko) "
    "Version/17.4 Safari/605.1.15"
)
OFFER = """() => {
  const offer = new Event("beforeinstallprompt", { cancelable: true });
  offer.prompt = async () => { window.asked = true; return { outcome: "accepted" }; };
  dispatchEvent(offer);
}"""


@pytest.mark.parametrize("name", ["index.html", "worksheets/newtons-first-law.html"])
def test_a_browser_that_can_install_is_asked_by_one_button(
    name: str, hosted_site: Path, site_server: Callable[[Path], str], open_page: OpenPage
) -> None:
    page = open_page(f"{site_server(hosted_site)}/{name}")
    assert page.locator(".carts-keep").count() == 0
    page.evaluate(OFFER)
    page.get_by_role("button", name="Keep this on your tablet").click()
    expect(page.locator(".carts-keep")).to_contain_text("Kept.")
    assert page.evaluate("window.asked") is True


def test_an_ipad_is_told_what_to_press(
    hosted_site: Path, site_server: Callable[[Path], str], open_page: OpenPage
) -> None:
    address = f"{site_server(hosted_site)}/index.html"
    page = open_page(address, user_agent=IPAD)
    page.add_init_script("Object.defineProperty(navigator, 'maxTouchPoints', { value: 5 })")
    page.reload()
    expect(page.locator(".carts-keep")).to_contain_text("Add to Home Screen")


def test_a_site_for_double_click_says_nothing_of_it(site: Path) -> None:
    for page in ("index.html", "worksheets/newtons-first-law.html"):
        text = (site / page).read_text(encoding="utf-8")
        assert "carts-hosted" not in text
        assert "hosted.js" not in text


def test_in_a_learning_platforms_frame_nobody_is_told_to_keep_the_platform(
    tmp_path: Path, site_server: Callable[[Path], str], open_page: OpenPage
) -> None:
    bundle(ROOT / "sim" / "web" / "src" / "hosted-main.js", tmp_path / "hosted.js")
    lesson = '<p class="carts-hosted" data-kept></p><script src="hosted.js"></script>'
    (tmp_path / "lesson.html").write_text(f"<!doctype html>{lesson}", encoding="utf-8")
    (tmp_path / "platform.html").write_text(
        '<!doctype html><iframe src="lesson.html"></iframe>', encoding="utf-8"
    )
    address = site_server(tmp_path)
    iphone = IPAD.replace("Macintosh", "iPhone")
    alone = open_page(f"{address}/lesson.html", user_agent=iphone)
    expect(alone.locator(".carts-keep")).to_contain_text("Add to Home Screen")
    framed = open_page(f"{address}/platform.html", user_agent=iphone)
    assert framed.frames[1].locator(".carts-hosted").count() == 1
    assert framed.frames[1].locator(".carts-keep").count() == 0
