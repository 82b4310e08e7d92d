"""What stands in a lesson as one file comes out of its site, never from elsewhere on a computer."""

from __future__ import annotations

import base64
import logging
import zipfile
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.cli.site.build import build_site
from sim.pages.single import all_inside, to_download
from tests.pages.given.small_site import CONFIG, MakeSite, lesson, make_site

__all__ = ["make_site"]  # a fixture

SECRET = "Host school\n"
PLAIN = CONFIG.replace("strict: true", "")


@pytest.fixture(autouse=True)
def python_is_there(monkeypatch: pytest.MonkeyPatch) -> None:
    """The files are written as if there were a runtime: it is empty."""
    monkeypatch.setattr(to_download, "runtime_files", lambda *_: {})
    monkeypatch.setattr(all_inside, "runtime_scripts", lambda *_: [])


def with_picture(address: str) -> str:
    return f'{lesson()}\n<img src="{address}" alt="A cart">\n'


def the_shell(root: Path) -> str:
    site = build_site(root, hosted=True, strict=False)
    assert site is not None
    return (site / "assets/carts/download/worksheets-first.txt").read_text(encoding="utf-8")


@pytest.mark.parametrize("where", ["../../secret", "/secret", "../assets/../../secret"])
def test_a_file_of_who_builds_the_site_joins_no_lesson(
    make_site: MakeSite, tmp_path: Path, caplog: pytest.LogCaptureFixture, where: str
) -> None:
    secret = tmp_path / "secret"
    secret.write_text(SECRET, encoding="utf-8")
    where = f"{tmp_path}{where}" if where.startswith("/") else where
    root = make_site(PLAIN, first=with_picture(where))
    with caplog.at_level(logging.WARNING):
        shell = the_shell(root)
    assert base64.b64encode(SECRET.encode()).decode() not in shell
    assert f"worksheets/first.md:1:1: error: “{where}” leads to no file of the site" in caplog.text


def test_nor_does_a_script_or_a_prepared_run_from_elsewhere(
    make_site: MakeSite, tmp_path: Path
) -> None:
    away = tmp_path / "assets" / "carts" / "away.js"
    away.parent.mkdir(parents=True)
    away.write_text(SECRET, encoding="utf-8")
    raw = (
        '<script src="../../assets/carts/away.js"></script>\n\n'
        '<carts-scene data-prepared="{&quot;parts&quot;:[{&quot;src&quot;:'
        '&quot;../../../../assets/carts/away.js&quot;}]}"></carts-scene>\n'
    )
    assert SECRET not in the_shell(make_site(PLAIN, first=f"{lesson()}\n{raw}"))


@pytest.mark.parametrize("address", ["missing.png", "/x.png", "x%00.png", f"{'x' * 300}.png", "#x"])
def test_a_picture_that_is_not_there_is_a_sentence(
    make_site: MakeSite, address: str, caplog: pytest.LogCaptureFixture
) -> None:
    root = make_site(first=with_picture(address))
    said = f"worksheets/first.md:1:1: error: “{address}” leads to no file of the site"
    with caplog.at_level(logging.WARNING):
        assert build_site(root, hosted=True, strict=True) is None
    assert said in caplog.text
    packed = CliRunner().invoke(main, ["pack", "--single"])
    assert packed.exit_code == 1
    assert isinstance(packed.exception, SystemExit), packed.exception
    # The look at the lessons, which comes first, names the line; it passes what is no file's name.
    assert (said if address == "#x" else "first.md:14:1: error: there is no file") in packed.output
    assert not (root / "build").exists()
    assert '<img src="data:," alt="A cart">' in the_shell(root)


def test_what_lies_on_other_servers_is_left_out_or_left_as_it_is(
    make_site: MakeSite, caplog: pytest.LogCaptureFixture
) -> None:
    sheets = "extra_css: [https://far.example/a.css, //far.example/b.css, own.css]\n"
    root = make_site(
        PLAIN.replace("theme: {name: material, font: false}", "theme: {name: material}") + sheets,
        first=with_picture("https://far.example/cart.png"),
    )
    own = '.a {background: url( "https://far.example/a.png" )} .b {background: url(/x.png)}'
    (root / "docs" / "own.css").write_text(own, encoding="utf-8")
    with caplog.at_level(logging.WARNING):
        shell = the_shell(root)
    assert '<img src="https://far.example/cart.png"' in shell
    assert 'url( "https://far.example/a.png" )' in shell
    assert ".b {background: url(data:,)}" in shell
    assert caplog.text.count("own.css:1:1: error: “/x.png” leads to no file of the site") == 1


def test_a_picture_of_the_site_stands_in_the_file(make_site: MakeSite) -> None:
    root = make_site(first=with_picture("pictures/a%20%23%3F.png?new#top"))
    (root / "worksheets" / "pictures").mkdir()
    (root / "worksheets" / "pictures" / "a #?.png").write_bytes(b"a picture")
    coded = base64.b64encode(b"a picture").decode()
    assert f'<img src="data:image/png;base64,{coded}"' in the_shell(root)
    packed = CliRunner().invoke(main, ["pack", "--single"])
    assert packed.exit_code == 0, packed.output
    with zipfile.ZipFile(root / "build" / "lessons.single.zip") as archive:
        assert archive.namelist() == ["first.html"]
