"""A mkdocs.yml with mistakes is answered with a sentence by every command."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.pages.findings import SiteError
from sim.pages.site.site_id import facts_of

COMMANDS = (["build"], ["doctor"], ["key"], ["pack"])


def told(settings: str, command: list[str], monkeypatch: pytest.MonkeyPatch, place: Path) -> str:
    monkeypatch.chdir(place)
    Path("mkdocs.yml").write_text(settings, encoding="utf-8")
    result = CliRunner().invoke(main, command)
    assert result.exception is None or isinstance(result.exception, SystemExit)
    assert result.exit_code == 1
    return result.output


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
@pytest.mark.parametrize("extra", ["{carts: my-school}", "{carts: [a]}", "my-school"])
def test_what_should_be_a_table_and_is_none_is_told(
    extra: str, command: list[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    said = told(f"site_name: A\nextra: {extra}\n", command, monkeypatch, tmp_path)
    assert "mkdocs.yml: error: extra: carts: is no table" in said
    assert "site_id: my-school-physics" in said


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_a_character_that_nobody_sees_has_its_place(
    command: list[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    said = told("site_name: A\nextra: {a: b\x07}\n", command, monkeypatch, tmp_path)
    assert "mkdocs.yml:2:13: error: this is not YAML: a character that nobody sees" in said


@pytest.mark.parametrize("extra", [None, {}, {"carts": None}, {"other": 1}])
def test_a_site_may_say_nothing(extra: object) -> None:
    assert facts_of(extra) == {}
    with pytest.raises(SiteError):
        facts_of({"carts": "a"})


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_a_day_that_no_calendar_has_is_told(
    command: list[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    said = told("site_name: A\nextra: {begun: 2026-02-30}\n", command, monkeypatch, tmp_path)
    assert "mkdocs.yml: error: there is a day that no calendar has" in said
    assert "stands in quotes" in said
