"""Effects: only what a scene lists is imported and evaluated; plan, events, account."""

from __future__ import annotations

import json
import math
import pkgutil
import re

import pytest

import sim.dynamics
import sim.effects
from sim.dynamics.loop.run import run
from sim.dynamics.report.document import report
from sim.dynamics.report.plan import packages, plan
from sim.pages.blocks.bake import bake
from sim.scene import apply_changes, read_scene
from sim.scene.effects import kinds
from tests import registry
from tests.dynamics.given.imports_of_a_run import imported_by

G = 9.81

TIERS = {
    "balanced-push": [0],
    "drag-linear": [0],
    "drag-quadratic": [0],
    "drag-steady-speed": [0],
    "friction-and-bumper": [0, 2, 0],
    "friction-stop": [0],
    "friction-two-surfaces": [0],
    "hertz-cradle": [0, 2, 1, 0],
    "hertz-pair": [0, 1, 0],
    "incline-bounce": [0, 1, 0],
    "incline-friction-holds": [0],
    "incline-up-and-down": [0],
    "magnets-collision": [2],
    "magnets-repel": [2],
    "push-a-train": [1, 2, 0],
    "push-against-friction": [0],
    "push-then-coast": [0],
    "release-and-friction": [0],
    "release-by-a-spring": [0, 1, 0],
    "release-explosion": [0],
    "release-while-moving": [0],
    "spring-and-push": [1],
    "spring-damped": [1],
    "spring-pair": [1],
    "spring-to-wall": [1],
}
"""Tiers in order of time, repetitions left out: never a dearer one than the scene calls for."""

MOMENTS = {
    "friction-stop": [("stop", ["A"], 0.6 / (0.02 * G))],
    "friction-two-surfaces": [
        ("stop", ["B"], 0.5 / (0.04 * G)),
        ("stop", ["A"], 0.5 / (0.02 * G)),
    ],
    "incline-friction-holds": [
        ("stop", ["A"], 0.3 / (G * (0.03 * math.cos(math.pi / 180) - math.sin(math.pi / 180))))
    ],
    "push-against-friction": [
        ("start", ["A"], 2.5),
        ("stop", ["A"], 4.5 + 2 * (0.1981 / 0.5 - 0.02 * G) / (0.02 * G)),
    ],
    "release-by-a-spring": [("release", ["A", "B"], 1.0)],
    "release-explosion": [("release", ["A", "B"], 1.0)],
    "release-while-moving": [("release", ["A", "B"], 2.0)],
    "balanced-push": [],
    "incline-up-and-down": [],
}
"""Kind, bodies and time, each by hand."""


def listed(name: str) -> set[str]:
    return {kind for effect in registry.plain(name).get("effects", []) for kind in effect}


def test_every_effect_has_a_scene_by_itself():
    alone = [listed(name) for name in registry.NAMES]
    assert all({kind} in alone for kind in kinds())


@pytest.mark.parametrize("name", registry.NAMES)
def test_what_is_evaluated_is_what_is_listed(name):
    assert set(run(registry.scene(name)).effects) == listed(name)


def test_an_effect_on_another_cart_is_not_evaluated_for_this_one():
    plain = registry.plain("friction-two-surfaces")
    both = run(read_scene(plain)).effects["friction"]
    one = run(read_scene(plain | {"effects": plain["effects"][:1]})).effects["friction"]
    assert 0 < one < both


ALONE = ["friction-stop", "incline-bounce", "drag-quadratic", "push-then-coast"]
ALONE += ["spring-pair", "magnets-repel", "release-explosion", "triple-hit"]


@pytest.mark.parametrize("name", ALONE)
def test_a_scene_imports_the_effects_that_it_lists_and_no_others(name):
    modules = imported_by(registry.plain(name))
    forces = {m.split(".")[2] for m in modules if re.fullmatch(r"sim\.effects\.\w+\.force", m)}
    assert forces == listed(name)
    assert not modules & {"numpy", "scipy", "sim.dynamics.motion.adaptive"}


@pytest.mark.parametrize("name", ["hertz-pair", "hertz-cradle"])
def test_balls_import_no_scipy(name):
    modules = imported_by(registry.plain(name))
    assert not modules & {"numpy", "scipy", "sim.dynamics.motion.adaptive"}


def test_balls_that_are_hit_from_both_sides_at_one_instant_import_scipy():
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0, "velocity": 1},
            "B": {"mass": 1, "position": 0.5},
            "C": {"mass": 1, "position": 1, "velocity": -1},
        },
        "contact": {"law": "hertz", "stiffness": 2000},
        "until": 0.5,
    }
    assert "scipy" in imported_by(plain)


@pytest.mark.parametrize("name", registry.NAMES)
def test_a_page_carries_packages_only_for_balls(name):
    heavy = {"numpy", "scipy"} if name.startswith("hertz") else set()
    assert bake(registry.plain(name)).packages == heavy
    assert packages(plan(run(registry.scene(name)))) == ()


def test_a_page_carries_packages_for_balls_that_a_slider_may_bring_together():
    apart = apply_changes(registry.plain("hertz-pair"), {"A.velocity": "-0.1"})
    assert packages(plan(run(read_scene(apart)))) == ()
    assert bake(apart).packages == {"numpy", "scipy"}


def test_every_module_of_the_numerics_is_found_where_a_page_is_packed():
    found = {
        m.name
        for package in (sim.dynamics, sim.effects)
        for m in pkgutil.walk_packages(package.__path__, f"{package.__name__}.")
    }
    assert {f"sim.effects.{kind}.force" for kind in kinds()} <= found
    assert "sim.dynamics.motion.adaptive" in found


@pytest.mark.parametrize("name", TIERS)
def test_every_phase_has_the_cheapest_solver_that_is_exact(name):
    phases = plan(run(registry.scene(name)))
    tiers = [phases[0].tier]
    for phase in phases[1:]:
        if phase.tier != tiers[-1]:
            tiers.append(phase.tier)
    assert tiers == TIERS[name]
    for phase in phases:
        assert phase.packages == (("numpy", "scipy") if phase.tier == 3 else ())
        assert phase.why


@pytest.mark.parametrize("name", sorted(set(registry.NAMES) - set(TIERS)))
def test_the_scenes_without_a_row_above_have_no_effects(name):
    assert listed(name) == set()


@pytest.mark.parametrize("kind", list(kinds()))
def test_the_reasons_name_the_effect_while_it_acts(kind):
    alone = [name for name in registry.NAMES if listed(name) == {kind}]
    name = "release-by-a-spring" if kind == "release" else alone[0]  # the others take no time
    assert any(kind in phase.why for phase in plan(run(registry.scene(name))))


@pytest.mark.parametrize("name", MOMENTS)
def test_stops_starts_and_releases_are_told_with_bodies_and_times(name):
    events = report(run(registry.scene(name)))["events"]
    told = [e for e in events if e["kind"] in ("stop", "start", "release")]
    assert [(e["kind"], e["bodies"]) for e in told] == [m[:2] for m in MOMENTS[name]]
    for event, (_, _, t) in zip(told, MOMENTS[name], strict=True):
        assert event["t"] == pytest.approx(t, rel=1e-12)


def test_a_release_tells_its_impulse_and_no_force():
    (event, _) = report(run(registry.scene("release-explosion")))["events"]
    assert event["impulse"] == pytest.approx(math.sqrt(2 * 0.06 / 3), rel=1e-14)  # mu = 1/3 kg
    assert event["force"] is None
    assert event["before"] == {"A": 0, "B": 0}
    assert event["after"] == pytest.approx({"A": -0.4, "B": 0.2}, rel=1e-14)


@pytest.mark.parametrize("name", sorted(TIERS))
def test_the_report_is_json_and_its_sums_close(name):
    document = report(run(registry.scene(name)))
    assert json.loads(json.dumps(document, allow_nan=False)) == document
    energy, momentum = document["energy"], document["momentum"]
    tolerance = 1e-11 if name.startswith("hertz") else 1e-14
    for end in ("initial", "final"):
        parts = [part[end] for part in energy["parts"].values()]
        assert math.fsum(parts) == pytest.approx(energy[end], abs=tolerance)
    work = math.fsum(document["work"].values())
    assert energy["initial"] + work == pytest.approx(
        energy["final"] + energy["warmed"], abs=tolerance
    )
    assert math.fsum(momentum["by"].values()) == pytest.approx(momentum["external"], abs=1e-14)
    change = momentum["final"] - momentum["initial"]
    assert change == pytest.approx(momentum["external"], abs=1e-14)
    assert set(document["work"]) <= listed(name)
    assert set(momentum["by"]) <= listed(name) | {"walls"}


def test_friction_and_drag_only_take():
    for name in registry.NAMES:
        works = run(registry.scene(name)).ledger.works
        assert works.get("friction", 0.0) <= 0.0
        assert works.get("drag", 0.0) <= 0.0


def test_two_carts_alone_get_no_momentum_from_what_is_between_them():
    for name in ("spring-pair", "magnets-repel", "magnets-collision", "release-explosion"):
        assert run(registry.scene(name)).ledger.impulses == {}
