"""Mistakes in mkdocs.yml are told with their place, before anything is built."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main

MISTAKES = [
    ("site_name: Physik: 9b\n", "1:18", "this is not YAML", 'site_name: "Physics: 9b"'),
    ("\tsite_name: x\n", "1:1", "a tab character", "use spaces"),
    ("site_name: a\nsiteid: b\n", "2:1", "“siteid” is no setting", "extra: {carts: {site_id"),
    ("site_nam: a\n", "1:1", "“site_nam” is no setting", "did you mean “site_name”?"),
    ("theme:\n  language: deutsch\n", "2:13", "does not speak “deutsch”", "de, fr, ms"),
    ("plugins:\n  - carts:\n    teacher_word: EULE\n", "3:5", "not under it", "with 6 spaces"),
    ("plugins:\n  - carts:\n      teacher_wort: X\n", "3:7", "no setting of carts", "teacher_word"),
    ("extra:\n  carts:\n    siteid: a-b\n", "3:5", "“siteid” says nothing", "“site_id”"),
    ("extra:\n  carts:\n    site_id: A b\n", "3:14", "not allowed", "my-school-physics"),
    (
        "nav:\n  - Home: index.md\n  - Lessons: worksheets/\n  - worksheets/cart.md\n"
        "docs_dir: worksheets\n",
        "4:5",
        "the menu names “worksheets/cart.md”, and there is no such page",
        "did you mean “worksheets/carts.md”?",
    ),
    ("nav:\n  - More:\n      - Home: home.md\n", "3:15", "“home.md”", "- Home: index.md"),
    (
        "nav:\n  - Carts: carts.md\ndocs_dir: worksheets\n",
        "2:12",
        "“carts.md”, and there is no such page",
        "did you mean “worksheets/carts.md”?",
    ),
    (
        "theme:\n  name: material\n  logo: own.svg\ndocs_dir: worksheets\n",
        "3:9",
        "there is no file “own.svg” in this site",
        "write worksheets/own.svg",
    ),
    ("extra_css: [own.css]\n", "1:13", "there is no file “own.css”", "worksheets/own.css"),
    ("plugins:\n  - search\n  - cart\n", "3:5", "no plugin is called “cart”", "“carts”?"),
    ("plugins: {serach: {}, carts: {}}\n", "1:11", "no plugin is called “serach”", "“search”?"),
    ("site_name: a\nplugins:\n  - search\n", "2:1", "“carts” is not listed", "below it: - carts"),
    ("site_name: a\nplugins:\n", "2:1", "“carts” is not listed", "below it: - carts"),
    ("site_name: a\n", "2:1", "“carts” is not listed", "plugins: [search, carts]"),
    ("nav:\n  - Lessons: worksheet/\n", "2:14", "names “worksheet/”", "mean “worksheets/”?"),
    ("nav:\n  - Effects: physics/effect/\n", "2:14", "no such page", "“physics/effects/”?"),
    ("nav:\n  - Lessons: all/\n", "2:14", "no such page", "- Lessons: worksheets/"),
    ("- site_name\n", "1:1", "no list of settings", "site_name: My lessons"),
]


@pytest.fixture
def site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "worksheets").mkdir()
    (tmp_path / "worksheets" / "carts.md").write_text("# Carts\n", encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize(("text", "place", "told", "hint"), MISTAKES)
def test_a_mistake_in_the_settings_is_found_without_building(
    site: Path, text: str, place: str, told: str, hint: str
) -> None:
    (site / "mkdocs.yml").write_text(text, encoding="utf-8")
    result = CliRunner().invoke(main, ["check"])
    assert result.exit_code == 1
    first, second = result.output.splitlines()[:2]
    assert first.startswith(f"mkdocs.yml:{place}: error: ")
    assert told in first
    assert hint in second


@pytest.mark.parametrize("text", [one for one, *_ in MISTAKES if "language" in one])
def test_a_build_stops_at_such_a_mistake_in_the_same_words(site: Path, text: str) -> None:
    (site / "mkdocs.yml").write_text(f"site_name: a\n{text}", encoding="utf-8")
    result = CliRunner().invoke(main, ["build"])
    assert result.exit_code == 1
    assert "mkdocs.yml:3:13: error: the theme does not speak" in result.output
    assert "Traceback" not in result.output


@pytest.mark.parametrize("plugins", ["[search, cart]", "[search]"])
def test_a_build_without_our_plugin_stops_with_the_place(site: Path, plugins: str) -> None:
    """MkDocs' own words for it have no line, or it would build pages without lessons."""
    (site / "mkdocs.yml").write_text(f"site_name: a\nplugins: {plugins}\n", encoding="utf-8")
    result = CliRunner().invoke(main, ["build"])
    assert result.exit_code == 1
    assert "mkdocs.yml:2:" in result.output
    assert "“cart" in result.output
    assert "Config value" not in result.output


def test_what_other_plugins_and_extensions_are_told_is_theirs(site: Path) -> None:
    text = (
        "site_name: a\nplugins:\n  - search:\n      lang: de\n  - carts\n  - other: {any: 1}\n"
        "markdown_extensions:\n  - emoji:\n      index: !!python/name:material.emoji\n"
        "theme: material\nextra: {own: 1, carts: {site_id: a-b-c}}\n"
    )
    (site / "mkdocs.yml").write_text(text, encoding="utf-8")
    assert CliRunner().invoke(main, ["check"]).exit_code == 0


@pytest.mark.parametrize(
    ("plugins", "told"), [("[carts, search]", 1), ("[carts, blog]", 0), ("{carts: {}, own: {}}", 0)]
)
def test_pages_that_other_plugins_may_make_are_not_missed(
    site: Path, plugins: str, told: int
) -> None:
    text = f"site_name: a\nnav:\n  - News: news/index.md\nplugins: {plugins}\n"
    (site / "mkdocs.yml").write_text(text, encoding="utf-8")
    result = CliRunner().invoke(main, ["check"])
    assert result.output.count("there is no such page") == told
    assert result.exit_code == told


def test_a_menu_names_what_the_build_makes_and_what_is_elsewhere(site: Path) -> None:
    (site / "worksheets" / "words" / "ms").mkdir(parents=True)
    (site / "worksheets" / "words" / "ms" / "carts.po").write_text("", encoding="utf-8")
    names = "index.md class-results.md worksheets/ worksheets/carts.md worksheets/ms/carts.md"
    menu = "".join(f"  - {name}\n" for name in [*names.split(), "https://example.org/", "/a.html"])
    text = f"site_name: a\nnav:\n{menu}docs_dir: worksheets\nplugins: [carts]\n"
    (site / "mkdocs.yml").write_text(text, encoding="utf-8")
    result = CliRunner().invoke(main, ["check", "mkdocs.yml"])
    assert result.output == "no findings\n"  # and it is read as no scene


def test_a_logo_and_style_sheets_are_files_beside_lessons_of_the_theme_or_elsewhere(
    site: Path,
) -> None:
    (site / "worksheets" / "own.css").write_text("", encoding="utf-8")
    looks = "logo: worksheets/carts.md, favicon: assets/images/favicon.png"
    text = (
        f"site_name: a\ntheme: {{name: material, {looks}}}\ndocs_dir: worksheets\n"
        "extra_css: [worksheets/own.css, https://example.org/a.css]\nplugins: [carts]\n"
    )
    (site / "mkdocs.yml").write_text(text, encoding="utf-8")
    result = CliRunner().invoke(main, ["check", "mkdocs.yml"])
    assert result.output == "no findings\n"
