"""Worlds are there for those who name them, say that they are impossible, and are nowhere else."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from sim.bridge.protocol import answer
from sim.cli import main
from sim.scene import SceneError, read_fence
from sim.scene.said import Said
from sim.worlds.describe import kinds
from tests.worlds.scenes import HEAVY_INTO_LIGHT

WALLED = {"right": "wall", "length": 2.4}
OWN_CODES = ("unknown-world", "no-wall", "needs-wall", "no-pair", "twice")
"""Of worlds alone; what is said of numbers is said by the reader of all numbers."""

LAW = "def force(overlap, rate, stiffness):\n    return stiffness * overlap\n"
FILE = """\
carts:
  A: {mass: 2 kg, position: 0.4 m, velocity: 0.4 m/s}
  B: {mass: 0.5 kg, position: 1.2 m}
until: 3 s
worlds: [bigger-pushes-more]
"""


def fence(worlds: object, **more: Any) -> Any:
    return read_fence(HEAVY_INTO_LIGHT | more | {"worlds": worlds}, named=False)


def test_a_scene_names_its_worlds_with_their_numbers() -> None:
    found = fence(["bigger-pushes-more", {"reaction-comes-later": {"delay": "200 ms"}}]).worlds
    assert [world.kind.name for world in found] == ["bigger-pushes-more", "reaction-comes-later"]
    assert found[1].numbers == {"delay": 0.2}


@pytest.mark.parametrize(
    ("worlds", "more", "code", "hint"),
    [
        (["bigger-push-more"], {}, "unknown-world", "bigger-pushes-more"),
        ([3], {}, "unknown-world", "worlds:"),
        ([{"reaction-comes-later": {"delay": "-1 s"}}], {}, "out-of-range", "delay"),
        ([{"reaction-comes-later": {"dealy": "1 s"}}], {}, "unknown-key", "delay"),
        (["passive-cannot-push"], {}, "no-wall", "wall"),
        (
            ["passive-cannot-push"],
            {
                "track": WALLED,
                "effects": [{"spring": {"stiffness": 5, "length": 0.1, "between": ["B", "right"]}}],
            },
            "needs-wall",
            "between two carts",
        ),
        (["mover-pushes-more"], {"contact": {"law": "instant"}}, "no-pair", "stiffness"),
        (["mover-pushes-more"] * 2, {}, "twice", "once"),
    ],
)
def test_what_cannot_be_meant_is_an_error_at_its_place(
    worlds: object, more: dict[str, Any], code: str, hint: str
) -> None:
    with pytest.raises(SceneError) as caught:
        fence(worlds, **more)
    (problem,) = caught.value.problems
    assert (problem.path[0], problem.code) == ("worlds", code)
    assert hint in problem.hint
    assert isinstance(problem.message, Said) or code not in OWN_CODES


def test_a_world_beside_a_law_of_ones_own_is_refused_and_throws_no_law_away() -> None:
    """A world runs the laws that are there; carts of an unknown one went through each other."""
    own = {"laws": {"mine.py": LAW}, "contact": {"law": "mine.py", "stiffness": 100}}
    with pytest.raises(SceneError) as caught:
        fence(["bigger-pushes-more"], **own)
    (problem,) = caught.value.problems
    assert (problem.path, problem.code) == (("worlds",), "own-law")
    assert "mine.py" in problem.hint
    request = {"kind": "worlds", "scene": HEAVY_INTO_LIGHT | own, "worlds": ["motion-needs-force"]}
    header, _ = answer(request | {"world": "motion-needs-force"})
    assert not header["ok"]
    assert header["problems"][0]["code"] == "own-law"


def test_nothing_of_them_is_imported_where_a_scene_names_none() -> None:
    code = (
        "from sim.scene import read_fence; from sim.dynamics.loop.run import run\n"
        "from sim.bridge.protocol import answer; import sys, json\n"
        f"plain = json.loads({json.dumps(json.dumps(HEAVY_INTO_LIGHT))})\n"
        "run(read_fence(plain, named=False).scene)\n"
        "answer({'id': 1, 'kind': 'run', 'scene': plain})\n"
        "print([m for m in sys.modules if m.startswith('sim.worlds')])"
    )
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert told.stdout.strip() == "[]"


@pytest.mark.parametrize("way", ["--json", "--csv", ""])
def test_whatever_is_printed_of_a_world_says_that_it_is_impossible(
    way: str, tmp_path: Path
) -> None:
    file = tmp_path / "scene.yml"
    file.write_text(FILE, encoding="utf-8")
    asked = ["run", str(file), "--world", "bigger-pushes-more", *([way] if way else [])]
    told = CliRunner().invoke(main, asked)
    assert told.exit_code == 0, told.output
    assert "mpossible" in told.stdout.splitlines()[0]
    if way == "--json":
        found = json.loads(told.stdout)
        assert found["impossible"] == ["bigger-pushes-more"]
        assert found["broken"]["momentum"] == pytest.approx(0.24 / 0.85, abs=1e-6)


def test_an_ordinary_run_says_that_nothing_in_it_is_impossible(tmp_path: Path) -> None:
    file = tmp_path / "scene.yml"
    file.write_text(FILE, encoding="utf-8")
    told = json.loads(CliRunner().invoke(main, ["run", str(file), "--json"]).stdout)
    assert told["impossible"] == []


def test_a_world_that_the_scene_does_not_name_cannot_be_reached(tmp_path: Path) -> None:
    file = tmp_path / "scene.yml"
    file.write_text(FILE, encoding="utf-8")
    told = CliRunner().invoke(main, ["run", str(file), "--world", "mover-pushes-more"])
    assert told.exit_code == 2
    assert "worlds: [mover-pushes-more]" in told.stderr
    header, _ = answer({"kind": "worlds", "scene": HEAVY_INTO_LIGHT, "world": "mover-pushes-more"})
    assert not header["ok"]


@pytest.mark.parametrize("world", [name for name, kind in kinds().items() if kind.needs != "wall"])
def test_the_page_is_told_which_world_it_is_and_what_breaks(world: str) -> None:
    request = {"kind": "worlds", "scene": HEAVY_INTO_LIGHT, "worlds": [world], "world": world}
    header, numbers = answer(request)
    assert header["ok"]
    assert header["impossible"] == [world]
    assert header["broken"]
    assert header["says"]["code"] == kinds()[world].says
    assert ["on", "A-B", "A"] in header["columns"]
    assert len(numbers) == header["rows"] * len(header["columns"])
