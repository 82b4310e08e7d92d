"""Every effect's folder is whole; its proof holds: a closed form by hand, exactly and in steps."""

from __future__ import annotations

from importlib import import_module
from typing import Any

import pytest

from sim.bridge.model_text import model_text
from sim.dynamics.loop.run import run
from sim.dynamics.result.energy_parts import energy_parts
from sim.dynamics.result.trajectory import trajectory
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import stepped
from sim.scene.effects import kinds
from tests import registry
from tests.bridge.plain_program import played

FILES = ("__init__.py", "force.py", "model.py", "page.md", "proof.py", "scenes")


def proof(kind: str) -> Any:
    return import_module(f"sim.effects.{kind}.proof")


@pytest.mark.parametrize("kind", list(kinds()))
def test_a_folder_holds_all_that_is_known_of_its_effect(kind: str) -> None:
    folder = registry.ROOT / "sim" / "effects" / kind
    assert [name for name in FILES if not (folder / name).exists()] == []
    assert registry.PATHS[proof(kind).SCENE].parent == folder / "scenes"


@pytest.mark.parametrize("kind", list(kinds()))
def test_an_exact_run_ends_as_the_proof_says(kind: str) -> None:
    scene = registry.scene(proof(kind).SCENE)
    done = run(scene)
    for cart, x, v in zip(scene.carts, done.x, done.v, strict=True):
        assert (x, v) == pytest.approx(proof(kind).end(scene)[cart.name], rel=1e-12, abs=1e-13)


@pytest.mark.parametrize("kind", list(kinds()))
def test_a_stepping_method_comes_close_to_it(kind: str) -> None:
    scene = registry.scene(proof(kind).SCENE)
    done = stepped(scene, MethodChoice("rk4", step=1e-3)).run
    for cart, x, v in zip(scene.carts, done.x, done.v, strict=True):
        assert (x, v) == pytest.approx(proof(kind).end(scene)[cart.name], rel=1e-3, abs=1e-3)


@pytest.mark.parametrize("kind", list(kinds()))
def test_the_program_in_plain_python_comes_within_two_percent(kind: str) -> None:
    scene = registry.scene(proof(kind).SCENE)
    program = played(model_text(scene))
    for k, cart in enumerate(scene.carts):
        x, v = proof(kind).end(scene)[cart.name]
        assert program["x"][k] == pytest.approx(x, rel=0.02, abs=0.002)
        assert program["v"][k] == pytest.approx(v, rel=0.02, abs=0.002)


@pytest.mark.parametrize("kind", list(kinds()))
def test_no_energy_is_warm_below_nought(kind: str) -> None:
    done = run(registry.scene(proof(kind).SCENE))
    parts = energy_parts(done, trajectory(done))
    assert min(parts["warmed"]) >= -1e-12
    assert done.ledger.imbalance() < 1e-12
