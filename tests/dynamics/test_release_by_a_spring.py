"""A release with a stiffness: a spring that pushes while it is shorter than it wants to be.

What holds for every scene (mirror, train, units, account) is asked of random ones elsewhere.
"""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.result.energy_parts import energy_parts
from sim.dynamics.result.trajectory import trajectory
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import stepped
from tests.dynamics.given.spring_release import done, pair
from tests.fuzz.mirror import mirrored
from tests.reference.let_go import Bodies, followed

ROUNDING = 1e-14
"""m, m/s, s, N, J in scenes of that size: a few roundings of numbers of size one."""

INTEGRATED = 2e-10
"""m, m/s, s. What the second opinion is good to."""


@pytest.mark.parametrize("k", [0.5, 20.0, 3e3, 1e7])
@pytest.mark.parametrize(("m1", "m2"), [(0.5, 1.0), (1.0, 1.0), (1e-3, 40.0)])
def test_a_pair_alone_is_pushed_for_a_quarter_of_an_oscillation(
    k: float, m1: float, m2: float
) -> None:
    """F = k L cos ωt, in each sample, until π/(2 ω); then the speeds that the energy gives."""
    carts = {"A": {"mass": m1, "position": 1}, "B": {"mass": m2, "position": 1.2}}
    finished = done(pair(carts=carts, release={"stiffness": k}, until=6))
    mu, full = m1 * m2 / (m1 + m2), math.sqrt(2 * 0.06 / k)
    w = math.sqrt(k / mu)
    p = math.sqrt(2 * 0.06 * mu)
    let_go, fell, _ = finished.record.events
    assert (let_go.kind, let_go.t, let_go.impulse) == ("release", 0.25, 0.0)
    assert let_go.force == pytest.approx(k * full, rel=ROUNDING)
    assert (fell.kind, fell.bodies, fell.force) == ("separate", ("A", "B"), 0.0)
    assert fell.t - 0.25 == pytest.approx(0.5 * math.pi / w, rel=1e-13, abs=ROUNDING)
    assert fell.impulse == pytest.approx(p, rel=ROUNDING)
    assert list(finished.v) == pytest.approx([-p / m1, p / m2], rel=ROUNDING)
    samples = trajectory(finished).columns
    pushed = 0
    for t, force in zip(samples[("t",)], samples[("F", "A-B")], strict=True):
        tau = t - 0.25
        if 0.0 < tau < 0.5 * math.pi / w:
            pushed += 1
            assert force == pytest.approx(k * full * math.cos(w * tau), abs=1e-11 * k * full)
        elif tau < 0.0 or tau > 0.5 * math.pi / w:
            assert abs(force) <= 1e-11 * k * full  # the last sample may be a rounding late
    assert pushed > 10


ROWS = {
    "moving": Bodies([0.5, 1.0], [0.3, 0.3], [math.inf, 0.0], 500.0, springs=[(1, 20.0, 0.06)]),
    "a third one touches": Bodies(
        [0.5, 1.0, 0.7], [0.0] * 3, [math.inf, 0.0, 0.0], 500.0, springs=[(1, 20.0, 0.06)]
    ),
    "a third one is reached": Bodies(
        [0.5, 1.0, 0.7], [0, 0, -0.4], [math.inf, 0.0, 0.02], 300.0, springs=[(1, 20.0, 0.06)]
    ),
    "the wall is reached": Bodies(
        [0.5, 1.0], [0.0, 0.0], [0.01, 0.0], 400.0, springs=[(1, 20.0, 0.06)]
    ),
    "two springs": Bodies(
        [0.5, 1.0, 0.7], [0.0] * 3, [math.inf, 0.0, 0.0], 500.0,
        springs=[(1, 20.0, 0.06), (2, 90.0, 0.02)],
    ),
    "two pushes": Bodies(
        [0.5, 1.0], [0.0, 0.0], [math.inf, 0.0], 500.0, [0.2, -0.5], springs=[(1, 20.0, 0.06)]
    ),
    "hands stronger than it": Bodies(
        [0.5, 1.0], [0.0, 0.0], [math.inf, 0.0], 500.0, [4.0, -4.5], springs=[(1, 20.0, 0.06)]
    ),
    "air": Bodies(
        [0.5, 1.0], [0.0, 0.0], [math.inf, 0.0], 500.0, drag=0.4, springs=[(1, 20.0, 0.06)]
    ),
    "a curved law": Bodies(
        [0.5, 1.0, 0.7], [0.0] * 3, [math.inf, 0.0, 0.0], 3e3, power=1.5,
        springs=[(1, 20.0, 0.06)],
    ),
}  # fmt: skip


def plain_of(row: Bodies, until: float) -> dict[str, Any]:
    """The same row as a scene: the first wall at x = 0, where there is one."""
    names = "ABC"[: len(row.mass)]
    at, carts = (row.rooms[0] if row.rooms[0] < math.inf else 1.0), {}
    for k, name in enumerate(names):
        at += 0.1 + (row.rooms[k] if k else 0.0)
        carts[name] = {"mass": row.mass[k], "position": f"{at:.12g}", "velocity": row.v[k]}
        at += 0.1
    effects: list[dict[str, Any]] = [
        {"release": {"between": [names[g - 1], names[g]], "energy": e, "stiffness": k}}
        for g, k, e in row.springs
    ]
    effects += [
        {"push": {"cart": name, "force": f}} for name, f in zip(names, row.force, strict=False)
    ]
    effects += [{"drag": {"linear": row.drag}}] if row.drag else []
    law = "hertz" if row.power != 1.0 else "bumper"
    track = {"left": "wall"} if row.rooms[0] < math.inf else {}
    contact = {"law": law, "stiffness": row.stiff}
    return {
        "carts": carts, "track": track, "effects": effects, "until": until, "contact": contact
    }  # fmt: skip


@pytest.mark.parametrize("name", ROWS)
def test_an_integration_that_knows_none_of_our_formulas_ends_at_the_same_place(name: str) -> None:
    row, until = ROWS[name], 0.6
    other, own = followed(row, until), done(plain_of(row, until))
    starts = [cart.position for cart in own.scene.carts]
    assert [x - s for x, s in zip(own.x, starts, strict=True)] == pytest.approx(
        other.way, abs=INTEGRATED
    )
    assert list(own.v) == pytest.approx(other.v, abs=INTEGRATED)
    fell = {own.scene.names_at(g): t for g, t in other.fell.items()}
    told = {e.bodies: e.t for e in own.record.events if e.kind == "separate" and not e.force}
    assert {bodies: told[bodies] for bodies in fell} == pytest.approx(fell, abs=INTEGRATED)
    assert own.ledger.imbalance() < 1e-12


@pytest.mark.parametrize("name", [name for name in ROWS if "wall" not in name])
def test_both_carts_feel_it_at_every_instant(name: str) -> None:
    """Equal and opposite: besides hands and air nothing changes the momentum of all."""
    row = ROWS[name]
    if row.force or row.drag:
        return
    samples = trajectory(done(plain_of(row, 0.6))).columns
    names = "ABC"[: len(row.mass)]
    whole = math.fsum(m * v for m, v in zip(row.mass, row.v, strict=True))
    for k in range(len(samples[("t",)])):
        p = math.fsum(m * samples[("v", n)][k] for m, n in zip(row.mass, names, strict=True))
        assert p == pytest.approx(whole, abs=1e-13)
        f = math.fsum(m * samples[("a", n)][k] for m, n in zip(row.mass, names, strict=True))
        assert f == pytest.approx(0.0, abs=1e-11)


@pytest.mark.parametrize("name", ROWS)
def test_what_the_spring_held_is_in_the_motion_afterwards(name: str) -> None:
    finished = done(plain_of(ROWS[name], 0.6))
    energy = math.fsum(e for _, _, e in ROWS[name].springs)
    stored = energy_parts(finished, trajectory(finished))["release"]
    assert stored[0] == pytest.approx(energy, rel=ROUNDING)
    assert finished.ledger.potential["release"] == pytest.approx((energy, stored[-1]), abs=1e-13)
    assert min(stored) >= 0.0
    assert finished.ledger.imbalance() < 1e-12


def test_the_impulse_told_at_its_end_is_the_area_under_its_force() -> None:
    """Beside a cart that touches, and under a push: not what moved the pair as a whole."""
    finished = done(plain_of(ROWS["two pushes"], 0.6))
    fell = next(e for e in finished.record.events if e.kind == "separate")
    # m v of B: the spring's impulse and that of the hand, −0.5 N for so long
    assert 1.0 * fell.after["B"] == pytest.approx(fell.impulse - 0.5 * fell.t, abs=1e-13)
    assert 0.5 * fell.after["A"] == pytest.approx(-fell.impulse + 0.2 * fell.t, abs=1e-13)


def test_a_spring_weaker_than_static_friction_moves_nothing_and_keeps_its_energy() -> None:
    """k L = 1.55 N; 0.4 × 0.5 kg × g = 1.96 N holds A, B is held all the more."""
    rough = {"friction": {"coefficient": 0.4}}
    plain = pair()
    finished = done(plain | {"effects": [*plain["effects"], rough]})
    assert finished.v == (0.0, 0.0)
    assert finished.x == (1.1, 1.3)
    assert finished.ledger.potential["release"] == pytest.approx((0.06, 0.06), rel=ROUNDING)


@pytest.mark.parametrize("turned", [False, True])
def test_who_is_held_all_along_is_told_neither_to_start_nor_to_stop(turned: bool) -> None:
    """Of 1 kg and 10 kg the light one goes; on the right the heavy one was told to stop."""
    carts = {
        "A": {"mass": 1, "position": 0.1, "velocity": 0},
        "B": {"mass": 10, "position": 0.3, "velocity": 0},
    }
    plain = pair(carts=carts, release={"stiffness": 50}, track={"length": 1}, contact={}, until=2)
    plain["effects"].append({"friction": {"coefficient": 0.1}})
    plain["track"] |= {"left": "open", "right": "open"}
    events = done(mirrored(plain) if turned else plain).record.events
    told = [(event.kind, *event.bodies) for event in events if event.kind in ("start", "stop")]
    assert told == [("start", "A"), ("stop", "A")]


def test_friction_that_it_overcomes_takes_its_part() -> None:
    """Each cart slides from the start: m a = k (L − r) − μ m g, and at rest nothing is left."""
    plain = pair(until=4)
    rough = {"friction": {"coefficient": 0.02}}
    finished = done(plain | {"effects": [*plain["effects"], rough]})
    row = Bodies(
        [0.5, 1.0], [-1e-300, 1e-300], [math.inf, 0.0], 500.0, rub=0.02 * 9.81,
        springs=[(1, 20.0, 0.06)],
    )  # fmt: skip
    fell = next(e for e in finished.record.events if e.kind == "separate")
    second = followed(row, fell.t - 0.25)
    assert fell.after["A"] == pytest.approx(second.v[0], abs=INTEGRATED)
    assert fell.after["B"] == pytest.approx(second.v[1], abs=INTEGRATED)
    assert finished.v == (0.0, 0.0)
    assert finished.ledger.works["friction"] == pytest.approx(-0.06, rel=1e-12)


METHODS = [
    (MethodChoice("euler", step=1e-4), 1e-3), (MethodChoice("semi-implicit", step=1e-4), 1e-3),
    (MethodChoice("verlet", step=1e-4), 1e-4), (MethodChoice("rk4", step=1e-4), 1e-4),
    (MethodChoice("rk4-events", step=1e-3), 1e-9), (MethodChoice("adaptive", rtol=1e-11), 1e-9),
    (MethodChoice("rk45", rtol=1e-11), 1e-9),
]  # fmt: skip


@pytest.mark.parametrize(("choice", "near"), METHODS, ids=lambda w: getattr(w, "method", ""))
@pytest.mark.parametrize(
    "name", ["moving", "a third one touches", "two springs", "the wall is reached"]
)
def test_every_stepping_method_comes_to_the_same_end(
    choice: MethodChoice, near: float, name: str
) -> None:
    plain = plain_of(ROWS[name], 0.6)
    plain["effects"] = [
        {"release": entry["release"] | {"at": 0.1}} if "release" in entry else entry
        for entry in plain["effects"]
    ]
    exact = done(plain)
    steps = stepped(exact.scene, choice)
    assert list(steps.run.x) == pytest.approx(list(exact.x), abs=near)
    assert list(steps.run.v) == pytest.approx(list(exact.v), abs=20 * near)
    assert abs(steps.lost_energy) < 20 * near
    for kind in ("release", "separate"):
        told = {
            e.bodies: (e.t, e.impulse)
            for run_ in (exact, steps.run) for e in run_.record.events
            if e.kind == kind and not (kind == "separate" and e.force)
        }  # fmt: skip
        ours = {
            e.bodies: (e.t, e.impulse) for e in exact.record.events
            if e.kind == kind and not (kind == "separate" and e.force)
        }  # fmt: skip
        assert told.keys() == ours.keys()
        for bodies, (t, impulse) in told.items():
            assert t == pytest.approx(ours[bodies][0], abs=max(3e-4, near))
            assert impulse == pytest.approx(ours[bodies][1], abs=20 * near)
