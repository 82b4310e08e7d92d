"""Whole runs: outcomes, symmetries, conservation, events."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import trajectory
from sim.scene import apply_changes, read_scene
from tests import registry

LAWS = ["bumper", "paper", "push-only", "instant"]
IMPACT = 4e-16
"""Relative to the approach speed: two roundings of one unit in the last place."""


def exact_outcome(m1, m2, v1, v2, e):
    """Velocities after an isolated impact in exact rational arithmetic."""
    m1, m2, v1, v2, e = (Fraction(str(value)) for value in (m1, m2, v1, v2, e))
    centre = (m1 * v1 + m2 * v2) / (m1 + m2)
    return centre + e * (centre - v1), centre + e * (centre - v2)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("e", ["1", "0.8", "0.35", "0.01"])
@pytest.mark.parametrize(
    ("masses", "velocities"),
    [
        ((1, 2), ("1", "-0.5")),
        ((1, 1), ("0.8", "0.2")),
        (("0.3", 7), ("2.5", "-1.7")),
        ((5, "0.1"), ("0.9", 0)),
    ],
)
def test_an_impact_has_the_outcome_of_rational_arithmetic(law, e, masses, velocities):
    contact = {"law": law, "restitution": e} | ({} if law == "instant" else {"stiffness": 5e4})
    plain = registry.two_carts(masses=masses, velocities=velocities, gap="0.3", **contact)
    finished = run(read_scene(plain))
    expected = exact_outcome(*masses, *velocities, e)
    scale = abs(float(velocities[0]) - float(velocities[1]))
    for got, want in zip(finished.v, expected, strict=True):
        assert abs(Fraction(got) - want) <= IMPACT * scale


@pytest.mark.parametrize("ratio", [1e9, 1e-9, 1e18])
@pytest.mark.parametrize("law", LAWS)
def test_a_huge_mass_ratio_changes_nothing_in_the_accuracy(law, ratio):
    contact = {"law": law, "restitution": "0.5"} | ({} if law == "instant" else {"stiffness": 1e4})
    finished = run(read_scene(registry.two_carts(masses=(ratio, 1), velocities=(1, 0), **contact)))
    for got, want in zip(finished.v, exact_outcome(ratio, 1, 1, 0, "0.5"), strict=True):
        assert abs(Fraction(got) - want) <= IMPACT


@pytest.mark.parametrize("name", registry.NAMES)
def test_energy_changes_only_by_named_work_and_by_what_warmed_the_bumpers(name):
    finished = run(registry.scene(name))
    ledger = finished.ledger
    parts = [ledger.energy_initial, ledger.energy_final, ledger.warmed, *ledger.works.values()]
    scale = math.fsum(map(abs, parts))
    tolerance = 1e-11 if finished.solvers["adaptive"] else 1e-14  # of the scale, for each event
    before = ledger.energy_initial + math.fsum(ledger.works.values())
    assert before == pytest.approx(ledger.energy_final + ledger.warmed, abs=tolerance * scale)
    assert ledger.warmed >= -1e-14 * scale


@pytest.mark.parametrize("name", registry.NAMES)
def test_momentum_changes_only_by_named_impulses_from_outside(name):
    finished = run(registry.scene(name))
    ledger = finished.ledger
    scale = math.fsum(c.mass * abs(c.velocity) for c in finished.scene.carts)
    scale += math.fsum(map(abs, ledger.impulses.values()))
    change = ledger.momentum_final - ledger.momentum_initial
    assert change == pytest.approx(ledger.external, abs=1e-14 * scale)
    assert ledger.external == pytest.approx(sum(ledger.impulses.values()), abs=1e-14 * scale)


@pytest.mark.parametrize("name", registry.NAMES)
def test_the_area_under_the_drawn_force_is_the_change_of_momentum(name):
    finished = run(registry.scene(name))
    at_once = any(c and c.law in ("instant", "velcro") for c in finished.scene.contacts)
    if at_once or any(effect.kind == "release" for effect in finished.scene.effects):
        return  # an impulse without duration has no area
    columns = trajectory(finished).columns
    t = columns[("t",)]
    for index, cart in enumerate(finished.scene.carts):
        area = 0.0
        for (kind, *whose), force in columns.items():
            if kind == "E" and whose[1] == cart.name:  # an effect's force on one cart
                sign, slope = 1.0, [0.0] * len(t)
            elif kind == "F" and cart.name in (ends := whose[0].split("-")):
                sign, slope = (1.0 if ends[1] == cart.name else -1.0), columns[("dF", whose[0])]
            else:
                continue
            for k in range(len(t) - 1):
                h = t[k + 1] - t[k]
                area += sign * (
                    h * (force[k] + force[k + 1]) / 2 + h * h * (slope[k] - slope[k + 1]) / 12
                )
        change = cart.mass * (finished.v[index] - cart.velocity)
        curved = abs(finished.ledger.impulses.get("drag", 0.0))  # drawn as straight lines
        tolerance = 1e-6 * cart.mass + 1e-7 * abs(change) + 0.02 * curved
        assert area == pytest.approx(change, abs=tolerance)


@pytest.mark.parametrize("boost", ["-3", "0.5", "40"])
@pytest.mark.parametrize("law", LAWS)
def test_impact_looks_the_same_from_a_moving_train(law, boost):
    contact = {"law": law, "restitution": "0.7"}
    plain = registry.two_carts(**contact)
    moving = apply_changes(
        plain,
        {
            "A.velocity": str(Fraction(1) + Fraction(boost)).split("/")[0]
            if "." not in boost
            else str(1 + float(boost)),
            "B.velocity": str(-0.5 + float(boost)),
        },
    )
    rest, train = run(read_scene(plain)), run(read_scene(moving))
    tolerance = 4 * 2.0**-52 * (abs(float(boost)) + 1)
    for a, b in zip(rest.v, train.v, strict=True):
        assert b - float(boost) == pytest.approx(a, abs=tolerance)
    for a, b in zip(rest.x, train.x, strict=True):
        assert b - float(boost) * 1.0 == pytest.approx(a, abs=4 * tolerance)


@pytest.mark.parametrize("law", LAWS)
def test_the_mirror_image_of_a_run_is_the_run_of_the_mirror_image(law):
    contact = {"law": law, "restitution": "0.75"}
    track = {"left": "wall", "right": "wall", "length": 4}
    carts = {
        "A": {"mass": 1, "position": "0.5", "velocity": "0.75"},
        "B": {"mass": 4, "position": "2.25", "velocity": "-0.25"},
    }
    mirrored = {
        "A": {"mass": 1, "position": "3.5", "velocity": "-0.75"},
        "B": {"mass": 4, "position": "1.75", "velocity": "0.25"},
    }
    one = run(read_scene({"carts": carts, "track": track, "contact": contact, "until": 4}))
    two = run(read_scene({"carts": mirrored, "track": track, "contact": contact, "until": 4}))
    assert [-v for v in reversed(two.v)] == pytest.approx(list(one.v), abs=1e-15)
    assert [4 - x for x in reversed(two.x)] == pytest.approx(list(one.x), abs=1e-14)


@pytest.mark.parametrize("law", ["bumper", "paper", "instant"])
def test_an_elastic_run_retraces_itself_when_time_is_reversed(law):
    plain = registry.two_carts(law=law, until=1)
    there = run(read_scene(plain))
    back = run(
        read_scene(
            apply_changes(
                plain,
                {
                    "A.position": there.x[0],
                    "A.velocity": -there.v[0],
                    "B.position": there.x[1],
                    "B.velocity": -there.v[1],
                },
            )
        )
    )
    assert list(back.x) == pytest.approx([0.0, 0.8], abs=1e-14)
    assert list(back.v) == pytest.approx([-1.0, 0.5], abs=1e-15)


@pytest.mark.parametrize("law", ["velcro", "instant"])
def test_a_velocity_that_jumps_as_the_run_ends_is_drawn_before_and_after(law):
    restitution = {} if law == "velcro" else {"restitution": 1}
    plain = registry.two_carts(velocities=(1, 0), gap=0.5, law=law, **restitution)
    finished = run(read_scene(plain | {"until": 0.5}))
    assert finished.v[1] > 0.0
    columns = trajectory(finished).columns
    assert list(columns["t",])[-2:] == [0.5, 0.5]
    for name, before, after in zip("AB", (1.0, 0.0), finished.v, strict=True):
        assert list(columns["v", name])[-2:] == [before, after]


def test_energy_set_free_as_the_run_ends_is_drawn_before_and_after():
    release = {"release": {"between": ["A", "B"], "energy": 1, "at": 1}}
    plain = registry.two_carts(masses=(1, 1), velocities=(0, 0), gap=0.0, law="bumper")
    plain["contact"] |= {"restitution": 1, "stiffness": 100}
    finished = run(read_scene(plain | {"until": 1, "effects": [release]}))
    assert finished.v == (-1.0, 1.0)
    columns = trajectory(finished).columns
    assert [list(columns["v", name])[-2:] for name in "AB"] == [[0.0, -1.0], [0.0, 1.0]]


def test_names_and_the_order_of_writing_do_not_matter():
    plain = registry.two_carts(restitution="0.6")
    carts = plain["carts"]
    renamed = {**plain, "carts": {"Z9": carts["B"], "late": carts["A"]}}
    one, two = run(read_scene(plain)), run(read_scene(renamed))
    assert (one.x, one.v, one.t) == (two.x, two.v, two.t)


def test_a_cart_at_half_a_millimetre_per_second_never_stops():
    finished = run(registry.scene("slow-and-long"))
    assert finished.v == (0.0005,)
    assert finished.x[0] == pytest.approx(0.50, abs=1e-16)


@pytest.mark.parametrize("until", [1e3, 1e5])
def test_a_hundred_thousand_seconds_of_bouncing_keep_their_rhythm(until):
    plain = {
        "carts": {"A": {"mass": 1, "position": "0.5", "velocity": "0.9"}},
        "track": {"left": "wall", "right": "wall", "length": "1.5"},
        "contact": {"stiffness": 500},
        "until": until,
    }
    finished = run(read_scene(plain), max_events=10**8, keep_events=False, keep_motion=False)
    period = 2 * (1.3 / 0.9 + math.pi / math.sqrt(500.0))  # both flights and both contacts
    phase = math.fmod(until, period)
    reference = run(read_scene(plain | {"until": phase}))
    assert finished.x[0] == pytest.approx(reference.x[0], abs=1e-9)


@pytest.mark.parametrize(("digits", "count"), [(0, 3), (1, 31), (2, 314), (3, 3141)])
def test_a_heavy_cart_counts_the_digits_of_pi(digits, count):
    plain = {
        "carts": {
            "small": {"mass": 1, "position": 1, "velocity": 0},
            "big": {"mass": 100**digits, "position": 2, "velocity": -1},
        },
        "track": {"left": "wall"},
        "contact": {"law": "instant"},
        "until": 1e6,
    }
    finished = run(read_scene(plain), keep_motion=False)
    assert finished.record.counts["contact"] == count
