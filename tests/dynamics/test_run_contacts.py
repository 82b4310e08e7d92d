"""What a run tells of its contacts, begun before it or ended after it."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample
from sim.laws.lookup import contact_law
from sim.scene import apply_changes, read_scene
from tests import registry


def test_every_contact_has_a_beginning_a_peak_and_an_end_in_order():
    events = run(registry.scene("train-of-five")).record.events
    assert [event.kind for event in events] == ["contact", "peak", "separate"] * 4 + ["end"]
    assert [event.t for event in events] == sorted(event.t for event in events)
    for event in events[:-1]:
        a, b = event.bodies
        assert event.after[b] - event.before[b] == pytest.approx(event.impulse, abs=1e-15)
        assert event.before[a] - event.after[a] == pytest.approx(event.impulse, abs=1e-15)


def test_two_ends_of_a_run_may_lie_inside_a_contact():
    whole = run(registry.scene("paper-two-carts"))
    plain = registry.plain("paper-two-carts") | {"until": "0.45"}
    part = run(read_scene(plain))
    x, v = sample(whole, 0.45)
    assert list(part.x) == pytest.approx(x, abs=1e-15)
    assert list(part.v) == pytest.approx(v, abs=1e-15)
    ledger = part.ledger
    assert ledger.energy_final + ledger.warmed == pytest.approx(ledger.energy_initial, rel=1e-14)
    assert ledger.energy_final < ledger.energy_initial


def test_a_start_in_overlap_springs_apart():
    plain = registry.two_carts(velocities=(0, 0), gap="-0.02", law="paper", stiffness=500)
    finished = run(read_scene(plain | {"start": {"overlap": True}}))
    u = 0.02 * math.sqrt(500 / (2 / 3))
    assert finished.v[1] - finished.v[0] == pytest.approx(u, rel=1e-14)
    assert finished.ledger.energy_initial == pytest.approx(0.5 * 500 * 0.02**2, rel=1e-14)
    assert finished.ledger.warmed == pytest.approx(0.0, abs=1e-16)


@pytest.mark.parametrize("effects", [[], [{"push": {"cart": "A", "force": 0.01}}]])
def test_a_push_only_pair_that_overlaps_and_parts_fast_does_not_touch(effects):
    """The damper would pull more than the spring pushes: N = k d + c d' < 0, so there is none."""
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0.2, "velocity": -0.5},
            "B": {"mass": 1, "position": 0.36, "velocity": 0.5},
        },
        "contact": {"law": "push-only", "restitution": 0.5, "stiffness": 60},
        "start": {"overlap": True},
        "effects": effects,
        "until": 0.5,
    }
    scene = read_scene(plain)
    law = contact_law(scene.contacts[1])
    assert law.force(0.5, 0.04, 2 * -0.5) < 0.0
    finished = run(scene)
    assert [event.kind for event in finished.record.events] == ["end"]
    assert finished.record.deepest == {}  # no bumper was squeezed
    assert finished.v == pytest.approx((-0.495 if effects else -0.5, 0.5), rel=1e-14)


def test_a_bumper_caught_between_cart_and_wall_is_pressed_again_before_it_is_clear():
    plain = {
        "carts": {
            "A": {"mass": 3, "position": "0.5", "velocity": 1},
            "B": {"mass": "0.2", "position": "0.85"},
        },
        "track": {"length": "0.957", "right": "wall"},
        "contact": {
            "restitution": "0.6",
            "stiffness": 3e4,
            "pairs": {"B-right": {"law": "instant", "restitution": "0.2"}},
        },
        "until": "0.161",
    }
    finished = run(read_scene(plain))
    ledger = finished.ledger
    assert ledger.energy_final + ledger.warmed == pytest.approx(ledger.energy_initial, rel=1e-13)
    assert [event.bodies for event in finished.record.events if event.kind == "contact"] == [
        ("A", "B"),
        ("B", "right"),
        ("A", "B"),
    ]
    again = finished.record.solved[-1].solver
    assert 0 < again.d0 < again.memory


def test_bumpers_squeezed_beyond_their_length_are_told_before_the_run():
    from sim.dynamics.report.warnings import warnings

    (warning,) = warnings(run(registry.scene("too-soft-bumpers")))
    assert warning.code == "bumper-bottoms"
    assert "21.2 cm" in warning.message and "8 cm" in warning.message
    raised = apply_changes(registry.plain("too-soft-bumpers"), {"contact.stiffness": 2820})
    assert warnings(run(read_scene(raised))) == ()


def test_the_run_does_not_depend_on_what_is_kept_of_it():
    scene = registry.scene("train-of-five")
    full, bare = run(scene), run(scene, keep_events=False, keep_motion=False)
    assert (full.x, full.v) == (bare.x, bare.v)
    assert full.record.counts == bare.record.counts


@pytest.mark.parametrize("until", [0.42, 0.50, 0.60, 2.0])
@pytest.mark.parametrize("push", [(), ({"push": {"cart": "A", "force": 0.5, "until": 0.5}},)])
def test_a_force_that_grows_as_the_run_ends_is_no_peak_whatever_is_kept(
    until: float, push: tuple[dict[str, Any], ...]
) -> None:
    plain = {
        "carts": {"A": {"mass": 1, "position": 0.4, "velocity": 1.0, "length": 0.2},
                  "B": {"mass": 1, "position": 1.0, "length": 0.2}},
        "contact": {"restitution": 0.9, "stiffness": 50},
        "effects": push, "until": until,
    }  # fmt: skip
    full, bare = (run(read_scene(plain), keep_events=keep) for keep in (True, False))
    assert full.record.counts["peak"] == bare.record.counts["peak"] == (until > 0.56)


def test_a_run_with_too_many_events_says_so_and_what_to_change():
    finished = run(registry.scene("off-the-wall"), max_events=3)
    assert finished.outcome.kind == "too-many-events"
    assert "--max-events" in finished.outcome.sentence
