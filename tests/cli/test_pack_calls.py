"""What `carts pack` refuses before it builds anything: a zip that no student could open."""

from __future__ import annotations

import pytest
from click.testing import CliRunner

from sim.cli import main


@pytest.fixture(autouse=True)
def _in_a_site(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert CliRunner().invoke(main, ["new", "mine"]).exit_code == 0
    monkeypatch.chdir(tmp_path / "mine")


@pytest.mark.parametrize("more", [[], ["--single"], ["--hosted"], ["--scorm"]])
@pytest.mark.parametrize("name", ["mechanics", "mechanics.txt", "week.2"])
def test_a_zip_of_another_ending_is_refused_with_its_name(name, more):
    result = CliRunner().invoke(main, ["pack", "--out", name, *more])
    assert (result.exit_code, result.stdout) == (2, "")
    assert f"--out {name}: the name of a zip ends in .zip: {name}.zip" in result.stderr


@pytest.mark.parametrize("word", ["", "  "])
def test_an_empty_word_of_teachers_is_refused(word):
    """Before, the zip was packed without “Change this lesson”, and nothing said so."""
    result = CliRunner().invoke(main, ["pack", "--teacher-word", word])
    assert (result.exit_code, result.stdout) == (2, "")
    assert "--teacher-word is empty" in result.stderr


@pytest.mark.parametrize("more", [["--hosted", "--scorm"], ["--scorm", "--single", "--hosted"]])
def test_two_kinds_of_zip_at_once_are_refused(more):
    """Before, the last one named was packed, and nothing was said about the other."""
    result = CliRunner().invoke(main, ["pack", *more])
    assert (result.exit_code, result.stdout) == (2, "")
    assert "--hosted and --scorm" in result.stderr
    assert "do not go together" in result.stderr


@pytest.mark.parametrize(("kind", "kept"), [("--scorm", False), ("--hosted", None)])
def test_lessons_in_a_platform_are_not_kept_by_browsers_for_later(kind, kept, monkeypatch):
    """A first visit would load the whole site, and each new package leave the old one behind."""
    asked = {}
    monkeypatch.setattr("sim.cli.site.pack.build_site", lambda *_, **how: asked.update(how))
    CliRunner().invoke(main, ["pack", kind])
    assert asked["settings"].get("offline") is kept
