"""Small sites, built by MkDocs through our plugin: what a teacher meets."""

from __future__ import annotations

import base64
import hashlib
import html
import json
import logging
import re
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.cli.site.build import build_site
from sim.pages.site import files as site_files
from tests.pages.given.small_site import CONFIG, MakeSite, lesson, make_site

__all__ = ["make_site"]  # a fixture


def test_a_lesson_becomes_a_page_with_a_scene(make_site: MakeSite) -> None:
    root = make_site(first=lesson())
    site = build_site(root, hosted=False, strict=True)
    assert site == root / "site"
    page = (site / "worksheets" / "first.html").read_text(encoding="utf-8")
    assert "<carts-scene" in page
    assert '<script src="../assets/carts/carts.js"></script>' in page
    assert '<meta name="carts-site" content="a-site">' in page
    home = (site / "index.html").read_text(encoding="utf-8")
    assert "carts.js" not in home
    assert 'href="worksheets/first.html"' in home


def test_a_picture_beside_a_lesson_comes_along(make_site: MakeSite) -> None:
    root = make_site(first="# A lesson\n\n![A cart](pictures/cart.svg)\n")
    (root / "worksheets" / "pictures").mkdir()
    (root / "worksheets" / "pictures" / "cart.svg").write_text("<svg/>", encoding="utf-8")
    site = build_site(root, hosted=False, strict=True)
    assert site is not None
    assert (site / "worksheets" / "pictures" / "cart.svg").is_file()


def test_a_site_without_scenes_has_no_scene_script(make_site: MakeSite) -> None:
    site = build_site(make_site(first="# A lesson\n\nWords.\n"), hosted=False, strict=True)
    assert site is not None
    assert not (site / "assets" / "carts" / "carts.js").exists()
    assert "Pyodide" not in (site / "third-party-licenses.txt").read_text(encoding="utf-8")


def test_a_fork_gets_edit_links_to_its_lessons(make_site: MakeSite) -> None:
    address = "https://git.example/fork/edit/main/docs/"
    config = CONFIG.replace("font: false", "font: false, features: [content.action.edit]")
    site = build_site(
        make_site(f"{config}edit_uri: {address}\n", first=lesson()), hosted=False, strict=True
    )
    assert site is not None
    page = (site / "worksheets" / "first.html").read_text(encoding="utf-8")
    assert 'href="https://git.example/fork/edit/main/worksheets/first.md"' in page.replace(
        "docs/../", ""
    )


def test_readings_of_a_scene_are_not_in_the_search_index(make_site: MakeSite) -> None:
    site = build_site(make_site(first=lesson()), hosted=False, strict=True)
    assert site is not None
    index = json.loads((site / "search" / "search_index.json").read_text(encoding="utf-8"))
    words = json.dumps(index["docs"])
    assert "galumphing" in words
    assert "Cart A" not in words
    script = (site / "search" / "search_index.js").read_text(encoding="utf-8")
    assert json.loads(script.removeprefix("var __index = ")) == index


def test_the_hosted_build_has_the_hosted_policy_and_no_polyfill(make_site: MakeSite) -> None:
    site = build_site(make_site(first=lesson()), hosted=True, strict=True)
    assert site is not None
    page = (site / "worksheets" / "first.html").read_text(encoding="utf-8")
    assert "connect-src 'self'; worker-src 'self' blob:" in page
    assert "iframe-worker" not in page


def test_a_missing_bundle_is_a_message_and_no_traceback(
    make_site: MakeSite, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    root = make_site(first=lesson())

    def missing() -> bytes:
        raise site_files.MissingFilesError("carts.js is missing. Run “make bundle” first.")

    monkeypatch.setattr(site_files, "scene_script", missing)
    assert build_site(root, hosted=False, strict=True) is None
    assert "make bundle" in capsys.readouterr().err


def test_carts_build_says_what_to_double_click(make_site: MakeSite) -> None:
    root = make_site(first=lesson())
    result = CliRunner().invoke(main, ["build"])
    assert result.exit_code == 0, result.output
    assert str(root / "site" / "index.html") in result.stdout
    assert "MkDocs" not in result.output


def test_carts_build_outside_of_a_site_is_a_usage_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    result = CliRunner().invoke(main, ["build"])
    assert result.exit_code == 2
    assert "mkdocs.yml" in result.output


def test_two_builds_are_the_same_to_the_byte(make_site: MakeSite) -> None:
    root = make_site(first=lesson(), second="# Two\n\nWords.\n")

    def contents() -> dict[str, bytes]:
        site = build_site(root, hosted=False, strict=True)
        assert site is not None
        return {
            p.relative_to(site).as_posix(): p.read_bytes() for p in site.rglob("*") if p.is_file()
        }

    assert contents() == contents()


@pytest.mark.parametrize("key", ["title", "description"])
def test_front_matter_is_text_and_no_html(make_site: MakeSite, key: str) -> None:
    front = f"""---\n{key}: '"></title><script>steal()</script>'\n---\n\n# A lesson\n"""
    site = build_site(make_site(first=front), hosted=False, strict=True)
    assert site is not None
    page = (site / "worksheets" / "first.html").read_text(encoding="utf-8")
    assert "<script>steal" not in page
    assert "&lt;script&gt;steal" in page


def test_a_script_in_a_lesson_is_not_allowed_to_run(
    make_site: MakeSite, caplog: pytest.LogCaptureFixture
) -> None:
    root = make_site(first="# A\n\n<script>steal()</script>\n")
    with caplog.at_level(logging.WARNING):
        site = build_site(root, hosted=False, strict=False)
    assert site is not None
    page = (site / "worksheets" / "first.html").read_text(encoding="utf-8")
    digest = base64.b64encode(hashlib.sha256(b"steal()").digest()).decode()
    assert digest not in page
    assert "worksheets/first.md: the page's policy blocks a script in it: steal()" in caplog.text


def test_a_heading_leaves_its_address_to_the_scene_that_is_called_as_it_is(
    make_site: MakeSite,
) -> None:
    """Questions look for their scene by its id: they would find the heading, and never open."""
    text = f"## The crash\n\n[see it](#the-crash)\n\n{lesson(identity='the-crash')}"
    site = build_site(make_site(first=f"# A lesson\n\n{text}"), hosted=False, strict=True)
    assert site is not None
    page = (site / "worksheets" / "first.html").read_text(encoding="utf-8")
    assert re.findall(r'<([\w-]+)[^>]*\sid="(the-crash\w*)"', page) == [
        ("h2", "the-crash_1"),
        ("carts-scene", "the-crash"),
    ]
    assert 'href="#the-crash_1"' in page  # in the contents


def test_an_id_written_behind_a_heading_may_not_be_a_scenes(
    make_site: MakeSite, caplog: pytest.LogCaptureFixture
) -> None:
    root = make_site(first=f"{lesson(identity='the-crash')}\n## Then {{: #the-crash }}\n")
    assert build_site(root, hosted=False, strict=True) is None
    assert "“the-crash” is also the address of a heading" in caplog.text
    line = lesson(identity="the-crash").split("\n").index("id: the-crash") + 1
    assert f"worksheets/first.md:{line}:1: error: id" in caplog.text


def test_a_block_that_is_called_as_a_part_of_another_is_told_of_that_one(
    make_site: MakeSite, caplog: pytest.LogCaptureFixture
) -> None:
    other = "\n```question\nid: the-crash-title\ntype: idea\nask: Why?\n```\n"
    root = make_site(first=lesson(identity="the-crash") + other)
    assert build_site(root, hosted=False, strict=True) is None
    assert "“the-crash-title” is also what “the-crash” calls a part of its own" in caplog.text


def test_a_page_knows_its_name_wherever_its_folder_goes(make_site: MakeSite) -> None:
    root = make_site(first=lesson())
    site = build_site(root, hosted=False, strict=True)
    assert site is not None
    page = (site / "worksheets" / "first.html").read_text(encoding="utf-8")
    assert '<meta name="carts-page" content="worksheets/first">' in page


@pytest.mark.parametrize("name", ["Stoß #1", "100 %41", "a&b 'c'"])
def test_a_lesson_is_found_by_any_name_that_a_folder_takes(make_site: MakeSite, name: str) -> None:
    """Teacher mode and “Download this lesson” ask for files that are called as the lesson is."""
    root = make_site(**{name: lesson()})
    site = build_site(root, hosted=True, strict=True)
    assert site is not None
    path = site / "worksheets" / f"{name}.html"
    page = path.read_text(encoding="utf-8")
    (address,) = re.findall(r' data-lesson="([^"]*)"', page)
    parts = urlsplit(html.unescape(address))
    assert not parts.fragment
    assert (path.parent / unquote(parts.path)).is_file()
    assert re.fullmatch("[0-9a-f]{10}", parts.query)  # its stamp
    (address,) = re.findall(r' data-shell="([^"]*)"', page)
    parts = urlsplit(html.unescape(address))
    assert unquote(parts.path) == f"../assets/carts/download/worksheets-{name}.txt"
    assert not parts.query
