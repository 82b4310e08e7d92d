"""Rows of spheres in their own time: beside the closed form of a pair, and an integration."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.motion.curved import group, series
from sim.dynamics.motion.curved.own_time import OwnTime
from sim.dynamics.result.trajectory import sample, trajectory
from sim.laws.hertz.law import Hertz
from sim.scene import read_scene
from tests.dynamics.given.imports_of_a_run import imported_by
from tests.reference.contact_branches import begin
from tests.reference.effects import integrate

MOST_STEPS = 30
"""Of one contact with its neighbour; the method of order 8 took 60 to 200."""


def row(e: float, effects: list[Any] | None = None, rooms: tuple[float, ...] = (0.1, 0.0)) -> Any:
    """Three spheres and a wall; A comes, the others wait, in touch where a room is 0."""
    plain: dict[str, Any] = {
        "carts": {"A": {"mass": 1.0, "position": 0.1, "velocity": 1.0}},
        "contact": {"law": "hertz", "stiffness": 900.0, "restitution": e},
        "until": 1.5,
    }
    at = 0.1
    for name, mass, room in zip("BC", (0.3, 2.0), rooms, strict=True):
        at = round(at + 0.2 + room, 6)
        plain["carts"][name] = {"mass": mass, "position": at}
    plain["track"] = {"left": "open", "right": "wall", "length": round(at + 0.15, 6)}
    return plain | {"effects": effects or []}


EFFECTS: dict[str, list[Any]] = {
    "none": [],
    "incline": [{"incline": {"angle": "3 deg"}}],
    "friction": [{"friction": {"coefficient": 0.05}}],
    "linear drag": [{"drag": {"linear": 0.4}}],
    "damped spring": [
        {"spring": {"between": ["B", "C"], "stiffness": 40, "length": 0.05, "damping": 0.3}}
    ],
    "magnets": [{"magnets": {"between": ["C", "right"], "strength": 1e-3, "power": 2.5}}],
    "push": [{"push": {"cart": "C", "force": -2.0, "from": 0.05, "until": 0.4}}],
}


TOUCHING, APART = (0.1, 0.0), (0.1, 0.01)
# Of every effect three, in turn: each e both ways, each effect with each e.
ROWS = [
    (effect, e, (TOUCHING, APART)[(k + n) % 2])
    for k, effect in enumerate(EFFECTS)
    for n, e in enumerate((1.0, 0.6, 0.05))
]


@pytest.mark.parametrize(("effect", "e", "rooms"), ROWS)
def test_a_row_of_spheres_ends_where_an_integration_ends(
    effect: str, e: float, rooms: tuple[float, ...]
) -> None:
    scene = read_scene(row(e, EFFECTS[effect], rooms))
    done, expected = run(scene), integrate(scene, most_steps=20_000)
    assert done.solvers["power-series"] > 0
    assert "adaptive" not in done.solvers
    assert done.v == pytest.approx(expected.v, abs=1e-9)
    assert done.x == pytest.approx(expected.x, abs=1e-9)
    assert done.ledger.imbalance() < 1e-13


@pytest.mark.parametrize("e", [1.0, 0.8, 0.3, 0.05])
def test_what_accelerates_two_spheres_alike_does_not_change_their_contact(e: float) -> None:
    """On a slope the pair is no pair alone; its contact has that pair's duration and outcome."""
    plain = row(e, [{"incline": {"angle": "2 deg"}}])
    plain["carts"].pop("C")
    plain["track"] = {"left": "open", "right": "open", "length": 5}
    plain["until"] = 0.4
    done = run(read_scene(plain))
    touch, apart = (
        next(event for event in done.record.events if event.kind == kind)
        for kind in ("contact", "separate")
    )
    u = touch.before["A"] - touch.before["B"]
    alone = Hertz(900.0, e).alone(0.3 / 1.3, 0.0, u)
    assert alone is not None
    assert apart.t - touch.t == pytest.approx(alone.duration, rel=3e-14)
    assert apart.after["B"] - apart.after["A"] == pytest.approx(e * u, rel=3e-14)
    peak = next(event for event in done.record.events if event.kind == "peak")
    top = alone.greatest_force()
    assert peak.force == pytest.approx(alone.force(*alone.at(top))[0], rel=1e-12)
    assert peak.t - touch.t == pytest.approx(top, rel=1e-6)
    assert done.solvers["power-series"] <= MOST_STEPS


@pytest.mark.parametrize("effect", ["none", "incline", "damped spring"])
def test_a_row_of_spheres_seen_in_a_mirror_is_the_mirrored_row(effect: str) -> None:
    plain = row(0.6, EFFECTS[effect])
    length = plain["track"]["length"]
    mirrored = deepcopy(plain)
    mirrored["track"] = {"left": "wall", "right": "open", "length": length}
    mirrored["carts"] = {
        name: {
            "mass": cart["mass"],
            "position": round(length - cart["position"], 6),
            "velocity": -cart.get("velocity", 0.0),
        }
        for name, cart in reversed(plain["carts"].items())
    }
    for entry in mirrored["effects"]:
        if "spring" in entry:
            entry["spring"]["between"] = entry["spring"]["between"][::-1]
        if "incline" in entry:
            entry["incline"]["angle"] = "-3 deg"
    done, other = run(read_scene(plain)), run(read_scene(mirrored))
    assert done.v == pytest.approx([-v for v in reversed(other.v)], abs=1e-13)
    assert done.x == pytest.approx([length - x for x in reversed(other.x)], abs=1e-13)


@pytest.mark.parametrize("e", [1.0, 0.5])
def test_velocities_are_slopes_of_places_and_accelerations_of_velocities(e: float) -> None:
    done = run(read_scene(row(e)))
    touched = next(event for event in done.record.events if event.kind == "contact")
    h = 1e-6
    for late in (2e-4, 0.004, 0.02, 0.05):
        t = touched.t + late
        before, now, after = (sample(done, t + k * h) for k in (-1, 0, 1))
        slopes = [(b - a) / (2.0 * h) for a, b in zip(before[0], after[0], strict=True)]
        assert now[1] == pytest.approx(slopes, abs=1e-6)


@pytest.mark.parametrize("e", [1.0, 0.5])
def test_the_area_under_the_drawn_force_is_the_change_of_momentum(e: float) -> None:
    """Cubic between values and slopes: h (a + b)/2 + h² (a' − b')/12."""
    done = run(read_scene(row(e)))
    columns = trajectory(done).columns
    t, f, df = columns["t",], columns["F", "A-B"], columns["dF", "A-B"]
    area = 0.0
    for k in range(len(t) - 1):
        h = t[k + 1] - t[k]
        area += h * (f[k] + f[k + 1]) / 2.0 + h * h * (df[k] - df[k + 1]) / 12.0
    assert area == pytest.approx(1.0 - done.v[0], rel=1e-5)


DRAWN = 3e-4
"""Of the greatest force, which begins as the fourth root of the time where a damper pushes."""


@pytest.mark.parametrize("e", [1.0, 0.5, 0.1])
def test_the_drawn_force_of_damped_spheres_is_that_of_their_overlap_between_samples_too(
    e: float,
) -> None:
    """N = K d^1.5 + C d^0.25 d', off by a hundredth of the greatest just after a touch."""
    plain = row(e, rooms=APART)
    columns = trajectory(run(read_scene(plain))).columns
    b, c = (plain["carts"][name] for name in "BC")
    branch = begin("hertz", 900.0, e, 1.0 / (1.0 / b["mass"] + 1.0 / c["mass"]), 1e-9, 0.0)
    n, dn = columns["F", "B-C"], columns["dF", "B-C"]
    for k in pressed_cells(n):
        t0, t1 = columns["t",][k : k + 2]
        x, v = {}, {}
        for name in "BC":
            position, speed = columns["x", name], columns["v", name]
            x[name] = midway(t1 - t0, position[k : k + 2], speed[k : k + 2])
            v[name] = midway(t1 - t0, speed[k : k + 2], columns["a", name][k : k + 2])
        size = branch.force(x["B"] + 0.2 - x["C"], v["B"] - v["C"])
        drawn = midway(t1 - t0, n[k : k + 2], dn[k : k + 2])
        assert drawn == pytest.approx(size, abs=DRAWN * max(n)), t0


def pressed_cells(n: Any) -> list[int]:
    """Between which samples something is pushed."""
    return [k for k in range(len(n) - 1) if n[k] and n[k + 1]]


def midway(h: float, values: Any, slopes: Any) -> float:
    """The cubic through both ends of a cell, in its middle."""
    return float((values[0] + values[1]) / 2.0 + h * (slopes[0] - slopes[1]) / 8.0)


def test_a_row_of_spheres_needs_no_packages() -> None:
    assert not imported_by(row(0.6)) & {"numpy", "scipy", "sim.dynamics.motion.adaptive"}


def test_a_time_of_its_own_is_found_again() -> None:
    own = OwnTime([0.0, 0.0, 0.0, 0.0, 2.0, -0.5], 1.2, 0.0).until(1.2)
    for s in (0.0, 1e-5, 1e-3, 0.1, 0.7, 1.2):
        assert own.of(own.time(s)) == pytest.approx(s, rel=1e-10, abs=1e-12)
    assert own.of(-1.0) == 0.0
    assert own.of(9.0) == own.span


@pytest.mark.parametrize("walls", [0, 1])
def test_what_stands_costs_no_products(walls: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of each coefficient the way and the velocity of what moves are products; of a wall none."""
    plain: dict[str, Any] = {
        "carts": {"A": {"mass": 1.0, "position": 0.2, "velocity": 1.0}},
        "contact": {"law": "hertz", "stiffness": 900.0, "restitution": 0.8},
        "effects": [{"incline": {"angle": "-3 deg"}}, {"friction": {"coefficient": 0.01}}],
        "track": {"left": "open", "right": "wall" if walls else "open", "length": 0.5},
        "until": 0.5,
    }
    if not walls:
        plain["carts"]["B"] = {"mass": 2.0, "position": 0.45}
    real, asked, counts = series.dot, [0], []

    def counted(p: list[float], q: list[float]) -> float:
        asked[0] += 1
        return real(p, q)

    class Counted(series.RowSeries):
        def __init__(self, *given: Any) -> None:
            before = asked[0]
            super().__init__(*given)
            counts.append(asked[0] - before)

    monkeypatch.setattr(series, "dot", counted)
    monkeypatch.setattr(group, "RowSeries", Counted)
    run(read_scene(plain))
    moving = 2 - walls
    of_the_gap = 2 * series.ORDER - 1  # its overlap, from the second on, and its rate
    assert set(counts) == {of_the_gap + 2 * moving * series.ORDER}
