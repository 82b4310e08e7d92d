"""Free bodies of carts that stick together: Newton's second law for each, and Coulomb's bound."""

from __future__ import annotations

from bisect import bisect_left
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import trajectory
from sim.dynamics.stepping.methods import NAMES, MethodChoice
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
    found = stepped(scene, MethodChoice(method, step=1e-3)).samples.columns
    friction_on = {name: found["E", "friction", name][-1] for name in "AB"}
    assert friction_on["A"] == pytest.approx(6 * friction_on["B"])
    assert found["F", "A-B"][-1] == pytest.approx(found["a", "B"][-1] - friction_on["B"])
    if method != "yoshida":  # its steps back leave 0.1 mm/s of what rests
        true = trajectory(run(scene)).columns
        for name in (("E", "friction", "A"), ("E", "friction", "B"), ("F", "A-B")):
            assert found[name][-1] == pytest.approx(true[name][-1], abs=1e-6)


RESTS = [{"friction": {"coefficient": 0.5, "static": 0.9, "carts": ["A"]}},
         {"friction": {"coefficient": 0.5, "static": 0.6, "carts": ["B"]}}]  # fmt: skip
AROUND: dict[str, list[dict[str, Any]]] = {
    "nothing": [],
    "drag": [{"drag": {"linear": 0.8, "carts": ["A"]}}],
    "much drag": [{"drag": {"linear": 0.2, "quadratic": 0.7}}],
    "friction": [{"friction": {"coefficient": 0.05, "carts": ["B", "C"]}}],
    "friction that holds": RESTS,
    "a slope and a push": [
        {"incline": {"angle": 0.02}},
        {"push": {"cart": "A", "force": 2, "until": 1.1}},
        {"drag": {"linear": 0.5, "carts": ["B"]}},
    ],
}


@pytest.mark.parametrize("law", ["bumper", "hertz"])
@pytest.mark.parametrize("wall", ["none", "left"])
@pytest.mark.parametrize("around", AROUND)
def test_the_drawn_force_between_joined_carts_runs_through_what_lies_between_its_samples(
    around: str, wall: str, law: str
) -> None:
    """C hits A and B, which stick together. The curve is a cubic through F and dF: it was a
    staircase, since dF was told to be nought."""
    plain = {
        "carts": {
            "A": {"mass": 0.6, "position": 0.1 if wall == "left" else 0.6, "velocity": -0.05},
            "B": {"mass": 1.3, "position": 0.3001 if wall == "left" else 0.8, "velocity": -0.06},
            "C": {"mass": 1, "position": 1.3, "velocity": -1},
        },
        "track": {"left": "wall" if wall == "left" else "open", "length": 3},
        "contact": {"law": law, "restitution": 1, "stiffness": 200 if law == "bumper" else 2000,
                    "pairs": {name: {"law": "velcro"} for name in ("A-B", "left-A")
                              if wall == "left" or name == "A-B"}},
        "effects": AROUND[around],
        "until": 2,
    }  # fmt: skip
    done = run(read_scene(plain))
    coarse, fine = trajectory(done, 16).columns, trajectory(done, 48).columns
    peak = max(map(abs, coarse["F", "B-C"]))
    assert peak > 5
    for name in ("A-B", "left-A") if wall == "left" else ("A-B",):
        rows = list(zip(coarse["t",], coarse["F", name], coarse["dF", name], strict=True))
        begins = [t for t, _, _ in rows]
        for t, force in zip(fine["t",], fine["F", name], strict=True):
            k = bisect_left(begins, t) - 1
            if k < 0 or k + 1 == len(rows) or t == begins[k + 1]:
                continue
            (t1, F1, dF1), (t2, F2, dF2) = rows[k : k + 2]
            u, h = (t - t1) / (t2 - t1), t2 - t1
            drawn = F1 * (1 + 2 * u) * (1 - u) ** 2 + F2 * u * u * (3 - 2 * u)
            drawn += h * (dF1 * u * (1 - u) ** 2 - dF2 * u * u * (1 - u))
            assert drawn == pytest.approx(force, abs=1e-6 * peak)
