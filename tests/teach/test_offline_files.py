"""What a hosted build adds: a list of all files with hashes, a manifest, icons, link previews."""

from __future__ import annotations

import hashlib
import json
import re
import struct
import xml.etree.ElementTree as ET
import zlib
from pathlib import Path

import pytest

from sim.pages.offline import Hosting, files, shapes
from sim.pages.offline.links import LONGEST, first_words, with_preview

PAGE = """<html><head><title>Masses - Our school</title>
<meta name="description" content="All lessons."></head><body><article>
<p>Short.</p><p>Two carts of <b>unequal</b> mass &amp; one track: what happens?</p></article></body>
</html>
"""


def site(folder: Path) -> Path:
    for name in (
        "index.html", "a b/é.html", "assets/carts/carts.js", "assets/carts/teacher.js",
        "assets/carts/runtime/python.zip.0.js", "assets/carts/runtime/numpy-2.whl.0.js",
        "assets/carts/runtime/newtons_carts-0.1.0.whl.0.js",
        "assets/carts/runtime/newtons_carts_class-0.1.0.whl.0.js", "sitemap.xml",
    ):  # fmt: skip
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(name, encoding="utf-8")
    return folder


def table(folder: Path) -> dict[str, list[object]]:
    text = (folder / "sw.js").read_text(encoding="utf-8")
    found = re.search(r"const FILES = /\*\* @type \{any\} \*/ \((\{.*\})\);", text)
    assert found
    rows: dict[str, list[object]] = json.loads(found[1])
    return rows


def test_every_file_is_listed_with_its_hash_and_what_few_need_waits(tmp_path: Path) -> None:
    Hosting("Our school").write(site(tmp_path), "our-school")
    rows = table(tmp_path)
    there = {p.relative_to(tmp_path).as_posix() for p in tmp_path.rglob("*") if p.is_file()}
    assert set(rows) == there - {"sw.js", "sitemap.xml"}
    for name, (digest, _) in rows.items():
        assert hashlib.sha256((tmp_path / name).read_bytes()).hexdigest().startswith(str(digest))
    assert {name for name, (_, at_once) in rows.items() if not at_once} == {
        "assets/carts/teacher.js",
        "assets/carts/runtime/numpy-2.whl.0.js",
        "assets/carts/runtime/newtons_carts_class-0.1.0.whl.0.js",
    }


def test_equal_sites_have_equal_workers_and_any_change_is_a_new_version(tmp_path: Path) -> None:
    def version(name: str, change: str = "") -> str:
        folder = site(tmp_path / name)
        if change:
            (folder / "index.html").write_text(change, encoding="utf-8")
        Hosting("Our school").write(folder, "our-school")
        found = re.search(r'VERSION = "(\w+)"', (folder / "sw.js").read_text(encoding="utf-8"))
        assert found
        return found[1]

    assert version("one") == version("two")
    assert version("one") != version("three", "changed")


def test_a_site_that_is_no_longer_kept_is_forgotten(tmp_path: Path) -> None:
    Hosting("Our school", offline=False).write(site(tmp_path), "our-school")
    text = (tmp_path / "sw.js").read_text(encoding="utf-8")
    assert "unregister" in text
    assert "@@" not in text
    assert not (tmp_path / "manifest.webmanifest").exists()
    assert "offline.js" not in Hosting("x", offline=False).head(PAGE, "a.md", "assets/carts/")


def test_the_manifest_has_what_browsers_ask_for_and_no_absolute_address(tmp_path: Path) -> None:
    Hosting("Our school of physics", "Carts.").write(site(tmp_path), "our-school")
    facts = json.loads((tmp_path / "manifest.webmanifest").read_text(encoding="utf-8"))
    assert facts["start_url"] == "./index.html"
    assert facts["display"] == "standalone"
    sizes = set()
    for icon in facts["icons"]:
        data = (tmp_path / icon["src"]).read_bytes()
        assert not icon["src"].startswith(("/", "http"))
        if icon["type"] == "image/png":
            width, height = struct.unpack(">II", data[16:24])
            assert icon["sizes"] == f"{width}x{height}"
            sizes.add(width)
    assert {192, 512} <= sizes


def test_the_sign_as_png_and_as_svg_is_the_same_picture() -> None:
    side = 64
    data = shapes.png(shapes.sign(), side, side)
    at, body = 8, b""
    while at < len(data):
        (size,) = struct.unpack(">I", data[at : at + 4])
        kind, content = data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        assert struct.unpack(">I", data[at + 8 + size : at + 12 + size])[0] == zlib.crc32(
            kind + content
        )
        body += content if kind == b"IDAT" else b""
        at += 12 + size
    raw = zlib.decompress(body)
    assert len(raw) == side * (1 + 3 * side)

    def pixel(x: float, y: float) -> str:
        start = int(y * side) * (1 + 3 * side) + 1 + 3 * int(x * side)
        return "#" + raw[start : start + 3].hex()

    root = ET.fromstring(shapes.svg(shapes.sign()))
    colours = {element.get("fill") for element in root}
    assert pixel(0.02, 0.5) == shapes.hexa(shapes.BLUE)
    assert pixel(0.3, 0.55) == shapes.hexa(shapes.A)
    assert pixel(0.6, 0.5) == shapes.hexa(shapes.B)
    assert {pixel(0.3, 0.55), pixel(0.6, 0.5)} <= colours
    assert shapes.A != shapes.B


def test_a_link_shows_title_words_and_picture() -> None:
    made = Hosting("Our school", "All lessons.", "https://physics.example/p").head(
        PAGE, "worksheets/masses.md", "../assets/carts/"
    )
    facts = dict(re.findall(r'<meta property="og:(\w+)" content="([^"]*)">', made))
    assert facts["title"] == "Masses"
    assert facts["url"] == "https://physics.example/p/worksheets/masses.html"
    assert facts["image"] == "https://physics.example/p/assets/carts/icons/preview.png"
    words = "Two carts of unequal mass &amp; one track: what happens?"
    assert facts["description"] == words
    assert made.count('<meta name="description"') == 1
    assert f'<meta name="description" content="{words}">' in made
    assert '<link rel="manifest" href="../manifest.webmanifest">' in made


def test_a_readme_is_known_by_the_address_of_its_folder() -> None:
    hosting = Hosting("S", site_url="https://physics.example/p", offline=False)
    made = hosting.head(PAGE, "worksheets/README.md", "../assets/carts/")
    assert 'property="og:url" content="https://physics.example/p/worksheets/">' in made


def test_what_a_lesson_says_of_itself_wins_and_cannot_break_out() -> None:
    said = PAGE.replace("All lessons.", "&quot;&gt;&lt;script&gt;alert(1)&lt;/script&gt;")
    made = with_preview(said, site_name="S", about="All lessons.", address="", picture="")
    assert "<script>" not in made
    assert "og:image" not in made
    assert "og:url" not in made


@pytest.mark.parametrize("count", [5, 300])
def test_words_for_a_link_are_short_and_whole(count: int) -> None:
    text = "carts and tracks " * count
    words = first_words(f"<article><p>{text}</p></article>")
    assert len(words) <= LONGEST + 2
    assert words.removesuffix(" …").split()[-1] in ("carts", "and", "tracks")
    assert files.DIGITS >= 24
