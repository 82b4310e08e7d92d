"""An author's mistake stops the build with its place; a preview shows it on the page."""

from __future__ import annotations

import logging
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.cli.site.build import build_site
from sim.pages.blocks import makers
from tests.pages.given.small_site import CONFIG, MakeSite, lesson, make_site

__all__ = ["make_site"]  # a fixture


def test_a_mistake_stops_carts_build_with_its_place(make_site: MakeSite) -> None:
    make_site(first=lesson(mass="-1 kg"))
    result = CliRunner().invoke(main, ["build"])
    assert result.exit_code == 1
    assert "worksheets/first.md:10:13: error: carts.A.mass" in result.stdout
    assert "hint: " in result.stdout
    assert not Path("site/index.html").exists()


def test_a_mistake_stops_plain_mkdocs_too(
    make_site: MakeSite, caplog: pytest.LogCaptureFixture
) -> None:
    with caplog.at_level(logging.WARNING):
        assert build_site(make_site(first=lesson(mass="-1 kg")), hosted=False, strict=True) is None
    assert "worksheets/first.md:10:13: error: carts.A.mass" in caplog.text


def test_a_build_that_is_not_strict_shows_a_red_box(make_site: MakeSite) -> None:
    root = make_site(first=lesson(mass="-1 kg"), second=lesson(identity="two"))
    site = build_site(root, hosted=False, strict=False)
    assert site is not None
    page = (site / "worksheets" / "first.html").read_text(encoding="utf-8")
    assert "carts-author-error" in page
    assert "worksheets/first.md:10:13: error" in page
    assert "<carts-scene" in (site / "worksheets" / "second.html").read_text(encoding="utf-8")


def test_a_preview_shows_the_red_box_although_the_site_is_strict(make_site: MakeSite) -> None:
    from mkdocs.commands.build import build
    from mkdocs.config import load_config

    root = make_site(first=lesson(mass="-1 kg"))
    config = load_config(str(root / "mkdocs.yml"))
    config.plugins.on_startup(command="serve", dirty=False)
    build(config, serve_url="http://127.0.0.1:8000/")
    page = (root / "site" / "worksheets" / "first.html").read_text(encoding="utf-8")
    assert "carts-author-error" in page
    assert "'unsafe-inline'" in page  # for the script that MkDocs adds when it serves
    assert str(root / "worksheets") in config.watch


def test_a_crash_of_ours_stops_the_build(
    make_site: MakeSite, monkeypatch: pytest.MonkeyPatch
) -> None:
    def crash(*_: object) -> None:
        raise ZeroDivisionError("our own mistake")

    monkeypatch.setattr(makers, "bake", crash)
    with pytest.raises(ZeroDivisionError):
        build_site(make_site(first=lesson()), hosted=False, strict=False)


def test_the_same_id_twice_in_a_site_is_a_mistake(
    make_site: MakeSite, caplog: pytest.LogCaptureFixture
) -> None:
    root = make_site(a=lesson(), b=lesson())
    with caplog.at_level(logging.WARNING):
        assert build_site(root, hosted=False, strict=True) is None
    assert (
        "worksheets/b.md:8:5: error: id: “one” is already used at worksheets/a.md:8" in caplog.text
    )


@pytest.mark.parametrize("extra", ["{}", "{carts: {}}", "{carts: {site_id: 'Not Allowed'}}"])
def test_a_site_without_a_name_is_not_built(
    make_site: MakeSite, extra: str, capsys: pytest.CaptureFixture[str]
) -> None:
    config = CONFIG.replace("{carts: {site_id: a-site}}", extra)
    assert build_site(make_site(config), hosted=False, strict=True) is None
    assert "extra.carts.site_id" in capsys.readouterr().err


def test_a_site_without_our_plugin_is_not_built(
    make_site: MakeSite, capsys: pytest.CaptureFixture[str]
) -> None:
    root = make_site(CONFIG.replace("[search, carts]", "[search]"))
    assert build_site(root, hosted=False, strict=True) is None
    assert "the plugin “carts” is not listed" in capsys.readouterr().err


def test_what_the_policy_blocks_is_a_mistake(
    make_site: MakeSite, caplog: pytest.LogCaptureFixture
) -> None:
    root = make_site(first='# A\n\n<img src="x.png" alt="" onerror="steal()">\n')
    with caplog.at_level(logging.WARNING):
        assert build_site(root, hosted=False, strict=True) is None
    assert "worksheets/first.md: the page's policy blocks onerror= on <img>" in caplog.text
