"""`carts law`: what is said, what a program gets, and a worst scene that breaks the law again."""

from __future__ import annotations

import json
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from sim.cli import main

SPRING = "def force(overlap):\n    return 300 * overlap\n"
HEAVY_WINS = "def force(overlap, mass_self):\n    return 300 * overlap / mass_self\n"
SCENE = """\
carts:
  A: {mass: 2 kg, position: 0.4 m, velocity: 0.4 m/s}
  B: {mass: 0.5 kg, position: 1.2 m}
contact: {law: spring.py, stiffness: 150 N/m}
until: 3 s
"""
UMLAUT = "\N{LATIN SMALL LETTER O WITH DIAERESIS}"
FEW = ("--budget", "8000")


def law(file: Path, *arguments: str) -> Result:
    return CliRunner().invoke(main, ["law", str(file), *arguments])


@pytest.fixture
def written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "spring.py").write_text(SPRING, encoding="utf-8")
    (tmp_path / "heavy.py").write_text(HEAVY_WINS, encoding="utf-8")
    return tmp_path


def test_a_right_law_holds_and_the_program_ends_well(written: Path) -> None:
    result = law(written / "spring.py", *FEW)
    assert result.exit_code == 0, result.output
    assert "BROKEN" not in result.output
    assert result.output.count("holds") >= 6


def test_a_law_without_a_pair_of_forces_is_broken_and_the_file_says_where(written: Path) -> None:
    result = law(written / "heavy.py", *FEW)
    assert result.exit_code == 1
    assert "BROKEN  third-law" in result.output
    found = json.loads(law(written / "heavy.py", "--json", *FEW).output)
    broken = [one["check"] for one in found["verdicts"] if not one["holds"]]
    assert "third-law" in broken


def test_the_worst_scene_runs_as_any_other_and_momentum_comes_from_nowhere(written: Path) -> None:
    worst = law(written / "heavy.py", "--yaml", "third-law", *FEW)
    (written / "worst.yml").write_text(worst.stdout, encoding="utf-8")
    ran = CliRunner().invoke(main, ["run", str(written / "worst.yml"), "--json"])
    assert ran.exit_code == 0, ran.output
    momentum = json.loads(ran.stdout)["momentum"]
    assert abs(momentum["final"] - momentum["initial"]) > 1e-3


@pytest.mark.parametrize(
    ("text", "line"),
    [("def force(overlap)\n    return 1\n", 1), ("def force(overlap):\n    return 1 / 0\n", 2)],
)
def test_a_mistake_is_told_at_its_line(written: Path, text: str, line: int) -> None:
    (written / "wrong.py").write_text(text, encoding="utf-8")
    result = law(written / "wrong.py", *FEW)
    assert result.exit_code == 1
    assert f"wrong.py:{line}:" in result.output
    assert "BROKEN" not in result.output


@pytest.mark.parametrize("name", ["2nd.py", "my law.py", f"force_{UMLAUT}.py"])
@pytest.mark.parametrize("above", ["", "    # my law, further in than the rest\n", "\n\n  # so\n"])
def test_a_counterexample_runs_whatever_the_file_is_called_and_begins_with(
    written: Path, name: str, above: str
) -> None:
    (written / name).write_text(above + HEAVY_WINS, encoding="utf-8")
    worst = law(written / name, "--yaml", "third-law", *FEW)
    (written / "worst.yml").write_text(worst.stdout, encoding="utf-8")
    ran = CliRunner().invoke(main, ["run", str(written / "worst.yml"), "--json"])
    assert ran.exit_code == 0, ran.output


def test_the_call_that_is_printed_gives_the_scene_that_was_told_of(written: Path) -> None:
    (written / "a folder").mkdir()
    file = written / "a folder" / "heavy.py"
    file.write_text(HEAVY_WINS, encoding="utf-8")
    (written / "mine.yml").write_text(
        "carts:\n  A: {mass: 3 kg, position: 0.4 m, velocity: 0.3 m/s}\n"
        "  B: {mass: 0.7 kg, position: 1.2 m}\n",
        encoding="utf-8",
    )
    given = ["--seed", "5", "--scene", str(written / "mine.yml"), *FEW]
    told = law(file, *given)
    call = shlex.split(told.output.split("The scene itself: carts ")[1])
    again = CliRunner().invoke(main, call)
    assert again.stdout == law(file, *given, "--yaml", "third-law").stdout
    assert again.stdout.startswith("title:")


def test_it_begins_with_a_scene_of_a_lesson_that_names_the_law_which_lies_elsewhere(
    written: Path,
) -> None:
    (written / "scene.yml").write_text(SCENE, encoding="utf-8")
    (written / "lessons").mkdir()
    lesson = written / "lessons" / "two.md"
    lesson.write_text(f"# Two\n\n```scene\nid: one\n{SCENE}```\n", encoding="utf-8")
    of_file, of_lesson = (
        law(written / "spring.py", "--scene", name, "--json", *FEW)
        for name in ("scene.yml", f"{lesson}#one")
    )
    assert of_lesson.exit_code == 0, of_lesson.output
    assert of_lesson.output == of_file.output


def test_no_call_is_printed_for_a_law_that_came_through_a_pipe(written: Path) -> None:
    told = CliRunner().invoke(main, ["law", "-", *FEW], input=HEAVY_WINS)
    assert "BROKEN  third-law" in told.output
    assert "carts law" not in told.output


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-8"])
def test_run_takes_a_law_in_the_text_files_that_law_takes(written: Path, encoding: str) -> None:
    (written / "spring.py").write_text(SPRING, encoding=encoding)
    (written / "scene.yml").write_text(SCENE, encoding="utf-8")
    assert law(written / "spring.py", *FEW).exit_code == 0
    ran = CliRunner().invoke(main, ["run", "scene.yml"])
    assert ran.exit_code == 0, ran.output
    assert CliRunner().invoke(main, ["check", "scene.yml"]).exit_code == 0


@pytest.mark.parametrize("encoding", ["utf-16", "latin-1"])
def test_a_law_that_is_not_utf8_is_told_so_by_every_command(written: Path, encoding: str) -> None:
    text = SPRING + "# " + UMLAUT + "\n"
    (written / "spring.py").write_text(text, encoding=encoding)
    (written / "scene.yml").write_text(SCENE, encoding="utf-8")
    line = 1 if encoding == "utf-16" else 3
    for call in (["law", "spring.py"], ["run", "scene.yml"], ["check", "scene.yml"]):
        result = CliRunner().invoke(main, call)
        assert result.exit_code == 1, call
        assert f"spring.py:{line}:1: error: this is not UTF-8 text" in result.output, call
