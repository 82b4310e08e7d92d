"""Every file that a command is asked to write is there, or a sentence says why it is not."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from sim.cli import main
from sim.dynamics.cost import measure
from tests.classroom.given.makers import bank, keys, random_class, sources
from tests.measured.makers import as_text, film, truth

ROOT = Path(__file__).parents[2]
LESSON = ROOT / "worksheets" / "newtons-third-law.md"
SCENE = ROOT / "tests" / "scenes" / "paper-two-carts.yml"
BANK = bank(6)

CALLS = {
    "fit --scene": "fit {film} --scene {out}",
    "fit --tracker": "fit {film} --tracker {out}",
    "cost --svg": f"cost {SCENE} --svg {{out}}",
    "single --out": f"single {SCENE} --out {{out}}",
    "key --out": f"key {LESSON} --out {{out}}",
    "export --out": f"export {LESSON} --out {{out}}",
    **{
        f"class --{what}": f"class {{school}} --key {{key}} --{what} {{out}}"
        for what in ("html", "csv", "items", "slips", "sheet", "summary")
    },
}
"""A call for each option that names what is written."""


@pytest.fixture
def call(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):  # type: ignore[no-untyped-def]
    """Runs a call, with small measurements and without the 15 MB of a whole scene."""
    ladder = tuple((name, primes[:1]) for name, primes in measure.LADDER)
    monkeypatch.setattr(measure, "LADDER", ladder)
    monkeypatch.setattr(measure, "BATCH", 1e-4)
    monkeypatch.setattr("sim.pages.single.of_scene.single_file", lambda *_, **__: "a page")
    given = {name: tmp_path / name for name in ("film", "school", "key")}
    given["film"].write_text(as_text(film(truth())), encoding="utf-8")
    given["key"].write_text(keys(BANK), encoding="utf-8")
    given["school"].mkdir()
    for source in sources(random_class(BANK, 6, seed=1)):
        (given["school"] / source.name).write_bytes(source.content)

    def made(words: str, out: Path) -> Result:
        return CliRunner().invoke(main, words.format(**given, out=out).split())

    return made


@pytest.mark.parametrize("name", CALLS)
def test_a_folder_that_cannot_be_written_is_told_in_a_sentence(name, call, tmp_path):
    (tmp_path / "plain").write_text("no folder", encoding="utf-8")
    for out, why in (
        (tmp_path / "plain" / "below", "a folder of its path is a file"),
        (Path("/proc/x"), ""),
    ):
        result = call(CALLS[name], out)
        assert result.exit_code == 1
        assert isinstance(result.exception, SystemExit), "no traceback"
        assert f"Error: {out}" in result.stderr
        assert f"cannot be written: {why}" in result.stderr
        assert f"Another place: {name.split()[1]} " in result.stderr


@pytest.mark.parametrize("name", CALLS)
def test_a_folder_that_is_missing_is_made(name, call, tmp_path):
    out = tmp_path / "new" / "folder" / "out"
    assert call(CALLS[name], out).exit_code == 0
    assert out.exists()


@pytest.mark.parametrize("name", [name for name in CALLS if name != "key --out"])  # a folder
def test_a_dash_is_no_name_of_a_file(name, call, tmp_path, monkeypatch):
    """Other programs take it for the screen; a file of this name nobody finds or deletes."""
    monkeypatch.chdir(tmp_path)
    result = call(CALLS[name], Path("-"))
    assert result.exit_code != 0
    assert f"“-” is not the name of a file here. Name a file: {name.split()[1]} " in result.stderr
    assert not Path("-").exists()


def test_a_folder_in_which_python_cannot_be_packed_is_told_in_a_sentence(call, monkeypatch):
    def no(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied", "/school/.cache")

    monkeypatch.setattr("sim.pages.single.of_scene.single_file", no)
    result = call(CALLS["single --out"], Path("a.html"))
    assert result.exit_code == 1
    assert "Error: /school/.cache: Permission denied. Go to a folder that is yours" in result.stderr
