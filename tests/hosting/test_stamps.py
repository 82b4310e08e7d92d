"""On a web server a changed script has another address, so that none is kept beyond its version."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import expect

from sim.pages.offline.stamps import stamp_of, stamp_pages
from tests.web.conftest import OpenPage

OURS = r'(?:src|href|data-lesson)="[^"]*?(assets/carts/[^"]*\.(?:js|css)[^"]*)"'
PAGE = """<link rel="stylesheet" href="{root}assets/carts/carts.css">
<script src="{root}assets/carts/carts.js"></script><script src="{root}assets/x.js"></script>
<a data-lesson="{root}assets/carts/lessons/one.js"></a><script src="assets/carts/gone.js"></script>
"""


def published(folder: Path, **changed: str) -> set[str]:
    """The addresses in the pages of a small site."""
    held = {"carts": "script", "style": "style", "one": "lesson", "index": "runtime"} | changed
    ours = folder / "assets" / "carts"
    for name, text in (
        ("carts.js", held["carts"]), ("carts.css", held["style"]), ("lessons/one.js", held["one"]),
        ("runtime/index.js", held["index"]),
    ):  # fmt: skip
        (ours / name).parent.mkdir(parents=True, exist_ok=True)
        (ours / name).write_text(text, encoding="utf-8")
    (folder / "worksheets").mkdir()
    (folder / "index.html").write_text(PAGE.format(root=""), encoding="utf-8")
    (folder / "worksheets" / "ä.html").write_text(PAGE.format(root="../"), encoding="utf-8")
    stamp_pages(folder)
    first = (folder / "index.html").read_bytes()
    stamp_pages(folder)
    assert (folder / "index.html").read_bytes() == first
    text = "".join(page.read_text(encoding="utf-8") for page in sorted(folder.rglob("*.html")))
    assert text.count('assets/x.js"') == 2, "the theme's own names are its own affair"
    assert text.count('assets/carts/gone.js"') == 2, "what is not there has no stamp"
    return {address for address in re.findall(OURS, text) if "gone" not in address}


@pytest.mark.parametrize(
    ("change", "renewed"),
    [
        ({}, set()),
        ({"style": "another"}, {"carts.css"}),
        ({"one": "another"}, {"lessons/one.js"}),
        ({"carts": "another"}, {"carts.js"}),
        ({"index": "another"}, {"carts.js", "lessons/one.js"}),
    ],
)
def test_an_address_changes_with_what_it_brings_and_with_nothing_else(
    tmp_path: Path, change: dict[str, str], renewed: set[str]
) -> None:
    before = published(tmp_path / "before")
    after = published(tmp_path / "after", **change)
    assert all("?" in address for address in before)
    assert {urlsplit(a).path.removeprefix("assets/carts/") for a in after - before} == renewed


def test_what_reads_films_is_asked_for_by_a_stamp_that_changes_with_it(tmp_path: Path) -> None:
    ours = tmp_path / "assets" / "carts"
    ours.mkdir(parents=True)
    for name in ("measured.js", "carts.js", "film.js"):
        (ours / name).write_text("a script", encoding="utf-8")
    names = ("assets/carts/measured.js", "assets/carts/carts.js")
    before = [stamp_of(tmp_path, name) for name in names]
    (ours / "film.js").write_text("another", encoding="utf-8")
    after = [stamp_of(tmp_path, name) for name in names]
    assert [one == other for one, other in zip(before, after, strict=True)] == [False, True]


def test_every_page_of_a_hosted_site_asks_for_our_files_by_their_stamp(hosted_site: Path) -> None:
    pages = [*hosted_site.rglob("*.html")]
    assert len(pages) > 30
    for page in pages:
        found = re.findall(OURS, page.read_text(encoding="utf-8"))
        assert found or page.name == "404.html"  # that one needs no file: see test_not_found.py
        assert [address for address in found if "?" not in address] == [], page.name


@pytest.mark.browser
@pytest.mark.one_browser
def test_the_runtime_is_asked_for_by_the_stamp_of_its_script(
    hosted_site: Path, open_page: OpenPage, site_server: Callable[[Path], str]
) -> None:
    asked: list[str] = []
    page = open_page(site_server(hosted_site) + "/about.html")
    page.on("request", lambda request: asked.append(request.url))
    page.goto(page.url.replace("about", "index"))
    expect(page.locator("carts-scene").first).to_have_attribute(
        "data-state", "live", timeout=60_000
    )
    stamps = {
        name: urlsplit(url).query for url in asked for name in ("carts.js", "index.js")
        if urlsplit(url).path.endswith(f"/{name}")
    }  # fmt: skip
    assert stamps["carts.js"] == stamps["index.js"] != ""
