"""The greatest force of a contact, and how deep it was, beside dense samples of the same run."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.motion.modes.crests import greatest
from sim.dynamics.motion.modes.started import Started, shape_of, swinging
from sim.dynamics.motion.power_series.crest import crest
from sim.dynamics.motion.power_series.polynomial import value
from sim.dynamics.result.trajectory import trajectory
from sim.scene import read_scene

STRAYS = 0.01
"""Relative. Samples, sixteen to a quarter swing, may miss a crest by so much, and no more."""


def solved(carts: list[dict[str, float]], contact: dict[str, Any], **more: Any) -> Any:
    named = {"ABCDEFGH"[k]: cart for k, cart in enumerate(carts)}
    return run(read_scene({"carts": named, "contact": contact, **more}))


def slope(degrees: float, left: str = "wall", right: str = "open") -> dict[str, Any]:
    return {
        "track": {"left": left, "right": right, "length": 3.0},
        "effects": [{"incline": {"angle": f"{degrees} deg"}}],
    }


def told_and_sampled(done: Any) -> list[tuple[float, float]]:
    """N of every contact, from its touch to the next of the same two."""
    columns = trajectory(done).columns
    found = []
    for pair in {event.bodies for event in done.record.events if event.kind == "contact"}:
        own = [event for event in done.record.events if event.bodies == pair]
        begun = sorted({event.t for event in own if event.kind == "contact"})
        samples = list(zip(columns[("t",)], columns[("F", "-".join(pair))], strict=True))
        for since, until in zip(begun, [*begun[1:], done.t], strict=True):
            peaks = [e.force for e in own if e.kind == "peak" and since <= e.t <= until]
            sampled = [force for t, force in samples if since <= t <= until]
            found.append((max(peaks, default=0.0), max(sampled, default=0.0)))
    return found


def test_a_cart_let_go_at_a_bumper_on_a_slope_is_pressed_twice_as_hard_as_it_rests() -> None:
    """It begins without force and without growth of force: no crest was told after that.

    It comes back to where it has no force just as it turns, and does not part: one contact.
    """
    cart = {"mass": 1.0, "position": 0.1, "velocity": 0.0}
    contact = {"law": "bumper", "restitution": 1, "stiffness": 1000}
    done = solved([cart], contact, until=0.9, **slope(-5))
    twice = 2.0 * 9.81 * math.sin(math.radians(5))
    kinds = [event.kind for event in done.record.events]
    peak = next(event for event in done.record.events if event.kind == "peak")
    assert kinds == ["contact", "peak", "end"]
    assert peak.t == pytest.approx(math.pi / math.sqrt(1000.0))
    assert peak.force == pytest.approx(twice, rel=1e-9)


@pytest.mark.parametrize(
    ("law", "e", "stiffness", "degrees", "until", "carts"),
    [
        (
            "bumper",
            0.05,
            20.8,
            -3.0,
            6.4,
            [
                {"mass": 1.0, "position": 0.412, "velocity": 0.0},
                {"mass": 1.0, "position": 0.612, "velocity": 0.0},
            ],
        ),
        (
            "bumper",
            0.9,
            400,
            -10.0,
            6.14,
            [
                {"mass": 0.25, "position": 0.3, "velocity": -0.5},
                {"mass": 1.0, "position": 0.5, "velocity": 0.0},
            ],
        ),
    ],
)
def test_of_many_swings_in_one_phase_the_highest_crest_is_told(
    law: str, e: float, stiffness: float, degrees: float, until: float, carts: Any
) -> None:
    """A row that rattles is told phase by phase, each with several swings of modes that beat: the
    first crest of each was taken for the highest."""
    contact = {"law": law, "restitution": e, "stiffness": stiffness}
    done = solved(carts, contact, until=until, **slope(degrees))
    for told, sampled in told_and_sampled(done):
        assert sampled * (1.0 - 1e-9) <= told <= sampled * (1.0 + STRAYS) + 1e-6


@pytest.mark.parametrize("law", ["bumper", "paper", "push-only", "push-only-uncorrected"])
def test_a_contact_that_begins_overlapped_is_as_deep_as_its_energy_says(law: str) -> None:
    """Half a swing without damping was taken for a quarter, which is deepest at its end."""
    carts = [
        {"mass": 1.0, "position": 0.1, "velocity": 0.5},
        {"mass": 1.0, "position": 0.29, "velocity": -0.5},
    ]
    contact = {"law": law, "restitution": 1, "stiffness": 1000}
    track = {"left": "open", "right": "open", "length": 1.0}
    done = solved(carts, contact, until=1.0, track=track, start={"overlap": True})
    (deepest, _), *others = done.record.deepest.values()
    assert not others
    assert deepest == pytest.approx(math.hypot(0.01, 1.0 / math.sqrt(2000.0)), rel=1e-12)


@pytest.mark.parametrize("seed", range(40))
def test_no_sample_of_a_sum_of_modes_lies_above_its_highest_crest(seed: int) -> None:
    dice = Random(seed)
    paces = [10.0 ** dice.uniform(-3.0, 1.0) for _ in range(dice.randint(1, 4))]
    rates = tuple(complex(-dice.choice([0.0, 0.01, 0.2]) * one, one) for one in paces)
    shares = tuple(complex(dice.gauss(0.0, 1.0), dice.gauss(0.0, 1.0)) * abs(z) for z in rates)
    shape, swings = shape_of(shares, rates), swinging(rates, (1.0 + 0j,) * len(rates))
    bend = sum(shares).real
    third = sum(b * z for b, z in zip(shares, rates, strict=True)).real
    q = Started(dice.gauss(0.0, 1.0), dice.gauss(0.0, 1.0), bend, shape)
    turned = tuple(b * z for b, z in zip(shares, rates, strict=True))
    growth = Started(q.slope, q.bend, third, shape_of(turned, rates))
    pace = max(map(abs, rates))
    h = dice.uniform(2.0, 32.0) / pace
    when = greatest(q, growth, swings, h, pace)
    told = q.value(when, swings.at(when))
    samples = [h * k / 2000 for k in range(2001)]
    size = max(abs(q.value(t, swings.at(t))) for t in samples)
    assert 0.0 <= when <= h
    assert all(q.value(t, swings.at(t)) <= told + 1e-12 * size for t in samples)


def test_a_force_that_falls_and_rises_again_within_one_step_is_told_at_its_crest() -> None:
    """Three on springs, each pressed twice in one touch: 0.2 % more the second time."""
    carts = [
        {"mass": 0.5, "position": 0.1, "velocity": 0.2},
        {"mass": 0.25, "position": 0.299, "velocity": 0.1},
        {"mass": 2.0, "position": 0.498, "velocity": 0.1},
    ]
    springs = [
        {"spring": {"between": ["A", "B"], "stiffness": 500, "length": 0}},
        {"spring": {"between": ["B", "C"], "stiffness": 500, "length": 0, "damping": 0.1}},
    ]
    contact = {"law": "push-only", "restitution": 1, "stiffness": 200}
    track = {"left": "wall", "right": "open", "length": 1.0}
    more = {"track": track, "effects": springs, "start": {"overlap": True}}
    done = solved(carts, contact, until=4.2, **more)
    peak = next(
        e for e in done.record.events if e.kind == "peak" and e.t > 4.08 and "C" in e.bodies
    )
    assert peak.t == pytest.approx(4.1042, abs=2e-4)
    assert peak.force == pytest.approx(0.303371, rel=1e-5)
    ways = trajectory(done).columns
    near = [k for k, t in enumerate(ways[("t",)]) if 4.05 < t < 4.14]
    pushed = [200.0 * (0.2 - ways[("x", "C")][k] + ways[("x", "B")][k]) for k in near]
    assert max(pushed) <= peak.force * (1.0 + 1e-9)


@pytest.mark.parametrize("seed", range(60))
def test_a_polynomial_lies_nowhere_above_its_crest_and_its_ends(seed: int) -> None:
    dice = Random(seed)
    low, high = sorted((dice.uniform(-0.5, 1.5), dice.uniform(-0.5, 1.5)))
    sign = dice.choice([1.0, -1.0])
    growth = [sign * low * high, -sign * (low + high), sign]  # sign (t − low)(t − high)
    top = crest(growth, 1.0, sign * (1.0 - low) * (1.0 - high))
    whole = [0.0, growth[0], growth[1] / 2.0, growth[2] / 3.0]
    told = max(value(whole, t) for t in (0.0, 1.0, *([] if top is None else [top])))
    assert all(value(whole, k / 500) <= told + 1e-15 for k in range(501))
