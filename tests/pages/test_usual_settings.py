"""Markdown and look are those of lessons in every site, with a folder docs/ of its own or not."""

from __future__ import annotations

import logging
from pathlib import Path

import pytest
from click.testing import CliRunner
from mkdocs.config import load_config
from mkdocs.config.defaults import MkDocsConfig

from sim.cli import main
from sim.pages.site import usual_settings
from tests.pages.given.small_site import CONFIG, MakeSite, make_site

__all__ = ["make_site"]  # a fixture

LESSON = """\
---
title: Forces
---

# 1 · Part {: data-minutes=10 }

\\(a = F/m\\)

!!! note

    Said beside it.

```scene
id: one
carts:
  A: {mass: 1 kg, position: 0.4 m, velocity: 0.5 m/s}
until: 2 s
```

!!! after

    Held back.
"""


def test_a_new_site_with_docs_of_its_own_keeps_the_markdown_of_lessons(
    make_site: MakeSite, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = make_site()
    assert CliRunner().invoke(main, ["new", "mine", "--site"]).exit_code == 0
    site = root / "mine"
    monkeypatch.chdir(site)
    (site / "node_modules").symlink_to(root / "node_modules")
    settings = site / "mkdocs.yml"
    without = settings.read_text(encoding="utf-8").replace("docs_dir: worksheets\n", "")
    settings.write_text(without, encoding="utf-8")
    (site / "docs").mkdir()
    (site / "docs" / "index.md").write_text("# My own home\n", encoding="utf-8")
    (site / "worksheets" / "first-lesson.md").write_text(LESSON, encoding="utf-8")
    built = CliRunner().invoke(main, ["build"])
    assert built.exit_code == 0, built.output
    home = (site / "site" / "index.html").read_text(encoding="utf-8")
    page = (site / "site" / "worksheets" / "first-lesson.html").read_text(encoding="utf-8")
    assert "My own home" in home and "first-lesson.html#" not in home
    assert 'data-minutes="10"' in page and "{:" not in page
    assert 'class="arithmatex"' in page
    assert 'class="admonition note"' in page and "!!!" not in page
    assert "fonts.googleapis.com" not in page + home
    assert "Made with" not in page  # credits stand elsewhere
    assert 'class="md-tabs"' in page and "__palette_1" in page


def settings_of(root: Path, *, links: bool = True) -> MkDocsConfig:
    config = load_config(str(root / "mkdocs.yml"))
    usual_settings.fill_in(config, links=links)
    return config


def test_what_stands_in_the_settings_wins(make_site: MakeSite) -> None:
    said = """
theme: {name: material, font: {text: Roboto, code: Roboto Mono},
        features: [], palette: {primary: red}}
markdown_extensions: [tables: {use_align_attribute: false}, toc: {permalink: "#"}]
validation: {anchors: info, links: {absolute_links: ignore}}
"""
    config = settings_of(make_site(CONFIG.replace("theme: {name: material, font: false}", said)))
    assert config.theme["font"] == {"text": "Roboto", "code": "Roboto Mono"}
    assert config.theme["features"] == [] and config.theme["palette"] == {"primary": "red"}
    assert config.mdx_configs["tables"] == {"use_align_attribute": False}
    assert config.mdx_configs["toc"] == {"permalink": "#", "permalink_title": ""}
    links, nav = config.validation.links, config.validation.nav
    assert links.anchors == logging.INFO and links.absolute_links < logging.INFO
    assert links.unrecognized_links == nav.absolute_links == logging.WARNING


def test_pages_of_ones_own_do_not_fail_for_links_that_they_had_before(make_site: MakeSite) -> None:
    root = make_site(CONFIG)
    before = load_config(str(root / "mkdocs.yml"))
    assert settings_of(root, links=False).validation == before.validation


@pytest.mark.parametrize("name", ["markdown.extensions.footnotes", "extra", "pymdownx.extra"])
def test_an_extension_that_is_there_by_another_name_keeps_its_settings(
    make_site: MakeSite, name: str
) -> None:
    said = f"theme: {{name: material, font: false}}\nmarkdown_extensions: [{name}]"
    config = settings_of(make_site(CONFIG.replace("theme: {name: material, font: false}", said)))
    assert "footnotes" not in config.markdown_extensions
    assert "admonition" in config.markdown_extensions


def test_a_theme_may_be_a_name_alone(make_site: MakeSite) -> None:
    root = make_site(CONFIG.replace("{name: material, font: false}", "material"))
    config = settings_of(root)
    assert config.theme["font"] is False
    assert config.theme["palette"] == usual_settings.PALETTE


def test_the_settings_of_this_project_stay_as_they_are() -> None:
    root = Path(__file__).parents[2]
    before = load_config(str(root / "mkdocs.yml"))
    after = settings_of(root)
    for name in ("markdown_extensions", "mdx_configs", "extra", "validation"):
        assert after[name] == before[name], name
    for name in ("font", "features", "palette"):
        assert after.theme[name] == before.theme[name], name
