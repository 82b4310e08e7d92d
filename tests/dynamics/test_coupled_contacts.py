"""Contacts that share carts: tables, an independent integration, and conservation."""

from __future__ import annotations

import math

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample, trajectory
from sim.scene import read_scene
from tests.dynamics.given.rows_of_carts import row, scenes
from tests.reference import many_contacts

TABLE = 1e-9
"""m/s. The tables are printed to nine decimals."""


# Carts on linear springs, touching, the first one with 1 m/s.
CRADLES = [
    (-0.130261695, 0.150229569, 0.980032126),
    (-0.132275275, -0.064974765, 0.236977608, 0.960272432),
    (-0.132279485, -0.075329170, -0.031010829, 0.296217750, 0.942401733),
]


@pytest.mark.parametrize("law", ["paper", "bumper", "push-only"])
@pytest.mark.parametrize("expected", CRADLES)
def test_a_cradle_of_linear_springs_breaks_up_as_tabulated(expected, law):
    finished = run(read_scene(row([1] + [0] * (len(expected) - 1), law=law)))
    assert list(finished.v) == pytest.approx(list(expected), abs=TABLE)


@pytest.mark.parametrize(
    ("e", "expected"), [(0.8, 0.854201911781), (0.5, 0.616146253566), (1, 1.0)]
)
def test_two_carts_that_meet_in_a_third_see_a_fixed_wall(e, expected):
    finished = run(read_scene(row([1, 0, -1], gap=0.3, e=e)))
    assert list(finished.v) == pytest.approx([-expected, 0.0, expected], abs=1e-12)


@pytest.mark.parametrize("e", [0.9, 0.5, 0.05])
def test_the_bumper_law_delivers_its_e_in_a_symmetric_triple_hit_too(e):
    finished = run(read_scene(row([1, 0, -1], gap=0.3, law="bumper", e=e)))
    assert list(finished.v) == pytest.approx([-e, 0.0, e], abs=1e-15)


def test_carts_far_enough_apart_hand_the_motion_on_as_instant_impacts_do():
    k = 500.0
    apart = 1.1200 / math.sqrt(
        k
    )  # gap sqrt(k/m)/u >= pi / (2 sqrt 2) = 1.1107: contacts never meet
    finished = run(read_scene(row([1, 0, 0, 0], gap=apart, k=k)))
    assert list(finished.v) == pytest.approx([0, 0, 0, 1], abs=1e-15)


@pytest.mark.parametrize("plain", list(scenes(12, 5)))
def test_random_rows_between_walls_agree_with_integration(plain):
    finished = run(read_scene(plain))
    carts = finished.scene.carts
    x, v = many_contacts.integrate(
        [c.mass for c in carts],
        [c.position for c in carts],
        [c.velocity for c in carts],
        e=float(plain["contact"]["restitution"]),
        k=plain["contact"]["stiffness"],
        until=0.6,
        left=0.0,
        right=float(plain["track"]["length"]),
    )
    assert list(finished.v) == pytest.approx(list(v), abs=1e-7)  # a few contacts amplify 1e-11
    assert list(finished.x) == pytest.approx(list(x), abs=1e-8)


@pytest.mark.parametrize("law", ["bumper", "paper", "push-only"])
@pytest.mark.parametrize("plain", list(scenes(8, 11)))
def test_energy_and_momentum_are_accounted_for_whoever_touches(plain, law):
    contact = plain["contact"] | {"law": law}
    finished = run(read_scene(plain | {"contact": contact, "until": 2}))
    ledger = finished.ledger
    assert ledger.energy_final + ledger.warmed == pytest.approx(ledger.energy_initial, rel=1e-12)
    change = ledger.momentum_final - ledger.momentum_initial
    assert change == pytest.approx(ledger.external, abs=1e-12)
    assert finished.outcome.kind == "reached-end"


@pytest.mark.parametrize("law", ["bumper", "paper"])
def test_the_drawn_motion_has_no_breaks(law):
    finished = run(read_scene(row([1, 0, 0], law=law, e=0.7, until=1)))
    columns = trajectory(finished).columns
    t = columns[("t",)]
    for cart in ("C0", "C1", "C2"):
        x, v = columns[("x", cart)], columns[("v", cart)]
        for k in range(len(t) - 1):
            h = t[k + 1] - t[k]
            mean = 0.5 * (v[k] + v[k + 1])
            assert x[k + 1] - x[k] == pytest.approx(mean * h, abs=2e-5)
    x, v = sample(finished, 1.0)
    assert list(finished.x) == pytest.approx(x, abs=1e-14)
    assert list(finished.v) == pytest.approx(v, abs=1e-14)


def test_a_touching_chain_keeps_its_energy_to_rounding():
    finished = run(read_scene(row([1] + [0] * 19)))
    ledger = finished.ledger
    assert ledger.energy_final == pytest.approx(0.5, rel=1e-14)
    assert math.fsum(finished.v) == pytest.approx(1.0, rel=1e-14)
    assert finished.v[0] < 0 < finished.v[-1] < 1


@pytest.mark.parametrize("boost", [0.5, -3.0])
def test_a_cradle_looks_the_same_from_a_moving_train(boost):
    rest = run(read_scene(row([1, 0, 0, 0])))
    train = run(read_scene(row([1 + boost, boost, boost, boost])))
    assert [v - boost for v in train.v] == pytest.approx(list(rest.v), abs=1e-13)


def test_without_restitution_three_carts_end_up_together():
    finished = run(read_scene(row([1, 0, 0], gap=0.1, e=0, law="bumper")))
    assert list(finished.v) == pytest.approx([1 / 3] * 3, abs=1e-9)


def test_a_gap_between_two_contacts_is_asked_with_the_speed_of_now():
    """A case that once broke: found by random scenes, energy rose by 1e-5."""
    plain = row([1, 0, 1, 0], masses=[1, 1, 1, 2], law="bumper", k=5000, until=0.05)
    plain["carts"]["C3"]["position"] = "1.101"
    ledger = run(read_scene(plain)).ledger
    assert ledger.energy_final == pytest.approx(1.0, rel=1e-13)
    assert ledger.warmed == pytest.approx(0.0, abs=1e-15)
