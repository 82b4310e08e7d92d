"""Rows that swing for long: sums of modes beside fifty digits, formulas, and other units."""

from __future__ import annotations

import cmath
import math
from random import Random
from typing import Any

import mpmath
import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.motion.modes.modal_sum import ModalSum, clear_until, maximum
from sim.dynamics.motion.modes.normal_modes import Segment, modes
from sim.dynamics.result.trajectory import sample
from sim.scene import read_scene
from tests.fuzz.units import scaled
from tests.processor_time import budget


def random_segment(seed: int) -> Segment:
    """Masses and springs over powers of ten, dampers from none to beyond critical."""
    dice = Random(seed)
    count = dice.randint(1, 8)
    masses = [10 ** dice.uniform(-1, 1) for _ in range(count)]
    kappa = [10 ** dice.uniform(0, 6) for _ in range(count + 1)]
    if dice.random() < 0.5 and count > 1:
        kappa[0] = 0.0
    if dice.random() < 0.5 and (count > 1 or kappa[0]):
        kappa[-1] = 0.0
    inverse = [
        (1 / masses[k - 1] if k else 0.0) + (1 / masses[k] if k < count else 0.0)
        for k in range(count + 1)
    ]
    zeta = dice.choice([0.0, 0.07, 0.6, 1.9])
    gamma = [
        2 * zeta * dice.random() * math.sqrt(k / i) for k, i in zip(kappa, inverse, strict=True)
    ]
    drags = [dice.choice([0.0, 0.3]) for _ in masses] if dice.random() < 0.2 else [0.0] * count
    return Segment(tuple(masses), tuple(drags), tuple(kappa), tuple(gamma))


def pencil(row: Segment, z: Any) -> Any:
    """z² M + z C + K."""
    n = len(row.masses)
    whole = mpmath.zeros(n)
    for i in range(n):
        whole[i, i] += mpmath.mpf(row.masses[i]) * z * z + mpmath.mpf(row.drags[i]) * z
    for k, (stiff, damp) in enumerate(zip(row.kappa, row.gamma, strict=True)):
        s = mpmath.mpf(stiff) + mpmath.mpf(damp) * z
        for i in (k - 1, k):
            if 0 <= i < n:
                whole[i, i] += s
        if 0 < k < n:
            whole[k - 1, k] -= s
            whole[k, k - 1] -= s
    return whole


@pytest.mark.parametrize("seed", range(40))
def test_rates_and_shapes_solve_the_equations_of_motion_in_fifty_digits(seed: int) -> None:
    row = random_segment(seed)
    found = modes(row)
    assert found is not None
    damped_or_not = sum(1 if mode.rate.imag == 0 else 2 for mode in found)
    whole = 0 if row.anchored else 1 if any(row.drags) else 2
    assert damped_or_not == 2 * len(row.masses) - whole
    with mpmath.workdps(50):
        for mode in found:
            z = mpmath.mpc(mode.rate)
            better = mpmath.findroot(
                lambda one: mpmath.det(pencil(row, one)), (z, z * (1 + mpmath.mpf("1e-9"))),
                tol=mpmath.mpf("1e-45") * abs(mpmath.det(pencil(row, 2 * z))), verify=False,
            )  # fmt: skip
            others = [one.rate for one in found if one is not mode]
            others += [mode.rate.conjugate()] if mode.rate.imag else []
            apart = min((abs(other - mode.rate) for other in others), default=abs(mode.rate))
            close = max(1.0, abs(mode.rate) / apart)
            assert abs(better - z) <= 2e-14 * close * abs(z)


TWO_BETWEEN_WALLS: dict[str, Any] = {
    "carts": {
        "A": {"mass": 1, "position": 0.6, "velocity": 0.3},
        "B": {"mass": 1, "position": 1.4},
    },
    "track": {"left": "wall", "right": "wall", "length": 2},
    "contact": {"law": "bumper", "stiffness": 500},
    "effects": [
        {"spring": {"between": ["left", "A"], "stiffness": 20, "length": 0.5}},
        {"spring": {"between": ["A", "B"], "stiffness": 3, "length": 0.6}},
        {"spring": {"between": ["B", "right"], "stiffness": 20, "length": 0.5}},
    ],
    "until": 600,
}


def test_two_between_springs_beat_as_the_sum_of_their_two_modes_for_ten_minutes() -> None:
    """Together they swing with sqrt(k/m), against each other with sqrt((k + 2 c)/m)."""
    done = run(read_scene(TWO_BETWEEN_WALLS))
    slow, fast = math.sqrt(20), math.sqrt(26)
    for t in (0.5, 7.25, 199.0, 600.0):
        _, v = sample(done, t)
        together, against = 0.15 * math.cos(slow * t), 0.15 * math.cos(fast * t)
        assert v == pytest.approx([together + against, together - against], abs=1e-12)
    assert done.ledger.imbalance() < 1e-13


def test_what_a_run_of_modes_costs_does_not_grow_with_its_length() -> None:
    short = run(read_scene(TWO_BETWEEN_WALLS | {"until": 60}))
    long = run(read_scene(TWO_BETWEEN_WALLS | {"until": 100_000}))
    assert long.solvers["power-series"] <= short.solvers["power-series"] + 2
    assert long.solvers["modes"] <= 2


def row_on_a_slope(law: str, e: float, until: float = 3) -> dict[str, Any]:
    return {
        "carts": {
            name: {"mass": mass, "position": round(0.1 + 0.2 * k, 6), "velocity": v}
            for k, (name, mass, v) in enumerate([("A", 1, 0), ("B", 2.5, 0), ("C", 0.7, -0.1)])
        },
        "track": {"left": "wall", "length": 2},
        "contact": {
            "law": law,
            "restitution": e,
            "stiffness": 300,
            "pairs": {"A-B": {"law": law, "restitution": e, "stiffness": 20000}},
        },
        "effects": [{"incline": {"angle": "-5 deg"}}],
        "until": until,
    }


@pytest.mark.parametrize("e", [1, 0.8, 0.3, 0.05])
@pytest.mark.parametrize("law", ["paper", "push-only", "bumper"])
def test_in_units_that_are_powers_of_two_modes_give_the_same_to_the_last_bit(
    law: str, e: float
) -> None:
    plain = row_on_a_slope(law, e)
    m, length, s = 2.0**7, 2.0**-9, 2.0**5
    one = run(read_scene(plain))
    two = run(read_scene(scaled(plain | {"gravity": 9.81}, m, length, s)))
    assert two.solvers == one.solvers
    assert two.v == tuple(v * length / s for v in one.v)
    assert two.ledger.warmed == one.ledger.warmed * m * length**2 / s**2


@pytest.mark.parametrize("law", ["paper", "push-only"])
def test_a_row_that_has_swung_into_rest_lies_there_exactly(law: str) -> None:
    done = run(read_scene(row_on_a_slope(law, 0.3, until=600)))
    assert done.solvers["modes"] >= 1
    assert done.v == (0.0, 0.0, 0.0)
    weights = [9.81 * m * math.sin(math.radians(5)) for m in (1, 2.5, 0.7)]
    assert done.ledger.impulses["walls"] == pytest.approx(600 * sum(weights), rel=1e-3)
    assert done.ledger.imbalance() < 1e-13
    assert done.x[0] == pytest.approx(0.1 - sum(weights) / 300, abs=1e-15)
    assert done.x[1] - done.x[0] == pytest.approx(0.2 - sum(weights[1:]) / 20000, abs=1e-15)


FADING = ModalSum(0.2, ((complex(-0.3, 5.0), 1 - 0.2j), (complex(-40.0), 0.5 + 0j)))


def test_a_time_that_is_clear_of_zeros_ends_just_before_the_first_one() -> None:
    least = 1e-9
    clear = clear_until(FADING, 10.0, least, 1000)
    times = [clear * k / 10_000 for k in range(10_001)]
    assert all(FADING.value(t) > 0.0 for t in times)
    assert FADING.value(clear + 10 * least) < 1e-7
    assert clear_until(ModalSum(5.0, FADING.terms), 10.0, least, 1000) == 10.0


def test_the_greatest_value_is_found_among_many_swings() -> None:
    low = ModalSum(0.0, ((complex(0, 7.0), 1j), (complex(0, 7.3), 0.9 - 0.1j)))
    when = maximum(low, 60.0, 1e-4, 100_000)
    grid = max(low.value(60.0 * k / 200_000) for k in range(200_001))
    assert low.value(when) == pytest.approx(grid, abs=1e-6)
    assert low.value(when) >= grid - 1e-12


RINGING = (complex(0, 2e5), 0.4 - 0.2j)
SLOW = (complex(0, 3.0), 0.8 + 0.5j)


def test_a_swing_that_rings_on_beside_a_slow_one_takes_no_looks_while_it_cannot_reach_nought() -> (
    None
):
    """A run of ten seconds has 300,000 of its swings."""
    assert clear_until(ModalSum(1.5, (SLOW, RINGING)), 10.0, 1e-5, 60) == 10.0


def test_where_the_slow_one_lets_a_ringing_swing_reach_nought_the_time_that_is_clear_ends() -> None:
    low = ModalSum(1.2, (SLOW, RINGING))
    clear = clear_until(low, 10.0, 1e-6, 3000)
    assert 0.0 < clear < 10.0
    assert all(low.value(clear * k / 20_000) > 0.0 for k in range(20_001))
    slow = ModalSum(1.2 - abs(RINGING[1]), (SLOW,))  # a swing later at most it can reach nought
    assert slow.value(clear + 1e-4) < 1e-3
    assert min(low.value(clear + 1e-7 * k) for k in range(20_000)) < 0.0


def test_the_greatest_value_of_a_ringing_sum_is_found_in_few_looks() -> None:
    q = ModalSum(0.1, (SLOW, RINGING))
    when = maximum(q, 10.0, 1e-5, 3000)
    most = 0.1 + abs(SLOW[1]) + abs(RINGING[1])
    assert most - 1e-6 < q.value(when) <= most


SOON = 5.0
"""s of processor time for a search that takes far less, or never ends."""


def test_a_maximum_is_found_where_the_last_steps_to_it_are_below_the_rounding_of_its_time() -> None:
    """A light cart beside heavy ones: what its fast swing makes a short step is none at 2.7 s."""
    swing = complex(-6.894922164007762e-05, 0.5773502016700788)
    rate = complex(166655.53501377327, 245.77385281990823)
    with budget(SOON):
        when = maximum(ModalSum(0.0, ((swing, rate / swing),)), 3.4, 8.7e-9, 3000)
    assert when == pytest.approx((0.5 * math.pi - cmath.phase(rate)) / swing.imag, rel=1e-12)


def test_integrals_of_a_sum_and_of_its_square_are_those_of_quadrature() -> None:
    with mpmath.workdps(30):
        places = [mpmath.mpf(k) / 4 for k in range(13)]
        plain = mpmath.quad(lambda t: mpmath.mpf(FADING.value(float(t))), places)
        square = mpmath.quad(lambda t: mpmath.mpf(FADING.value(float(t))) ** 2, places)
    assert FADING.integral(3.0) == pytest.approx(float(plain), rel=1e-13)
    assert FADING.square_integral(3.0) == pytest.approx(float(square), rel=1e-13)
