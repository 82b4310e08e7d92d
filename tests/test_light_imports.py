"""An import loads what it must and nothing else: a page, a command and a teacher wait less."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest


def loaded_by(statement: str) -> set[str]:
    """Top-level packages that a fresh interpreter has loaded after the statement."""
    code = f"{statement}\nimport sys, json; print(json.dumps(sorted(sys.modules)))"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return {name.split(".")[0] for name in json.loads(run.stdout)} | set(json.loads(run.stdout))


def test_import_sim_pulls_in_nothing_of_ours() -> None:
    assert {name for name in loaded_by("import sim") if name.startswith("sim.")} == set()


HEAVY = {
    "duckdb",
    "flint",
    "ibis",
    "pandas",
    "pyarrow",
    "mpmath",
    "numpy",
    "scipy",
    "yaml",
    "mkdocs",
    "markdown",
    "jinja2",
    "click",
    "playwright",
    "js",
}


@pytest.mark.parametrize(
    ("module", "may_load"),
    [
        ("sim", set()),
        ("sim.scene", set()),
        ("sim.dynamics", set()),
        ("sim.measured.report", set()),
        ("sim.bridge.protocol", set()),
        ("sim.cli", {"click"}),
        ("sim.cli.classroom.results", {"click"}),
        ("sim.pages.text.yaml.source", {"yaml"}),
        ("sim.pages.checks.lessons", {"yaml"}),
        ("sim.pages.blocks.extension", {"yaml", "markdown"}),
    ],
)
def test_an_import_is_light(module: str, may_load: set[str]) -> None:
    assert loaded_by(f"import {module}") & HEAVY <= may_load


def test_the_inner_layers_do_not_load_slow_parts_of_the_standard_library() -> None:
    # Every module loaded here is loaded in the page too, before the first reply.
    slow = {"asyncio", "email", "http", "logging", "subprocess", "typing_extensions", "unittest"}
    assert loaded_by("import sim.bridge.protocol") & slow == set()


def test_reading_a_scene_loads_no_forces_that_it_does_not_list() -> None:
    scene = {"carts": {"A": {"mass": 1, "position": 0}}, "effects": [{"drag": {"linear": 1}}]}
    loaded = loaded_by(f"from sim.scene import read_scene; scene = read_scene({scene})")
    assert not {name for name in loaded if name.startswith("sim.") and name.endswith(".force")}
    loaded = loaded_by(
        f"from sim.scene import read_scene; scene = read_scene({scene})\n"
        "from sim.dynamics.loop.run import run; run(scene)"
    )
    forces = {name for name in loaded if name.startswith("sim.effects.") and "force" in name}
    assert forces == {"sim.effects.forces", "sim.effects.drag.force"}
