"""The zip: what lies in it, how long its paths are, and the page that is to be opened."""

from __future__ import annotations

import zipfile
from pathlib import Path

import click
import pytest

from sim.cli.site.pack import pack_site
from sim.cli.site.site_folder import read
from sim.cli.site.zip_file import LONGEST, write_zip
from sim.pages.offline.open_me import _WORDS, NAME, open_me
from tests.hosting.conftest import CACHE, ROOT
from tests.web.conftest import OpenPage

PICTURE = ROOT / "docs" / "assets" / "page.png"


def test_a_path_too_long_for_windows_is_named(tmp_path: Path) -> None:
    fits, long = "a" * LONGEST, "worksheets/" + "ü" * LONGEST
    write_zip({fits: b""}, tmp_path / "fits.zip")
    with pytest.raises(click.ClickException) as refused:
        write_zip({fits: b"", long: b""}, tmp_path / "long.zip")
    assert long in refused.value.message and "shorter name" in refused.value.message
    assert not (tmp_path / "long.zip").exists()


def test_no_path_of_this_projects_own_site_is_too_long(tmp_path: Path) -> None:
    from sim.pages import runtime

    packages = frozenset({"numpy", "scipy", runtime.CLASSROOM})
    facts = runtime.pack(tmp_path, packages=packages, cache=CACHE, report=lambda _: None)
    longest = max(len(f"assets/carts/runtime/{name}") for name in facts.files)
    assert longest <= LONGEST


def test_a_zip_that_cannot_be_written_is_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(click.ClickException, match=r"cannot be written: .*--out FILE\.zip"):
        write_zip({"a": b""}, tmp_path / "file" / "site.zip")


def test_equal_sites_give_equal_zips(tmp_path: Path) -> None:
    for folder in ("one", "two"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "ü.html").write_text("x", encoding="utf-8")
        pack_site(tmp_path / folder, tmp_path / f"{folder}.zip", scorm=None)
    assert (tmp_path / "one.zip").read_bytes() == (tmp_path / "two.zip").read_bytes()
    with zipfile.ZipFile(tmp_path / "one.zip") as archive:
        assert archive.namelist() == ["ü.html"]


def test_what_pages_ask_for_is_unpacked_before_them_and_the_list_of_all_files_last(
    tmp_path: Path,
) -> None:
    """Over an older site: a new page never meets an old script, nor the list what is not there."""
    for name in ("sw.js", "index.html", "404.html", "worksheets/first.html", "assets/carts.js"):
        path = tmp_path / "site" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("x", encoding="utf-8")
    (tmp_path / "site" / "worksheets" / "picture.png").write_bytes(b"x")
    pack_site(tmp_path / "site", tmp_path / "site.zip", scorm=None)
    with zipfile.ZipFile(tmp_path / "site.zip") as archive:
        names = archive.namelist()
    assert names[:2] == ["assets/carts.js", "worksheets/picture.png"]
    assert names[2:] == ["404.html", "index.html", "worksheets/first.html", "sw.js"]


@pytest.mark.browser
def test_the_start_page_knows_whether_it_is_alone(open_page: OpenPage, tmp_path: Path) -> None:
    alone, folder = tmp_path / "Temp1_site.zip", tmp_path / "unpacked"
    for place in (alone, folder):
        place.mkdir()
        (place / NAME).write_text(open_me("Carts & <springs>"), encoding="utf-8")
    (folder / "assets" / "images").mkdir(parents=True)
    (folder / "assets" / "images" / "favicon.png").write_bytes(PICTURE.read_bytes())
    page = open_page(alone / NAME)
    page.wait_for_selector("[data-state=alone]")
    assert page.get_by_role("heading", name="Unpack first").is_visible()
    assert not page.get_by_role("link", name="Open the lessons").is_visible()
    assert page.locator("section:visible").count() == 1  # the steps of one kind of computer
    page = open_page(folder / NAME)
    page.wait_for_selector("[data-state=ready]")
    link = page.get_by_role("link", name="Open the lessons")
    assert link.is_visible() and link.get_attribute("href") == "index.html"
    assert page.title() == "Carts & <springs>"
    assert not page.locator("#still-zip").is_visible()


def test_the_start_page_is_in_the_language_of_its_site(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "mkdocs.yml").write_text(
        "site_name: Kereta\ntheme: {name: material, language: ms}\n", encoding="utf-8"
    )
    site = read(tmp_path)
    assert site.language == "ms"
    said = {text: f"¿{number}?" for number, text in enumerate(_WORDS.values())}
    monkeypatch.setattr("sim.pages.offline.open_me.words", {"ms": said}.get)
    text = open_me(site.title, site.language)
    assert '<html lang="ms">' in text
    assert [ours for ours in said.values() if ours not in text] == []
    assert "Open the lessons" not in text and "Unpack" not in text


@pytest.mark.browser
def test_the_start_page_says_what_an_old_browser_lacks(open_page: OpenPage, tmp_path: Path) -> None:
    text = open_me("Carts")
    (tmp_path / "assets" / "images").mkdir(parents=True)
    (tmp_path / "assets" / "images" / "favicon.png").write_bytes(PICTURE.read_bytes())
    strict = text.replace("worker-src blob:", "worker-src &#x27;none&#x27;", 1)
    assert strict != text
    (tmp_path / NAME).write_text(strict, encoding="utf-8")
    page = open_page(tmp_path / NAME)
    page.wait_for_selector("[data-state=old]")
    assert "Firefox 113" in page.locator("#old").inner_text()
    assert page.get_by_role("link", name="Open the lessons").is_visible()  # texts are there
