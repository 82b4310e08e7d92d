"""Free bodies of carts that stick together: Newton's second law for each, and Coulomb's bound."""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import trajectory
from sim.dynamics.stepping.methods import NAMES, Way
from sim.dynamics.stepping.recorded import stepped
from sim.scene import read_scene

G = 9.81  # m/s²
MASSES = {"A": 0.1, "B": 10.0, "C": 1.0}
FRICTION = 0.2
AGREE = 1e-9  # N


def forces(pushed: str, push: float, *, wall: bool = False) -> dict[tuple[str, ...], float]:
    """N, when they have met and come to rest, and one is pushed: ("F", pair) on its right cart,
    ("E", kind, cart)."""
    carts: dict[str, Any] = {
        name: {"mass": m, "position": round(0.1 + 0.2 * k, 1), "velocity": round(0.1 - 0.1 * k, 1)}
        for k, (name, m) in enumerate(MASSES.items())
    }
    track = {"left": "wall" if wall else "open", "right": "open", "length": 3}
    effects = [
        {"friction": {"coefficient": FRICTION}},
        {"push": {"cart": pushed, "force": push, "from": 2}},
    ]
    done = run(read_scene({"carts": carts, "track": track, "contact": {"law": "velcro"},
                           "until": 3, "effects": effects}))  # fmt: skip
    columns = trajectory(done).columns
    return {name: column[-1] for name, column in columns.items()}


@pytest.mark.parametrize("pushed", MASSES)
@pytest.mark.parametrize(("push", "held"), [(5.0, True), (-7.0, True), (60.0, False)])
def test_each_cart_of_a_body_has_the_force_that_its_motion_needs(
    pushed: str, push: float, held: bool
) -> None:
    found, names = forces(pushed, push), list(MASSES)
    for k, (name, mass) in enumerate(MASSES.items()):
        left = found.get(("F", f"{names[k - 1]}-{name}"), 0.0) if k else 0.0
        right = found[("F", f"{name}-{names[k + 1]}")] if k + 1 < len(names) else 0.0
        friction = found["E", "friction", name]
        outside = found.get(("E", "push", name), 0.0)
        assert left - right + friction + outside == pytest.approx(
            mass * found["a", name], abs=AGREE
        )
        assert abs(friction) <= FRICTION * mass * G + AGREE
        assert (found["a", name] == 0) == held


def test_three_that_meet_at_once_and_rub_stay_together_and_stand() -> None:
    """Two of velcro struck at one instant under friction: the run had no end and no bound."""
    found = forces("A", 0.0)
    assert [found["v", name] for name in MASSES] == [0, 0, 0]


def test_a_wall_that_a_body_sticks_to_bears_all() -> None:
    found = forces("C", 3.0, wall=True)
    assert [found["E", "friction", name] for name in MASSES] == [0, 0, 0]
    assert found["F", "A-B"] == pytest.approx(-3.0)  # it holds B back


@pytest.mark.parametrize("method", NAMES)
def test_steppers_share_what_rests_as_the_exact_run_does(method: str) -> None:
    """Two that stick together, of which one could bear six times as much as the other: the same
    coefficients while they slide, and it is the static ones that count when they have stopped."""
    friction = [
        {"friction": {"coefficient": 0.1, "static": static, "carts": [name]}}
        for name, static in (("A", 0.6), ("B", 0.1))
    ]
    effects = [*friction, {"push": {"cart": "A", "force": 3, "from": 1}}]
    carts = {
        "A": {"mass": 1, "position": 0.4, "velocity": 0.5},
        "B": {"mass": 1, "position": 0.6},
    }
    track = {"left": "open", "right": "open", "length": 3}
    scene = read_scene({"carts": carts, "track": track, "contact": {"law": "velcro"},
                        "until": 1.2, "effects": effects})  # fmt: skip
    found = stepped(scene, Way(method, step=1e-3)).samples.columns
    friction_on = {name: found["E", "friction", name][-1] for name in "AB"}
    assert friction_on["A"] == pytest.approx(6 * friction_on["B"])
    assert found["F", "A-B"][-1] == pytest.approx(found["a", "B"][-1] - friction_on["B"])
    if method != "yoshida":  # its steps back leave 0.1 mm/s of what rests
        true = trajectory(run(scene)).columns
        for name in (("E", "friction", "A"), ("E", "friction", "B"), ("F", "A-B")):
            assert found[name][-1] == pytest.approx(true[name][-1], abs=1e-6)
