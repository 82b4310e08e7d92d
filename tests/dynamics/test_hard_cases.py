"""Cases that break step-by-step engines; each has an expected value and an argued tolerance."""

from __future__ import annotations

import math
import random

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene
from tests import registry
from tests.dynamics.given.box_of_two import box_of_two
from tests.dynamics.given.pi_billiard import pi_billiard
from tests.dynamics.given.rows_of_carts import row

COUNTED = {"keep_events": False, "keep_motion": False}


@pytest.mark.parametrize(("digits", "count"), [(0, 3), (1, 31), (2, 314), (3, 3141), (4, 31415)])
def test_hard_collisions_count_the_digits_of_pi(digits, count):
    """Galperin: exact count, ceil(pi / atan(10^-n)) − 1."""
    finished = run(read_scene(pi_billiard(digits)), **COUNTED)
    assert finished.record.counts["contact"] == count


@pytest.mark.parametrize(
    ("digits", "stiffness", "count"), [(1, 1e5, 31), (2, 1e10, 314), (3, 1e14, 3141)]
)
def test_soft_bumpers_count_the_same_once_contacts_do_not_meet(digits, stiffness, count):
    """k > pi² (M/m)² m V² / x0²: then no two contacts overlap in time."""
    finished = run(read_scene(pi_billiard(digits, stiffness)), **COUNTED)
    assert finished.record.counts["contact"] == count


@pytest.mark.parametrize(
    ("stiffness", "count"), [(1, 2), (10, 4), (100, 8), (1e3, 17), (1e4, 31), (1e5, 31)]
)
def test_softer_bumpers_count_fewer(stiffness, count):
    """Contacts that overlap in time, against a 40-digit event solver."""
    finished = run(read_scene(pi_billiard(1, stiffness)), **COUNTED)
    assert finished.record.counts["separate"] == count


def test_fifty_equal_carts_in_a_box_pass_through_each_other():
    """Jepsen: equal elastic carts only exchange their names, so their lines go straight on."""
    dice, n, room = random.Random(2), 50, 4.0
    x = sorted(round(dice.uniform(0, room), 6) for _ in range(n))
    v = [round(dice.uniform(-1, 1), 6) for _ in range(n)]
    carts = {
        f"c{k}": {"mass": 1, "position": repr(x[k]), "velocity": repr(v[k]), "length": 0}
        for k in range(n)
    }
    track = {"left": "wall", "right": "wall", "length": room}
    until = 20.0
    plain = {"carts": carts, "track": track, "contact": {"law": "instant"}, "until": until}
    finished = run(read_scene(plain), **COUNTED)
    lines = []
    for start, speed in zip(x, v, strict=True):
        unfolded = (start + speed * until) % (2 * room)
        lines.append(min(unfolded, 2 * room - unfolded))
    assert finished.record.counts["contact"] > 4000
    assert list(finished.x) == pytest.approx(sorted(lines), abs=1e-11)  # 1e4 additions of 1e-16


def test_a_hundred_thousand_elastic_collisions_keep_the_energy():
    finished = run(read_scene(box_of_two(60_000)), **COUNTED)
    assert finished.record.counts["contact"] > 100_000
    ledger = finished.ledger
    assert ledger.energy_final == pytest.approx(ledger.energy_initial, rel=1e-11)


@pytest.mark.parametrize("offset", [10**9, 10**12])
def test_a_collision_far_from_the_origin_is_as_exact_as_at_home(offset):
    """Gaps are the state: velocities are equal to the last bit, positions to the last of x."""
    near = registry.two_carts(restitution="0.8")
    far = {**near, "carts": {
        name: cart | {"position": f"{offset}" if name == "A" else f"{offset}.8"}
        for name, cart in near["carts"].items()
    }}  # fmt: skip
    one, two = run(read_scene(near)), run(read_scene(far))
    assert one.v == two.v
    for a, b in zip(one.x, two.x, strict=True):
        assert b - offset == pytest.approx(a, abs=2 * math.ulp(offset))


@pytest.mark.parametrize("law", ["bumper", "paper", "push-only"])
def test_a_contact_of_a_microsecond_in_a_slow_flight_costs_no_more(law):
    """v' = (−0.8, 0.4) times the speed; the number of solver calls does not depend on k."""
    speed = 1e-9
    plain = registry.two_carts(
        velocities=(speed, -speed / 2), gap="1e-9", law=law, restitution="0.8", stiffness=1e13,
        until=100,
    )  # fmt: skip
    finished = run(read_scene(plain))
    assert list(finished.v) == pytest.approx([-0.8 * speed, 0.4 * speed], rel=1e-15)
    assert sum(finished.solvers.values()) == 3


def test_a_grazing_contact_keeps_the_figures_of_its_tiny_approach_speed():
    """1 + 1e-12 against 1: the approach speed is that of the decimals, not of two floats."""
    plain = registry.two_carts(
        masses=(1, 1), velocities=("1.000000000001", 1), gap=0, law="paper", restitution="0.5",
        stiffness=1e6,
    )  # fmt: skip
    (_, _, separate, _) = run(read_scene(plain)).record.events
    assert separate.impulse == pytest.approx(0.5 * 1.5 * 1e-12, rel=1e-14)


@pytest.mark.parametrize("e", ["1e-3", "1e-6", "1e-12"])
def test_hardly_any_restitution_is_still_delivered(e):
    plain = registry.two_carts(
        masses=(1, 1), velocities=(1, -1), law="paper", restitution=e, until=5
    )
    finished = run(read_scene(plain))
    assert finished.v[1] - finished.v[0] == pytest.approx(2 * float(e), rel=1e-15 / float(e))


def test_a_cart_bouncing_ever_lower_between_walls_comes_to_an_end():
    """Restitution 0.5 between walls: the flights double each time, finitely many in any time."""
    finished = run(registry.scene("off-the-wall"))
    assert finished.record.counts["contact"] == 2


def test_three_carts_below_the_critical_restitution_collapse_onto_each_other():
    """McNamara & Young: below 7 − 4 sqrt 3 infinitely many hits in finite time; never a hang."""
    plain = row([1, 0, -1], gap=0.1, law="instant") | {
        "contact": {"law": "instant", "restitution": "0.05"}
    }
    finished = run(read_scene(plain), max_events=20_000)
    assert finished.outcome.kind in ("reached-end", "came-to-rest", "too-many-events")
    assert math.fsum(finished.v) == pytest.approx(0.0, abs=1e-15)


def test_a_touching_chain_of_fifty_is_not_disturbed_by_rounding_at_its_far_end():
    """Disturbances of 1e-80 N run ahead of the push; 0.708872 is what the last cart leaves with."""
    finished = run(read_scene(row([1] + [0] * 49)), **COUNTED)
    assert finished.v[-1] == pytest.approx(0.708872, abs=1e-6)
    assert finished.v[0] == pytest.approx(-0.132279487, abs=1e-9)
    assert finished.ledger.energy_final == pytest.approx(0.5, rel=4e-16 * 50)


def test_nothing_happens_to_carts_at_equal_velocity_that_touch():
    finished = run(read_scene(row([0.3, 0.3, 0.3])))
    assert finished.v == (0.3, 0.3, 0.3)
    assert [event.kind for event in finished.record.events] == ["end"]


@pytest.mark.parametrize("e", [0, "0.02", "0.05"])
def test_impacts_that_never_end_at_one_instant_come_to_an_end(e):
    """Two carts and a wall: ever slower impacts at one time, until nothing of a float is left."""
    plain = registry.two_carts(velocities=(1, "-0.3"), gap="0.2", law="instant", restitution=e)
    plain |= {"track": {"right": "wall", "length": "0.8"}, "until": 5}
    finished = run(read_scene(plain))
    assert finished.outcome.kind == "came-to-rest"
    assert finished.v == (0.0, 0.0)
    assert finished.record.counts["contact"] < 200
