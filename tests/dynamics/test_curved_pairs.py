"""Two spheres alone: the closed form beside quadrature, Gamma functions and an integration."""

from __future__ import annotations

import math
from typing import Any

import mpmath
import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample
from sim.laws.hertz.law import Hertz
from sim.scene import read_scene
from tests.reference.effects import integrate

RESTITUTIONS = (1.0, 0.8, 0.3, 0.05, 1e-6)
K, MU, U = 5000.0, 0.7, 0.4


def two(e: float, **more: Any) -> dict[str, Any]:
    return {
        "carts": {
            "A": {"mass": 1.5, "position": 0.1, "velocity": 0.8},
            "B": {"mass": 0.4, "position": 0.4, "velocity": -0.3},
        },
        "contact": {"law": "hertz", "stiffness": 4000, "restitution": e},
        "until": 1.0,
    } | more


def test_an_elastic_contact_lasts_and_is_as_deep_as_gamma_functions_say() -> None:
    contact = Hertz(K, 1.0).alone(MU, 0.0, U)
    assert contact is not None
    deepest = (5.0 * MU * U**2 / (4.0 * K)) ** 0.4
    lasts = 2.0 * math.sqrt(math.pi) * math.gamma(1.4) / math.gamma(0.9) * deepest / U
    assert contact.duration == pytest.approx(lasts, rel=2e-15)
    assert contact.deepest() == pytest.approx((0.5 * lasts, deepest), rel=2e-15)


@pytest.mark.parametrize("e", [*RESTITUTIONS, 0.0])
def test_the_time_to_every_phase_is_the_integral_over_the_rate_of_the_overlap(e: float) -> None:
    """t = integral of y^(−1/5) ds, by quadrature with 30 digits over the elementary y(s)."""
    mpmath.mp.dps = 30
    contact = Hertz(K, e).alone(MU, 0.0, U)
    assert contact is not None
    w = mpmath.sqrt(mpmath.mpf(5) * K / (4 * MU))
    loss = -mpmath.log(e) if e else mpmath.mpf(0)
    zeta = loss / mpmath.sqrt(mpmath.pi**2 + loss**2) if e else mpmath.mpf(1)
    wd = w * mpmath.sqrt(1 - zeta**2)

    def y(s: Any) -> Any:
        swing = mpmath.sin(wd * s) / wd if e else s
        return mpmath.mpf(1.25) * U * mpmath.exp(-zeta * w * s) * swing

    end = mpmath.pi / wd if e else 12 / w
    for part in (0.01, 0.3, 0.6, 0.95):
        s = part * end
        marks = [0, s / 1000, s / 30, s / 2, s]
        t = float(mpmath.quad(lambda one: y(one) ** mpmath.mpf(-0.2), marks))
        d = contact.at(t)[0]
        assert d == pytest.approx(float(y(s) ** mpmath.mpf(0.8)), rel=2e-14)


@pytest.mark.parametrize("e", RESTITUTIONS)
def test_a_pair_of_spheres_returns_the_restitution_asked_for_to_the_last_bit(e: float) -> None:
    done = run(read_scene(two(e, until=30.0)))  # with e = 1e-6 it lasts for seconds
    assert done.solvers["pair-contact"] == 1
    assert done.solvers["adaptive"] == 0
    assert done.v[1] - done.v[0] == pytest.approx(e * 1.1, abs=4e-16)
    assert done.ledger.imbalance() < 1e-15


@pytest.mark.parametrize("e", [1.0, 0.6, 0.0])
@pytest.mark.parametrize("start", ["touch", "overlap, coming", "overlap, going"])
def test_a_pair_of_spheres_moves_as_the_integration_does(e: float, start: str) -> None:
    plain = two(e, until=0.35)
    if start != "touch":
        plain["start"] = {"overlap": True}
        plain["carts"]["B"]["position"] = 0.295
        plain["carts"]["B"]["velocity"] = 1.0 if start == "overlap, going" else -0.3
    scene = read_scene(plain)
    done, expected = run(scene), integrate(scene)
    assert done.v == pytest.approx(expected.v, abs=1e-10)
    assert done.x == pytest.approx(expected.x, abs=1e-10)
    assert done.ledger.imbalance() < 1e-14


@pytest.mark.parametrize("e", [1.0, 0.5])
def test_a_sphere_at_a_wall_goes_on_in_closed_form_after_a_third_one_left(e: float) -> None:
    plain = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.1},
            "B": {"mass": 0.2, "position": 0.3002, "velocity": -1.0},
        },
        "track": {"left": "wall", "right": "open", "length": 2},
        "contact": {"law": "hertz", "stiffness": 4000, "restitution": e},
        "until": 0.3,
    }
    scene = read_scene(plain)
    done, expected = run(scene), integrate(scene)
    assert done.solvers["power-series"] > 0
    assert done.solvers["pair-contact"] > 0
    assert done.v == pytest.approx(expected.v, abs=1e-9)
    assert done.x == pytest.approx(expected.x, abs=1e-9)


@pytest.mark.parametrize("e", [1.0, 0.4, 0.0])
def test_velocities_in_a_contact_of_spheres_are_the_slopes_of_the_places(e: float) -> None:
    done = run(read_scene(two(e)))
    touch, h = 0.1 / 1.1, 1e-6
    for late in (0.003, 0.02, 0.031):
        t = touch + late
        before, after = sample(done, t - h), sample(done, t + h)
        slopes = [(b - a) / (2.0 * h) for a, b in zip(before[0], after[0], strict=True)]
        assert sample(done, t)[1] == pytest.approx(slopes, abs=1e-7)


@pytest.mark.parametrize("e", [0.9, 0.2, 0.0])
def test_the_greatest_force_of_spheres_is_not_exceeded_and_is_bounded(e: float) -> None:
    contact = Hertz(K, e).alone(MU, 0.0, U)
    assert contact is not None
    span = min(contact.duration, 1.0)
    forces = [contact.force(*contact.at(span * k / 400))[0] for k in range(401)]
    top = contact.force(*contact.at(contact.greatest_force()))[0]
    assert max(forces) <= top * (1.0 + 1e-14)
    assert max(forces) > 0.98 * top
    assert max(map(abs, forces)) <= contact.strongest() * (1.0 + 1e-14)
