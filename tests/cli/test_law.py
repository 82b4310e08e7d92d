"""`carts law`: what is said, what a program gets, and a worst scene that breaks the law again."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from sim.cli import main

SPRING = "def force(overlap):\n    return 300 * overlap\n"
HEAVY_WINS = "def force(overlap, mass_self):\n    return 300 * overlap / mass_self\n"
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
