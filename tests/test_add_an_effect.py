"""The guide's example is one folder: copied into a copy of the project, all works with it."""

from __future__ import annotations

import json
import math
import shutil
from pathlib import Path
from typing import Any

import pytest

from tests.guides import copy_project, python, shown_in

GUIDES = ("add-an-effect.md", "add-a-law.md")

B, W, M, T = 0.4, 0.8, 0.5, 4.0
V = W * (1.0 - math.exp(-B * T / M))
X = 0.5 + W * T - (M * W / B) * (1.0 - math.exp(-B * T / M))


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the project with the files of the guides, and nothing else changed."""
    copy = copy_project(tmp_path_factory.mktemp("project"))
    for guide in GUIDES:
        for place, text in shown_in(guide).items():
            (copy / place).parent.mkdir(parents=True, exist_ok=True)
            (copy / place).write_text(text, encoding="utf-8")
    return copy


def carts(project: Path, command: str, *words: str) -> Any:
    scene = "sim/effects/wind/scenes/wind-steady.yml"
    return json.loads(python(project, "-m", "sim", command, scene, *words, "--json"))


def test_the_run_ends_as_the_formula_says_and_its_ledger_closes(project: Path) -> None:
    run = carts(project, "run")
    assert run["final"]["v"]["A"] == pytest.approx(V, rel=1e-12)
    assert run["final"]["x"]["A"] == pytest.approx(X, rel=1e-12)
    energy = run["energy"]
    assert run["work"] == {"wind": pytest.approx(0.5 * M * V * V, rel=1e-12)}
    assert energy["initial"] + run["work"]["wind"] == pytest.approx(energy["final"], rel=1e-12)
    assert run["momentum"]["by"] == {"wind": pytest.approx(M * V, rel=1e-12)}


def test_the_plan_finds_the_closed_form_and_names_the_wind(project: Path) -> None:
    (phase,) = carts(project, "plan")
    assert (phase["tier"], phase["solver"]) == (0, "flight")
    assert "wind on A" in phase["why"]


@pytest.mark.parametrize("method", ["euler", "rk4", "rk4-events"])
def test_a_stepping_method_comes_to_the_same_end(project: Path, method: str) -> None:
    run = carts(project, "run", "--method", method, "--step", "0.001")
    assert run["final"]["v"]["A"] == pytest.approx(V, rel=1e-3)
    assert abs(run["energy"]["imbalance"]) < 1e-3


def test_a_scene_without_it_says_what_it_would_change(project: Path) -> None:
    """A cart at rest in a wind of 0.3 m/s with b = 0.002 kg/s: v = w (1 − e^(−bt/m))."""
    text = "carts: {A: {mass: 0.5, position: 0, velocity: 0}}\nuntil: 4 s\n"
    (project / "calm.yml").write_text(text)
    found = json.loads(python(project, "-m", "sim", "plan", "--relevance", "calm.yml", "--json"))
    (wind,) = [row for row in found if row["effect"] == "wind"]
    x = 0.3 * (T - M / 0.002 * (1.0 - math.exp(-0.002 * T / M)))
    v = 0.3 * (1.0 - math.exp(-0.002 * T / M))
    wanted = {"x.A": x, "v.A": v}[wind["changes"]["quantity"]]
    assert wind["changes"]["amount"] == pytest.approx(wanted, rel=1e-9)
    assert wind["size"] == "0.3 m/s" and not wind["listed"]


def test_what_accuracy_costs_is_told(project: Path) -> None:
    """The rows of `carts cost`, which `tests/cli/test_cost.py` tries as a command: every method as
    cheap as it is listed there, and the finest of one."""
    program = """
from sim.dynamics.cost.exact import exact
from sim.dynamics.cost.measure import exact_rows, row, choices
from sim.pages.text.yaml.source import load
from sim.scene import read_scene
scene = read_scene(load(open("sim/effects/wind/scenes/wind-steady.yml").read()).plain)
truth, listed = exact(scene), choices(scene)
assert exact_rows(scene, truth)
cheapest = {way.method: way for way in reversed(listed)}
assert {"euler", "rk4", "rk4-events"} < cheapest.keys()
for way in cheapest.values():
    row(scene, truth, way)
finest = [way for way in listed if way.method == "rk4"][-1]
assert row(scene, truth, finest).error_v < 1e-6
"""
    python(project, "-c", program)


def test_its_proof_holds_with_those_of_all_others(project: Path) -> None:
    """The folder is whole, exact and stepped runs, the program within 2 %, nothing warm below 0."""
    words = ("-p", "no:cacheprovider", "tests/dynamics/test_effect_proofs.py", "-k", "wind")
    assert python(project, "-m", "pytest", "-q", *words).startswith("." * 5 + " ")


def test_a_slider_and_a_switch_move_it(project: Path) -> None:
    program = """
from sim.bridge.protocol import answer
from sim.pages.text.yaml.source import load
from sim.scene import read_fence
plain = dict(load(open("sim/effects/wind/scenes/wind-steady.yml").read()).plain)
controls = [{"set": "wind.speed", "from": -1, "to": 1, "step": 0.1}, {"switch": "wind"}]
fence = read_fence({"id": "wind", **plain, "controls": controls})
assert [c.label for c in fence.controls] == ["speed of the wind"], fence.controls
assert [s.label for s in fence.switches] == ["wind"], fence.switches
still, _ = answer({"id": 1, "kind": "run", "scene": plain, "set": {"wind.active": False}})
assert still["final"]["v"]["A"] == 0 and "wind" in still["notSimulated"]
back, _ = answer({"id": 1, "kind": "run", "scene": plain, "set": {"wind.speed": -0.8}})
assert abs(back["final"]["v"]["A"] + VELOCITY) < 1e-12
(effect,) = back["effects"]
assert (effect["agent"], effect["called"]) == ("the air", "a wind")
assert ["E", "wind", "A"] in back["columns"]
header, _ = answer({"id": 2, "kind": "energy", "scene": plain})
assert header["parts"] == ["wind", "warmed"], header
""".replace("VELOCITY", repr(V))
    python(project, "-c", program)


def test_its_page_is_in_the_navigation_and_in_the_table(project: Path) -> None:
    program = """
import yaml
from sim.pages.site.effect_pages import effect_pages, index_text, with_effects
site = yaml.unsafe_load(open("mkdocs.yml").read().replace("!!python/name:", ""))
pages = str(with_effects(site["nav"]))
assert pages.index("drag.md") < pages.index("physics/effects/wind.md") < pages.index("push.md")
index = index_text(open("docs/physics/effects/index.md").read())
assert "| [wind](wind.md) | on a cart by the air |" in index
assert effect_pages()["physics/effects/wind.md"].is_file()
"""
    python(project, "-c", program)
    assert "no findings" in python(project, "-m", "sim", "check", "sim/effects")


def test_a_folder_that_does_not_describe_itself_fails_loudly(project: Path) -> None:
    folder = project / "sim" / "effects" / "nothing"
    folder.mkdir()
    (folder / "__init__.py").write_text("")
    try:
        with pytest.raises(AssertionError, match="describes no KIND of that name"):
            carts(project, "run")
    finally:
        shutil.rmtree(folder)


LAW = """
from sim.bridge.model_text import model_text
from sim.dynamics.loop.run import run
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import stepped
from sim.scene import read_scene
carts = {"A": {"mass": 1, "position": 0, "velocity": 1}, "B": {"mass": 1, "position": 0.5}}
contact = {"law": "gel", "restitution": 0.8}
scene = read_scene({"carts": carts, "contact": contact, "until": 2})
done = run(scene)
assert abs(done.v[1] - done.v[0] - 0.4) < 1e-14, done.v
assert done.ledger.imbalance() < 1e-12
near = stepped(scene, MethodChoice("rk4-events", step=1e-3)).run.v
assert abs(near[0] - done.v[0]) < 1e-7, near
names = {"print": lambda *_, **__: None}
exec(model_text(scene), names)
assert abs(names["v"][0] - done.v[0]) < 0.02, names["v"]
third = {"C": {"mass": 2, "position": 0.7, "velocity": -0.2}}
row = run(read_scene({"carts": carts | third, "contact": contact, "until": 2}))
assert "power-series" in row.solvers and row.ledger.imbalance() < 1e-12
"""


def test_a_new_law_is_one_folder_too(project: Path) -> None:
    python(project, "-c", LAW)
    contact = "{law: gel, restitution: 0.8}"
    carts = "{A: {mass: 1, position: 0, velocity: 1}, B: {mass: 1, position: 0.5}}"
    scene = project / "gel.yml"
    scene.write_text(f"carts: {carts}\ncontact: {contact}\n", encoding="utf-8")
    told = python(project, "-m", "sim", "run", str(scene), "--certify")
    assert "No certificate: gel has no bound yet." in told
