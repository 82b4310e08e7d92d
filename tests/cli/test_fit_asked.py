"""`carts fit`: what it says of units, and of options that a file has no use for."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from sim.cli import main
from tests.measured.devices import Motion, motion_capture, sensor_carts, tracker_project
from tests.measured.force_sensors import sensors
from tests.measured.makers import as_text, film, truth
from tests.measured.several_runs import below

FILM = as_text(film(truth()))


def fit(path: Path, text: str, *words: object) -> Result:
    path.write_text(text, encoding="utf-8")
    return CliRunner().invoke(main, ["fit", str(path), *map(str, words)])


def read(result: Result) -> list[str]:
    assert result.exit_code == 0, result.output
    notes: list[str] = json.loads(result.stdout)["read"]
    return notes


def forces() -> str:
    measured = sensors()
    rows = zip(measured.tracks[0].t, *(track.value for track in measured.tracks), strict=True)
    return "\n".join(["t (s),F_A (N),F_B (N)", *(",".join(f"{v:.6f}" for v in r) for r in rows)])


def test_a_unit_that_nobody_gave_is_called_assumed(tmp_path: Path) -> None:
    notes = read(fit(tmp_path / "film.txt", FILM, "--json"))
    assert "t in s (assumed: the file names no unit; --time takes s, ms, µs or min)" in notes
    assert "x in m (assumed: the file names no unit; --length takes m, cm or mm)" in notes
    assert "as you say" not in fit(tmp_path / "film.txt", FILM).stdout


def test_a_unit_that_was_asked_for_names_its_option(tmp_path: Path) -> None:
    result = fit(tmp_path / "film.txt", FILM, "--length", "m", "--json")
    assert "x in m (as --length says)" in read(result)
    assert "warning" not in result.stderr


@pytest.mark.parametrize(
    "text",
    [
        tracker_project(Motion(v=(0.5, -0.1), touch=1.0, until=2.0)).replace("length_unit", "_"),
        sensor_carts(Motion()).replace(" (m)", ""),
    ],
    ids=["a project without its unit", "a log without a unit of positions"],
)
def test_other_readers_too_say_which_unit_they_assumed(tmp_path: Path, text: str) -> None:
    result = fit(tmp_path / "film.txt", text, "--json")
    notes: Any = json.loads(result.stdout)["read"]
    assert sum(note.startswith("x in m (assumed: the file names no unit") for note in notes) == 1


@pytest.mark.parametrize(
    ("text", "there"),
    [
        (FILM, 1),
        (motion_capture(Motion(until=2.0)), 1),
        (sensor_carts(Motion()), 1),
        (below([sensor_carts(Motion(), seed=k) for k in (1, 2)]), 2),
    ],
    ids=["a table", "motion capture", "a log", "a log of two runs"],
)
def test_a_run_that_no_file_holds_is_refused(tmp_path: Path, text: str, there: int) -> None:
    result = fit(tmp_path / "film.txt", text, "--run", 3)
    assert result.exit_code == 1
    assert f"film.txt:1:1: error: there is no run 3: this file has {there}" in result.stderr


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (("--length", "cm"), "--length cm changes nothing: the files hold forces"),
        (("--force", "mN"), "--force mN changes nothing: the files name their own unit"),
        (("--time", "ms"), "--time ms changes nothing: the files name their own unit"),
    ],
)
def test_a_unit_that_no_column_needs_is_told_in_one_line(
    tmp_path: Path, words: tuple[str, ...], why: str
) -> None:
    result = fit(tmp_path / "forces.csv", forces(), *words)
    assert result.exit_code == 0
    assert result.stderr == f"warning: {why}\n"


def test_what_only_positions_have_is_refused_for_forces(tmp_path: Path) -> None:
    result = fit(tmp_path / "forces.csv", forces(), "--mass", "A=1kg", "--touch", "2 cm")
    assert result.exit_code == 2
    assert "--mass, --touch: for positions only; these files hold forces." in result.stderr


def test_a_law_for_carts_that_stick_is_told_to_change_nothing(tmp_path: Path) -> None:
    sticks = motion_capture(Motion(e=0.0, v=(0.2, 0.0)))
    result = fit(tmp_path / "capture.tsv", sticks, "--law", "paper", "--json")
    assert json.loads(result.stdout)["outcome"] == "stick"
    assert result.stderr.startswith("warning: --law changes nothing: it belongs to the model")


def test_without_scipy_the_command_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "scipy", None)
    result = fit(tmp_path / "film.txt", FILM)
    assert result.exit_code == 1
    assert isinstance(result.exception, SystemExit)  # no traceback
    assert "needs the Python package scipy" in result.stderr
    assert "pip install scipy" in result.stderr


def test_units_that_were_assumed_and_cannot_be_are_named(tmp_path: Path) -> None:
    film_of = film(truth(), 30)
    rows = zip(film_of.tracks[0].t, *(one.value for one in film_of.tracks), strict=True)
    text = "\n".join(["t;A;B", *(f"{1e3 * t:.1f};{1e2 * a};{1e2 * b}" for t, a, b in rows)])
    said = fit(tmp_path / "film.txt", text).stderr
    assert "--time ms" in said
    assert "--length cm" in said
    assert (
        "warning" not in fit(tmp_path / "film.txt", text, "--time", "ms", "--length", "cm").stderr
    )
    assert "warning" not in fit(tmp_path / "film.txt", FILM).stderr


@pytest.mark.parametrize("name", ["A", "mass A"])
def test_a_cart_is_named_as_it_is_called_or_as_tracker_calls_it(tmp_path: Path, name: str) -> None:
    text = FILM.replace("\tA\t", "\tmass_A\t").replace("\tB\t", "\tmass_B\t")
    asked = ("--length", "m", "--time", "s", "--mass", f"{name}=0.5kg", "--json")
    found = json.loads(fit(tmp_path / "film.txt", text, *asked).stdout)
    assert found["names"] == ["A", "B"]
    assert "mass" in {one["key"] for one in found["known"]}


def test_a_mass_that_is_given_twice_is_refused(tmp_path: Path) -> None:
    """The last one was taken, without a word."""
    found = fit(tmp_path / "film.txt", FILM, "--mass", "A=500g", "--mass", "A=600g")
    assert found.exit_code == 2 and "--mass A=600g: A has one already." in found.output
