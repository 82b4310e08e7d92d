"""Impacts without a duration that have no end: rounds at one instant, and hops under a force."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import pytest

from sim.dynamics.loop.collapse import Hits
from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample
from sim.dynamics.state import flips
from sim.dynamics.state.clock import NEVER, ZERO, Time, later
from sim.scene import read_scene
from tests.fuzz.mirror import mirrored


def row(masses: list[float], speeds: list[float], e: float, **more: Any) -> dict[str, Any]:
    """Carts in touch from a wall on."""
    carts = {
        "ABCDE"[k]: {"mass": m, "position": round(0.1 + 0.2 * k, 6), "velocity": v}
        for k, (m, v) in enumerate(zip(masses, speeds, strict=True))
    }
    return {
        "carts": carts,
        "track": {"left": "wall", "length": 3},
        "contact": {"law": "instant", "restitution": e},
        "until": 3,
    } | more


def hit_in_turn(plain: dict[str, Any], rounds: int) -> float:
    """The greatest relative speed that is left after so many impacts, the fastest one first.

    Plain arithmetic of V + e (V − v), with exact fractions: no rounding decides who is hit.
    """
    carts = list(plain["carts"].values())
    e = Fraction(str(plain["contact"]["restitution"]))
    m = [Fraction(str(c["mass"])) for c in carts]
    v = [Fraction(str(c["velocity"])) for c in carts]
    for _ in range(rounds):
        closing = [-v[0], *(a - b for a, b in itertools.pairwise(v))]
        k = max(range(len(closing)), key=lambda j: closing[j])
        if closing[k] <= 0:
            return 0.0
        if k == 0:
            v[0] = -e * v[0]
        else:
            centre = (m[k - 1] * v[k - 1] + m[k] * v[k]) / (m[k - 1] + m[k])
            v[k - 1], v[k] = centre + e * (centre - v[k - 1]), centre + e * (centre - v[k])
        v = [one.limit_denominator(10**40) for one in v]
    closing = [-v[0], *(a - b for a, b in itertools.pairwise(v))]
    return float(max(map(abs, closing)))


COLLAPSING = {
    "four": row([1, 0.385, 2.13, 1], [-0.5, -0.55, -1, -1], 0.25),
    "four, near the limit": row([1, 0.385, 2.13, 1], [-0.488, -0.556, -1, -1], 0.3),
    "three": row([1, 0.7, 2], [0, 0, -1], 0.25),
}


@pytest.mark.parametrize("what", COLLAPSING)
def test_rounds_of_impacts_that_shrink_for_ever_end_at_once_in_rest_at_the_wall(what: str) -> None:
    plain = COLLAPSING[what]
    assert hit_in_turn(plain, 400) < 1e-3
    done = run(read_scene(plain), max_events=3000)
    assert done.stopped is None
    assert done.v == pytest.approx((0.0,) * len(plain["carts"]), abs=1e-14)
    assert done.ledger.imbalance() < 1e-14


def test_rounds_in_which_lighter_ones_collapse_end_at_once_too() -> None:
    """D presses three light ones to the wall. They collapse among themselves between two of its
    blows, of which each takes it 0.7 % of its speed: 300,000 impacts, followed one by one."""
    plain = row([1.0, 0.0967, 2.12, 149.0], [-0.289, -0.2894, -0.2895, -0.295], 0.05)
    done = run(read_scene(plain), max_events=2_000)
    assert done.stopped is None
    assert done.v == pytest.approx((0.0,) * 4, abs=1e-14)
    assert done.ledger.imbalance() < 1e-14


def test_rounds_count_only_when_every_speed_shrinks_by_the_same_factor() -> None:
    def hits(factors: list[float]) -> Hits:
        found = Hits()
        speed = 1.0
        for k in range(16):
            found.gaps += [1, 2]
            found.speeds += [speed, 0.3 * speed]
            speed *= factors[k % len(factors)]
        found.time = ZERO
        return found

    assert hits([0.5]).rounds() == (1, 2)
    assert hits([0.5, 0.51]).rounds() == (1, 2)  # two of these are a round
    assert hits([0.5 + 0.001 * k for k in range(16)]).rounds() is None
    assert hits([1.0]).rounds() is None


def test_a_round_with_the_same_speeds_has_no_end_whatever_came_before_it() -> None:
    found = Hits()
    for k in range(600):
        found.gaps += [1, 2]
        found.speeds += [1.0 + max(0, 596 - k), 0.5]
    assert found.rounds() is None
    assert found.endless


PRESSED = {
    "carts": {
        "A": {"mass": 0.408, "position": 0.1, "velocity": -1.0},
        "B": {"mass": 1.0, "position": 0.3},
    },
    "track": {"left": "wall", "length": 3},
    "contact": {
        "law": "instant",
        "restitution": 0.2,
        "pairs": {"left-A": {"law": "instant", "restitution": 0.89}},
    },
    "effects": [{"spring": {"between": ["A", "B"], "stiffness": 922, "length": 0.3}}],
    "until": 1,
}


def test_a_cart_that_a_spring_presses_to_the_wall_hops_until_no_hop_is_left() -> None:
    """Each hop is e² as high: 140 of them to 1e-16, and then it is held, until the spring pulls."""
    done = run(read_scene(PRESSED), max_events=1000)
    assert done.stopped is None
    assert done.record.counts["contact"] < 300
    assert done.ledger.imbalance() < 1e-13


def _spring(between: str, stiffness: float, length: float, damping: float) -> dict[str, Any]:
    one = {"stiffness": stiffness, "length": length, "damping": damping}
    return {"spring": {"between": list(between), **one}}


COLLAPSING_ON_SPRINGS = {
    "carts": {
        "A": {"mass": 3.57, "position": 0.4, "velocity": 0.3},
        "B": {"mass": 1.11, "position": 0.6, "velocity": 0},
        "C": {"mass": 1.0, "position": 0.85, "velocity": 0},
        "D": {"mass": 1.0, "position": 1.1, "velocity": 0},
    },
    "track": {"left": "open", "right": "wall", "length": 1.9},
    "contact": {"law": "instant", "restitution": 0.05},
    "effects": [
        _spring("AB", 1.27, 0.05, 0.1),
        _spring("BC", 203.0, 0, 2),
        _spring("CD", 258.0, 0.05, 2),
        {"drag": {"quadratic": 0.1}},
    ],
    "until": 5,
}


def test_a_contact_that_a_collapse_leaves_never_pulls() -> None:
    """A, B and C come to one velocity at 4.8165 s, after sixty impacts at one time. From then on
    D's spring draws C away from B, and its own holds it back too weakly: B and C part."""
    done = run(read_scene(COLLAPSING_ON_SPRINGS))
    image = run(read_scene(mirrored(COLLAPSING_ON_SPRINGS)))
    for time in (4.8166, 4.82, 4.83, 5):
        (_, b, c, _), v = sample(done, time)
        (_, c_image, b_image, _), v_image = sample(image, time)
        assert b_image - c_image == pytest.approx(c - b, abs=1e-12)
        assert [-one for one in reversed(v_image)] == pytest.approx(v, abs=1e-11)
    (_, b, c, _), _ = sample(image, 4.82)
    assert c - b > 0.2 + 1e-7


@dataclass
class Mode:
    """Of a contact: on and off."""

    changed: Time = NEVER
    flips: int = 0
    alternates: int = 0
    alternates_before: int = 0


def test_impacts_at_one_time_count_as_one_change_and_changes_by_rounding_each() -> None:
    instant, step = 1e-11, 1.0
    hit, rounding = Mode(), Mode()
    for _ in range(60):
        flips.note(hit, ZERO, instant)
        flips.jump(hit, ZERO, moves=False)
        flips.note(rounding, ZERO, instant)
    assert hit.flips == rounding.flips == 59
    assert flips.margin(hit, ZERO, step) == 0.0
    assert flips.margin(rounding, ZERO, step) == flips.MARGIN * flips.GROWS**flips.MOST
    now = ZERO
    for _ in range(60):  # each at its own time: what the margin lets pass is no motion yet
        now = later(now, 1e-13)
        flips.note(hit, now, instant)
        flips.jump(hit, now, moves=False)
    assert flips.margin(hit, now, step) == flips.MARGIN * flips.GROWS**flips.MOST
    flips.jump(hit, now, moves=True)  # an impact that moves its bodies: nothing before alternated
    assert flips.margin(hit, now, step) == 0.0
