"""The pictures in the guides, taken from what they show.

    CARTS_PICTURES=1 python -m pytest tests/hosting/test_pictures.py

takes them anew into docs/assets/howto/; without it the same pages are made and looked at.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from click.testing import CliRunner
from playwright.sync_api import Locator, Page, Playwright, expect

from sim.cli import main
from sim.cli.site.serve import Previewer
from sim.pages import runtime
from sim.pages.offline.open_me import NAME, open_me
from tests.hosting.conftest import ROOT
from tests.web.conftest import launch

HOWTO = ROOT / "docs" / "assets" / "howto"
WINDOWS = "Mozilla/5.0 (Windows NT 10.0; Win64; x64) AppleWebKit/537.36 Chrome/140.0 Safari/537.36"

Take = Callable[[Page | Locator, str], None]


@pytest.fixture(scope="module")
def chromium(driver: Playwright) -> Iterator[Page]:
    browser = launch(driver, "chromium")
    context = browser.new_context(
        viewport={"width": 760, "height": 520}, user_agent=WINDOWS, color_scheme="light"
    )
    yield context.new_page()
    browser.close()


@pytest.fixture
def take(tmp_path: Path) -> Take:
    """Return `take(what, name)`: the picture is where the guides look for it."""

    def taken(what: Page | Locator, name: str) -> None:
        place = HOWTO if os.environ.get("CARTS_PICTURES") else tmp_path
        what.screenshot(path=str(place / name))
        assert (HOWTO / name).is_file()
        guides = "".join(path.read_text("utf-8") for path in ROOT.glob("docs/*/*.md"))
        assert f"assets/howto/{name})" in guides

    return taken


@pytest.mark.browser
def test_the_start_page_inside_a_zip(chromium: Page, take: Take, tmp_path: Path) -> None:
    (tmp_path / NAME).write_text(open_me("My lessons"), encoding="utf-8")
    chromium.goto((tmp_path / NAME).as_uri())
    chromium.wait_for_selector("[data-state=alone]")
    expect(chromium.get_by_text("Extract All…")).to_be_visible()
    take(chromium, "unpack-first.png")


@pytest.mark.browser
def test_a_mistake_in_the_preview(
    chromium: Page, take: Take, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(runtime, "pack", lambda *_, **__: None)
    monkeypatch.chdir(tmp_path)
    assert CliRunner().invoke(main, ["new", "my-lessons"]).exit_code == 0
    lesson = tmp_path / "my-lessons" / "worksheets" / "first-lesson.md"
    text = lesson.read_text(encoding="utf-8").replace("mass: 0.5 kg", "mass: -1 kg", 1)
    lesson.write_text(text, encoding="utf-8")
    preview = Previewer(tmp_path / "my-lessons", tmp_path / "site")
    preview.url = "http://127.0.0.1:8000/"
    preview.make()
    preview.close()
    chromium.goto((tmp_path / "site" / "worksheets" / "first-lesson.html").as_uri())
    box = chromium.locator(".carts-author-error")
    expect(box).to_contain_text("worksheets/first-lesson.md:17:13: error: carts.A.mass")
    box.scroll_into_view_if_needed()
    take(chromium, "mistake.png")
