"""Two people do their job by what the documentation says: a new teacher, and an administrator.

The commands are those of docs/teachers/install.md and docs/hosting/index.md, in the wheel's own
environment, without Node.js and without a network; what they give is opened on "another machine":
another folder, a fresh browser.
"""

from __future__ import annotations

import re
import shlex
import shutil
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.hosting.conftest import ROOT, Installed
from tests.web.conftest import OpenPage

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]  # Firefox: test_pack, test_single_file

TEACHER = ROOT / "docs" / "teachers" / "install.md"
HOST = ROOT / "docs" / "hosting" / "index.md"


def commands(guide: Path) -> list[list[str]]:
    """The `carts` lines of a guide, in their order; `cd` is followed."""
    text = guide.read_text(encoding="utf-8")
    blocks = re.findall(r"^ *```sh\n(.*?)^ *```", text, re.M | re.S)
    lines = [line.strip() for block in blocks for line in block.splitlines()]
    kept = [line.split("#")[0].strip() for line in lines if line.startswith(("carts ", "cd "))]
    return [shlex.split(line) for line in kept]


def follow(guide: Path, installed: Installed, folder: Path) -> Path:
    """Run every command of the guide, but the one that waits for edits; the last folder."""
    for program, *arguments in commands(guide):
        if program == "cd":
            folder = folder / arguments[0]
        elif arguments[0] != "serve":
            installed.carts(*arguments, cwd=folder)
    return folder


@pytest.fixture(scope="module")
def taught(installed: Installed, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site of a teacher who followed the guide in an empty folder."""
    return follow(TEACHER, installed, tmp_path_factory.mktemp("teacher"))


@pytest.fixture(scope="module")
def given(taught: Path, installed: Installed) -> Path:
    """The zip that the administrator gets, and finds to be what the teacher built."""
    build = follow(HOST, installed, taught) / "build"
    assert (build / "again.zip").read_bytes() == (build / "site.hosted.zip").read_bytes()
    return build / "site.hosted.zip"


def unpacked(archive: Path, place: Path) -> Path:
    with zipfile.ZipFile(archive) as packed:
        assert max(map(len, packed.namelist())) <= 120
        packed.extractall(place)
    return place


def live(page: Page) -> None:
    scene = page.locator("carts-scene").first
    expect(scene).to_have_attribute("data-state", "live", timeout=60_000)


def test_a_teachers_zip_opens_on_another_machine(
    taught: Path, open_page: OpenPage, tmp_path: Path
) -> None:
    archive = taught / "build" / "site.zip"
    assert archive.stat().st_size <= 13_000_000
    place = unpacked(archive, tmp_path / "Stick #2 50% äöü")
    page = open_page(place / "OPEN ME.html", folder=place)
    page.wait_for_selector("[data-state=ready]")
    page.get_by_role("link", name="Open the lessons").click()
    page.get_by_role("link", name="Two trains meet").first.click()
    live(page)


def test_a_teachers_single_file_is_a_whole_lesson(
    taught: Path, open_page: OpenPage, tmp_path: Path
) -> None:
    place = unpacked(taught / "build" / "lessons.single.zip", tmp_path / "mail")
    lesson = tmp_path / "alone" / "two-trains.html"
    lesson.parent.mkdir()
    shutil.move(place / "two-trains.html", lesson)
    page = open_page(lesson)
    live(page)
    expect(page.get_by_role("button", name="My answers")).to_be_visible()


def test_an_administrators_zip_works_under_a_sub_path(
    given: Path, open_page: OpenPage, tmp_path: Path, site_server: Callable[[Path], str]
) -> None:
    unpacked(given, tmp_path / "web" / "schools" / "physics one")
    address = f"{site_server(tmp_path / 'web')}/schools/physics%20one/"
    page = open_page(address)
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.get_by_role("link", name="Two trains meet").first.click()
    live(page)
    assert asked and all(url.startswith((address, "blob:", "data:")) for url in asked)
