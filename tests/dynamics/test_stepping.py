"""Stepping methods: their order where the force is smooth, the trap where it jumps, their books."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.stepping.methods import ADAPTIVE, FIXED, MethodChoice, batch, outcome
from sim.dynamics.stepping.recorded import stepped
from sim.dynamics.stepping.stepped_report import stepped_report
from sim.laws.lookup import contact_law
from sim.scene import Scene, read_scene
from sim.scene.model import Contact
from tests import registry

PHASES = (np.arange(64) + 0.5) / 64
ALL = [
    *(MethodChoice(name, step=1 / 997) for name in (*FIXED, "rk4-events")),
    *(MethodChoice(name, rtol=1e-9) for name in ADAPTIVE),
]


def scene_of_springs() -> Scene:
    """Smooth everywhere: a swing of two carts whose bumpers never meet."""
    return read_scene(registry.plain("spring-pair") | {"until": 1})


def two(law: str = "paper", e: str = "0.8", **more: object) -> Scene:
    return read_scene(registry.two_carts(law=law, restitution=e, **more))


def error(scene: Scene, choice: MethodChoice) -> float:
    done = outcome(scene, choice)
    return max(abs(a - b) for a, b in zip(done.v, run(scene).v, strict=True))


def worst(scene: Scene, method: str, parts: int) -> float:
    _, v, _ = batch(scene, MethodChoice(method, step=scene.until / parts), PHASES)
    true = run(scene).v
    return max(float(abs(lane - u).max()) for lane, u in zip(v, true, strict=True))


def slope(parts: list[int], errors: list[float]) -> float:
    """Of the line through log error against log step."""
    return float(-np.polyfit(np.log(parts), np.log(errors), 1)[0])


@pytest.mark.parametrize(("name", "order"), [(name, m.order) for name, m in FIXED.items()])
def test_a_method_has_its_order_where_the_force_is_smooth(name: str, order: int) -> None:
    scene, parts = scene_of_springs(), [211, 431, 863, 1723] if order < 4 else [61, 127, 251, 499]
    errors = [error(scene, MethodChoice(name, step=1 / n)) for n in parts]
    assert abs(slope(parts, errors) - order) < 0.2


def test_located_touches_give_rk4_its_order_back() -> None:
    scene, parts = two(), [499, 997, 1993, 3989]
    errors = [
        max(
            max(
                abs(a - b)
                for a, b in zip(outcome(scene, choice, phase).v, (-0.8, 0.4), strict=True)
            )
            for phase in (0.2, 1.0)
        )
        for choice in (MethodChoice("rk4-events", step=1 / n) for n in parts)
    ]
    assert abs(slope(parts, errors) - 4) < 0.2


@pytest.mark.parametrize("name", ["semi-implicit", "verlet", "yoshida", "richardson", "rk4"])
def test_without_located_touches_every_method_is_of_first_order(name: str) -> None:
    # The force of `paper` jumps at touch: the step it happens in is wrong by one part of a step.
    parts = [127, 307, 757, 1879, 4649]
    assert abs(slope(parts, [worst(two(), name, n) for n in parts]) - 1) < 0.2


@pytest.mark.parametrize("name", ADAPTIVE)
def test_a_smaller_tolerance_is_a_smaller_error(name: str) -> None:
    errors = [error(two(), MethodChoice(name, rtol=rtol)) for rtol in (1e-6, 1e-9, 1e-12)]
    assert errors[0] > errors[1] > errors[2]
    assert errors[2] < 1e-11


def test_the_method_of_order_8_pays_where_much_is_asked_for() -> None:
    asked = 1e-12
    eight, five = (outcome(two(), MethodChoice(n, rtol=asked)) for n in ("adaptive", "rk45"))
    assert eight.field.evaluations < 0.5 * five.field.evaluations


def test_explicit_euler_makes_energy_and_semi_implicit_does_not() -> None:
    hard = two("bumper", "1")
    for name, least, most in (("euler", 1.02, 1.2), ("semi-implicit", 0.99, 1.01)):
        _, v, _ = batch(hard, MethodChoice(name, step=1 / 997), PHASES)
        delivered = (v[1] - v[0]) / 1.5
        assert least < delivered.min() <= delivered.max() < most


def test_a_contact_shorter_than_a_step_blows_up() -> None:
    # w h = 8: far beyond the limit of stability of every fixed step.
    done = outcome(two("bumper", "1", stiffness=200_000_000), MethodChoice("rk4", step=1 / 1009))
    assert max(map(abs, done.v)) > 10


SOLVED = [
    "dead-stop", "drag-quadratic", "drag-steady-speed", "friction-and-bumper", "incline-bounce",
    "instant", "light-meets-heavy", "off-the-wall", "push-a-train", "push-against-friction",
    "push-only",
    "release-while-moving", "spring-and-push", "sticky", "touching-row", "triple-hit",
]  # fmt: skip


@pytest.mark.parametrize("name", SOLVED)
def test_located_steps_come_to_what_the_exact_solver_says(name: str) -> None:
    scene = registry.scene(name)
    true = run(scene)
    located = (
        MethodChoice("rk4-events", step=scene.until / 997),
        MethodChoice("rk45", rtol=1e-9),
        ALL[-1],
    )
    for choice, near in zip(located, (2e-4, 2e-6, 5e-7), strict=True):
        done = outcome(scene, choice)
        x = [cart.position + s for cart, s in zip(scene.carts, done.s, strict=True)]
        assert x == pytest.approx(true.x, abs=near)
        assert done.v == pytest.approx(true.v, abs=near)


PUSHED_TOGETHER = {
    "carts": {
        "A": {"mass": 1, "position": "0.5"},
        "B": {"mass": 2, "position": "0.75"},
    },
    "track": {"right": "wall", "length": 1},
    "contact": {"restitution": 0, "stiffness": 300},
    "until": 3,
    "effects": [{"push": {"cart": "A", "force": 2, "until": 3}}],
}
"""B comes to the wall, and A pushes both against it."""


@pytest.mark.parametrize("choice", ALL[-3:], ids=lambda choice: choice.method)
def test_a_bumper_that_is_held_pressed_in_takes_few_events(choice: MethodChoice) -> None:
    scene = read_scene(PUSHED_TOGETHER)
    done = stepped(scene, choice)
    assert done.evaluations < 13_000  # 4 per step and some more; it was half a million
    assert done.run.v == pytest.approx((0, 0), abs=1e-9)
    assert done.run.x == pytest.approx(run(scene).x, abs=2e-6)
    # The push of 2 N goes through both contacts into the wall, and nothing else is left over.
    for pair in ("A-B", "B-right"):
        assert done.samples.columns[("F", pair)][-1] == pytest.approx(2, rel=1e-9)
    assert abs(done.lost_momentum) < 1e-9
    assert done.run.ledger.momentum_final == pytest.approx(0, abs=1e-9)


def test_a_bumper_that_is_held_lets_go_when_the_push_ends_or_turns() -> None:
    back = {"push": {"cart": "A", "force": -1, "from": 2}}
    push = {"push": {"cart": "A", "force": 2, "until": 2}}
    scene = read_scene(PUSHED_TOGETHER | {"effects": [push, back]})
    done = outcome(scene, MethodChoice("rk4-events", step=3 / 997))
    assert done.v == pytest.approx(run(scene).v, abs=1e-6)
    assert done.v[0] == pytest.approx(-1, abs=1e-6)  # 1 N on 1 kg for 1 s
    assert not done.field.held


@pytest.mark.parametrize("choice", ALL, ids=lambda choice: choice.method)
@pytest.mark.parametrize("name", ["paper-two-carts", "incline-bounce", "spring-damped"])
def test_momentum_is_accounted_for_whatever_the_method(name: str, choice: MethodChoice) -> None:
    done = stepped(registry.scene(name), choice)
    assert abs(done.lost_momentum) < 1e-12


def test_energy_out_of_nothing_is_said_and_grows_with_the_step() -> None:
    lost = {
        (name, n): stepped(two(), MethodChoice(name, step=1 / n)).lost_energy
        for name, n in itertools.product(("euler", "rk4", "rk4-events"), (199, 997))
    }
    assert lost["euler", 199] > 4 * lost["euler", 997] > 0.1
    assert abs(lost["rk4", 997]) < 1e-3
    assert abs(lost["rk4-events", 997]) < 1e-8


@pytest.mark.parametrize("law", ["bumper", "paper", "push-only", "push-only-uncorrected", "hertz"])
@pytest.mark.parametrize("method", list(FIXED))
def test_a_batch_is_its_runs(law: str, method: str) -> None:
    scene, choice = two(law, stiffness=5000), MethodChoice(method, step=1 / 211)
    s, v, _ = batch(scene, choice, PHASES)
    for k in (0, 40):
        one = outcome(scene, choice, float(PHASES[k]))
        assert one.v == pytest.approx([lane[k] for lane in v], abs=1e-12)
        assert one.s == pytest.approx([lane[k] for lane in s], abs=1e-12)


@pytest.mark.parametrize("e", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("law", ["bumper", "paper"])
def test_a_force_is_one_number_for_one_run_and_for_many(law: str, e: float) -> None:
    contact = contact_law(Contact(law=law, restitution=e, stiffness=400.0))
    assert contact is not None
    force = contact.stepping(0.5)
    d, v, memory = (
        np.array(column)
        for column in zip(
            *itertools.product((-0.01, 0.0, 0.004, 0.02), (-1.0, 0.5), (0.0, 0.004, 0.01)),
            strict=True,
        )
    )
    each = [force.push(a, b, c) for a, b, c in zip(d, v, memory, strict=True)]
    assert force.pushes(d, v, memory) == pytest.approx(each, abs=0)


def test_a_stepped_report_has_the_form_of_any_run() -> None:
    scene = registry.scene("paper-two-carts")
    document = stepped_report(stepped(scene, MethodChoice("rk4", step=0.001)))
    kinds = [event["kind"] for event in document["events"]]
    assert kinds == ["contact", "peak", "separate", "end"]
    (phase,) = document["plan"]
    assert (phase["solver"], phase["tier"]) == ("rk4", None)
    assert document["evaluations"]["solvers"] == {"rk4": 4000}
    assert math.isclose(document["final"]["v"]["A"], -0.8, abs_tol=2e-3)
    assert "imbalance" in document["energy"] and "imbalance" in document["momentum"]
