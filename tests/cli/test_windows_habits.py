"""What Windows does otherwise: letters of files, ends of lines, strokes in paths."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.cli.classroom.files import group_of, with_slashes

SCENE = "carts: {A: {mass: 1 kg, position: 0.4 m, velocity: -0.5 m/s}}\nuntil: 1 s\n"


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    file = tmp_path / "s.yml"
    file.write_text(SCENE, encoding="utf-8")
    return file


@pytest.mark.parametrize("form", [(), ("--json",), ("--csv",)])
def test_what_goes_into_a_file_is_utf_8_whatever_the_computer_prefers(
    scene: Path, form: tuple[str, ...]
) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "sim", "run", str(scene), *form],
        env={**os.environ, "PYTHONIOENCODING": "cp1252"},
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.decode("utf-8")


def test_lines_of_a_table_end_once(scene: Path) -> None:
    made = CliRunner().invoke(main, ["run", str(scene), "--csv"]).stdout_bytes
    assert made.endswith(b"\r\n")
    assert made.count(b"\n") == made.count(b"\r\n") > 2
    assert b"\r\r" not in made


def test_strokes_of_windows_paths_are_those_of_every_path() -> None:
    assert with_slashes("7a\\ann.json", windows=True) == "7a/ann.json"
    assert with_slashes("7a\\ann.json", windows=False) == "7a\\ann.json"


def test_a_folder_whose_name_would_be_a_pattern_is_itself() -> None:
    for pattern in ("class [7a]", "class [7a]/", "class [7a]/*"):
        groups = [("new", pattern), ("old", "class 7*")]
        assert group_of("all/class [7a]/ann.json", groups) == "new"
    assert group_of("all/class 7b/ben.json", groups) == "old"
