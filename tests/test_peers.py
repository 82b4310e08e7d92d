"""The table of other engines is that of the measurement that is kept; and they stay outside."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import pytest

from tests.benchmarks import peers
from tests.benchmarks._peers_scenes import SCENES, Carts

ROOT = Path(__file__).parents[1]
DOCUMENT = json.loads(peers.FILE.read_text(encoding="utf-8"))


def test_the_table_of_the_page_is_what_was_measured() -> None:
    page = peers.PAGE.read_text(encoding="utf-8")
    assert peers.with_table(page, DOCUMENT) == page
    for engine in DOCUMENT["engines"]:
        assert f"| {engine['engine']} {engine['version']}".rstrip() in page


def test_the_versions_are_those_of_the_locks() -> None:
    packages = json.loads((ROOT / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    locked = {
        name.rpartition("/")[2].removesuffix("-compat"): packages[f"node_modules/{name}"]["version"]
        for name in peers.NPM
    }
    lines = (ROOT / "requirements.lock").read_text(encoding="utf-8").splitlines()
    (pymunk,) = (line.split("==")[1].split()[0] for line in lines if line.startswith("pymunk=="))
    told = {one["engine"]: one["version"] for one in DOCUMENT["engines"][1:]}
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    (mujoco,) = (one.partition("==")[2] for one in project["optional-dependencies"]["peers"])
    assert told == locked | {"pymunk": pymunk, "MuJoCo": mujoco}


def test_the_engines_are_development_dependencies_only() -> None:
    package = json.loads((ROOT / "package.json").read_text(encoding="utf-8"))
    assert set(peers.NPM) <= set(package["devDependencies"])
    assert not set(peers.NPM) & set(package["dependencies"])
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert not any("pymunk" in name for name in project["dependencies"])
    shipped = [p.read_text(encoding="utf-8") for p in (ROOT / "sim" / "web").rglob("*.js")]
    assert shipped
    assert not any(name in text for text in shipped for name in peers.NPM)


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.name)
def test_what_they_are_measured_against_is_a_formula(scene: Carts) -> None:
    for run in peers.ends(scene):
        momentum = sum(m * v for m, (_, v) in zip(scene.mass, run, strict=True))
        start = sum(m * v for m, v in zip(scene.mass, scene.v, strict=True))
        if scene.left is None:
            assert momentum == pytest.approx(start, abs=1e-14)
        else:
            energy = sum(m * v * v for m, (_, v) in zip(scene.mass, run, strict=True))
            first = sum(m * v * v for m, v in zip(scene.mass, scene.v, strict=True))
            assert energy == pytest.approx(first, rel=1e-13)
        if len(scene.mass) == 2 and scene.left is None:
            assert run[1][1] - run[0][1] == pytest.approx(scene.e * (scene.v[0] - scene.v[1]))
    if scene.name == "row":  # equal carts hand the motion on
        assert [v for _, v in run] == pytest.approx([0] * 9 + [2], abs=1e-14)
