"""Rows that rattle: each phase in closed form, beside forty digits, and beside the series."""

from __future__ import annotations

from random import Random
from typing import Any

import mpmath
import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.motion.modes import falls
from sim.dynamics.motion.modes.falls import first_fall
from sim.dynamics.motion.modes.rattle import phase
from sim.dynamics.motion.modes.started import Started, grown, shape_of, swinging, swung
from sim.dynamics.motion.power_series.series import SettledRow
from sim.dynamics.motion.rows import choose
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.touching import Touching
from sim.laws.branch import LOCKED, Branch
from sim.laws.bumper.law import Bumper
from sim.scene import read_scene
from sim.scene.model import Contact
from tests.fuzz.units import scaled

CLOSE = 1e-13
"""Of the size of a quantity: a phase of 32 radians loses five bits."""


@pytest.mark.parametrize("x", [1e-9, 0.05, 0.07, 0.6, 0.99, 1.01, 3.1, 20.0])
@pytest.mark.parametrize("turn", [1j, -1 + 0j, -0.6 + 0.8j])
def test_what_a_mode_grows_to_is_right_in_sixty_digits(x: float, turn: complex) -> None:
    z, t = 37.0 * turn, x / 37.0
    with mpmath.workdps(60):
        exact, power = mpmath.mpc(z), mpmath.exp(mpmath.mpc(z) * t)
        y = exact * t
        expected = [(power - 1) / exact, (power - 1 - y) / exact**2]
        expected.append((power - 1 - y - y * y / 2) / exact**3)
        for got, want in zip((one for (one,) in grown((z,), t)), expected, strict=True):
            assert abs(got - want) <= 1e-15 * (1.0 + x) * abs(want)


@pytest.mark.parametrize("x", [1e-9, 0.05, 0.07, 0.6, 0.99, 1.01, 3.1, 20.0])
def test_what_a_search_asks_of_a_swing_is_what_it_has_grown_to(x: float) -> None:
    """With real numbers alone, and to the last bit where no other function tells it."""
    w, b = 37.0, 0.3 - 0.8j
    t = x / w
    one, two, _ = (one for (one,) in grown((complex(0.0, w),), t))
    got = swung(b, w, t)
    for here, there in zip(got, ((b * two).real, (b * one).real), strict=True):
        assert here == there if x <= 1.0 else abs(here - there) <= 1e-15 * (abs(there) + t)


def test_that_a_bumper_springs_back_is_known_without_a_look(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """From its greatest overlap cos(w t) is not pressed further in less than half a swing."""

    def look(*_given: object) -> tuple[float, float]:
        raise AssertionError

    w = 7.0
    rates = (complex(0.0, w),)
    q = Started(1.0, 0.0, -w * w, shape_of((complex(-w * w),), rates))
    monkeypatch.setattr(falls, "look", look)
    assert first_fall(q, swinging(rates, (1.0 + 0j,)), 2.9 / w, -1.0, 1.0 + 2e-15) is None


def random_row(seed: int) -> tuple[list[Body], list[Gap], SettledRow]:
    """Three to five bodies, some between walls, springs over powers of ten, some locked."""
    dice = Random(seed)
    count = dice.randint(3, 5)
    masses = [10 ** dice.uniform(-1, 1) for _ in range(count)]
    if dice.random() < 0.5:
        masses[0] = float("inf")
    bodies = [
        Body((k,) if m < float("inf") else (), m, float(k), 0.0, k, k + 1)
        for k, m in enumerate(masses)
    ]
    branches, gaps, rates = [], [], []
    for k in range(count - 1):
        kind = dice.choice(["spring", "spring", "damped", "locked"]) if k else "spring"
        kappa = 10 ** dice.uniform(1, 6)
        branch = Branch(kappa, 0.1 * kappa**0.5 if kind == "damped" else 0.0, 1e-4)
        branches.append(LOCKED if kind == "locked" else branch)
        rates.append(0.0 if kind == "locked" else dice.uniform(-0.01, 0.01))
        law = Bumper(kappa, 0.0 if kind == "locked" else 1.0)
        over = dice.uniform(2e-3, 4e-3)
        gap = Gap(
            k,
            bodies[k],
            bodies[k + 1],
            -over,
            -rates[-1],
            Contact(law="bumper", restitution=1.0, stiffness=kappa),
            law,
        )
        gap.memory, gap.touching = over, Touching((0.0, 0.0), (0.0, 0.0))
        gaps.append(gap)
    for k, body in enumerate(bodies[1:]):  # rates are differences of velocities
        body.v = bodies[k].v - rates[k]
    row = SettledRow(
        inverse=[0.0 if m == float("inf") else 1 / m for m in masses],
        speeds=[b.v for b in bodies],
        overlaps=[-g.room for g in gaps],
        rates=rates,
        branches=branches,
        links=[() for _ in gaps],
        steady=[0.0 if m == float("inf") else dice.choice([0.0, -0.3, m]) for m in masses],
        linear=[0.0] * count,
        quadratic=[0.0] * count,
    )
    return bodies, gaps, row


def exactly(row: SettledRow, t: float) -> tuple[list[Any], list[Any], list[Any]]:
    """Ways, velocities and overlaps at t: the exponential of the matrix of all first derivatives.

    Locked contacts are springs without one: their bodies are one body.
    """
    n = len(row.speeds)
    block = [0]
    for branch in row.branches:
        block.append(block[-1] if branch.locked else block[-1] + 1)
    size = block[-1] + 1
    mass = [
        mpmath.mpf(0) if any(row.inverse[i] == 0.0 for i in range(n) if block[i] == b) else
        mpmath.fsum(1 / mpmath.mpf(row.inverse[i]) for i in range(n) if block[i] == b)
        for b in range(size)
    ]  # fmt: skip
    whole = mpmath.zeros(2 * size + 1)
    state = mpmath.zeros(2 * size + 1, 1)
    state[2 * size] = 1
    for b in range(size):
        whole[b, size + b] = 1
        state[size + b] = row.speeds[block.index(b)]
    for i in range(n):
        if mass[block[i]]:
            whole[size + block[i], 2 * size] += mpmath.mpf(row.steady[i]) / mass[block[i]]
    for k, branch in enumerate(row.branches):
        if branch.locked:
            continue
        a, b = block[k], block[k + 1]
        for one, sign in ((a, -1), (b, 1)):
            if mass[one]:
                here, part = size + one, sign / mass[one]
                pressed = mpmath.mpf(row.overlaps[k]) - mpmath.mpf(branch.rest)
                whole[here, 2 * size] += part * branch.kappa * pressed
                whole[here, a] += part * branch.kappa
                whole[here, b] -= part * branch.kappa
                whole[here, size + a] += part * branch.gamma
                whole[here, size + b] -= part * branch.gamma
    then = mpmath.expm(whole * mpmath.mpf(t)) * state
    ways = [then[block[i]] for i in range(n)]
    speeds = [then[size + block[i]] for i in range(n)]
    over = [o + ways[k] - ways[k + 1] for k, o in enumerate(row.overlaps)]
    return ways, speeds, over


@pytest.mark.parametrize("seed", [0, 1, 2, 4, 5, 6, 8, 11, 13, 15, 16, 18])
def test_a_phase_is_the_exponential_of_its_matrix(seed: int) -> None:
    bodies, gaps, row = random_row(seed)
    found = phase(bodies, gaps, row, 10.0)
    assert found is not None
    told, _, duration = found
    with mpmath.workdps(40):
        for part in (1e-6, 0.3, 1.0):
            t = part * duration
            ways, speeds, over = exactly(row, t)
            fastest = max(*map(abs, row.speeds), *map(abs, speeds))
            for i in range(len(bodies)):
                assert abs(told.velocity(i, t) - speeds[i]) <= CLOSE * fastest
                assert abs(told.displacement(i, t) - ways[i]) <= CLOSE * max(
                    fastest * t, *map(abs, ways)
                )
            for k in range(len(gaps)):
                assert abs(told.overlap(k, t)[0] - over[k]) <= CLOSE * max(row.overlaps)


def test_the_first_fall_of_a_swing_is_where_its_formula_says() -> None:
    w = 300.0
    rates = (complex(0.0, w),)
    modes = swinging(rates, (1.0 + 0j,))
    q = Started(1.0, 0.0, -w * w, shape_of((complex(-w * w),), rates))  # cos(w t)
    with mpmath.workdps(30):
        assert first_fall(q, modes, 1.0) == pytest.approx(float(mpmath.pi / (2 * w)), rel=4e-16)


HOPS_ON_A_DEAD_ONE = {
    "carts": {
        "A": {"mass": 2.2, "position": 0.1, "velocity": 1},
        "B": {"mass": 1, "position": 0.3, "velocity": 0.5},
    },
    "track": {"left": "open", "right": "wall", "length": 0.5479},
    "contact": {
        "law": "bumper",
        "pairs": {
            "A-B": {"restitution": 0.01, "stiffness": 5800},
            "B-right": {"restitution": 0, "stiffness": 12700},
        },
    },
    "effects": [{"incline": {"angle": "5 deg"}}],
    "until": 1,
}
BETWEEN_TWO_THAT_PRESS = {
    "carts": {
        "A": {"mass": 0.0181, "position": 0.1, "velocity": 0.5},
        "B": {"mass": 1680, "position": 0.4, "velocity": -1},
    },
    "track": {"left": "wall", "right": "open", "length": 1.1},
    "contact": {"law": "bumper", "restitution": 0, "stiffness": 1380},
    "until": 0.5,
}


@pytest.mark.parametrize("plain", [HOPS_ON_A_DEAD_ONE, BETWEEN_TWO_THAT_PRESS])
def test_a_rattle_ends_where_the_series_ends(
    plain: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    scene = read_scene(plain)
    monkeypatch.setattr(choose, "OFTEN", 10)
    phases = run(scene)
    monkeypatch.setattr(choose, "OFTEN", 10**9)
    series = run(scene)
    assert phases.solvers["power-series"] < 0.4 * series.solvers["power-series"]
    assert phases.record.counts == series.record.counts
    assert phases.x == pytest.approx(series.x, rel=1e-11)
    assert phases.v == pytest.approx(series.v, rel=1e-9, abs=1e-11)
    assert phases.ledger.imbalance() < 1e-12


@pytest.mark.parametrize("plain", [HOPS_ON_A_DEAD_ONE, BETWEEN_TWO_THAT_PRESS])
def test_a_rattle_in_other_units_is_the_same_rattle(
    plain: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(choose, "OFTEN", 10)
    m, length, s = 2.0**-10, 2.0**20, 2.0**10
    here, there = run(read_scene(plain)), run(read_scene(scaled(plain, m, length, s)))
    assert tuple(v * length / s for v in here.v) == there.v
