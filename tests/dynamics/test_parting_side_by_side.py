"""Two that rest side by side and are driven alike: they part by less than any place is told to."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene

SLOPE, G = 2.0, 9.81  # deg, m/s²
DRIVEN = G * math.sin(math.radians(SLOPE))  # m/s²


def beside_a_wall(contact: dict[str, Any], drag: dict[str, Any]) -> dict[str, Any]:
    """A in air, B against the wall at its right, and C behind A, in touch, on a slope to there."""
    masses = {"C": 1.0, "A": 1.0, "B": 2.0}
    return {
        "carts": {
            name: {"mass": mass, "position": round(0.1 + 0.2 * k, 6)}
            for k, (name, mass) in enumerate(masses.items())
        },
        "track": {"right": "wall", "length": 0.6},
        "contact": contact,
        "effects": [{"incline": {"angle": f"{SLOPE} deg"}}, {"drag": {**drag, "carts": ["A"]}}],
        "until": 0.5,
    }


def first_touch(plain: dict[str, Any]) -> float:
    """s. When A and B touch, once they have parted; they do so once, and for all of the run."""
    done = run(read_scene(plain), max_events=100)
    assert done.stopped is None
    touches = [e for e in done.record.events if e.kind == "contact" and e.bodies == ("A", "B")]
    (touch,) = touches
    assert touch.before["A"] > touch.before["B"]
    assert done.ledger.imbalance() < 1e-13
    return touch.t


@pytest.mark.parametrize("law", ["bumper", "paper", "push-only"])
def test_air_parts_two_before_the_wall_presses_them_together(law: str) -> None:
    """Air: c a t/m_A, the wall: k a t²/(2 m_B); integrated twice, alike at 4 c m_B/(m_A k).

    What C adds to A's acceleration is k/m_A times a way of c a t³/(6 m_A).
    """
    found = first_touch(
        beside_a_wall({"law": law, "stiffness": 50.0, "restitution": 1.0}, {"linear": 0.01})
    )
    assert found == pytest.approx(4.0 * 0.01 * 2.0 / 50.0, rel=1e-3)


def test_air_parts_two_spheres_before_the_wall_presses_them_together() -> None:
    """Air: κ (a t)²/m_A, the wall: K (a t²/2)^(3/2)/m_B; integrated twice, t⁴/12 and t⁵/20."""
    found = first_touch(
        beside_a_wall({"law": "hertz", "stiffness": 130.0, "restitution": 1.0}, {"quadratic": 0.1})
    )
    expected = 20.0 / 12.0 * 0.1 * DRIVEN**2 * 2.0 / (130.0 * (0.5 * DRIVEN) ** 1.5)
    assert found == pytest.approx(expected, rel=1e-3)


def test_of_three_spheres_the_last_that_air_holds_back_falls_behind() -> None:
    """C and D touch without damping to speak of: D, without air, leaves E behind for good."""
    places = {"C": 0.6, "D": 0.8, "E": 1.0}
    carts = {name: {"mass": 1.0, "position": place} for name, place in places.items()}
    plain = {
        "carts": carts,
        "contact": {"law": "hertz", "restitution": 0.0, "stiffness": 358.1},
        "effects": [
            {"drag": {"linear": 0.1, "carts": ["C", "E"]}},
            {"incline": {"angle": "-0.1 deg"}},
        ],
        "until": 1.0,
    }
    done = run(read_scene(plain), max_events=100)
    assert done.stopped is None
    assert not [e for e in done.record.events if e.bodies == ("D", "E")]
    alone = -G * math.sin(math.radians(0.1)) * -math.expm1(-0.1) / 0.1
    assert done.v[2] == pytest.approx(alone, rel=1e-13)


@pytest.mark.parametrize("law", ["bumper", "paper", "push-only"])
def test_a_contact_in_which_nothing_pushed_was_none(law: str) -> None:
    """Air holds A back at once: A and B, at rest in touch, part before they push each other.

    B, at first, does not feel the wall, but C, which the wall slows: air, κ (a t)², is more than
    that, k² a t⁴/(24 m_B m_C), up to about t² = 120 κ a/k² · m_B m_C/2. The room is 1e-19 m.
    """
    plain: dict[str, Any] = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.3},
            "B": {"mass": 2.0, "position": 0.5},
            "C": {"mass": 1.0, "position": 0.7},
        },
        "track": {"right": "wall", "length": 0.8},
        "contact": {"law": law, "restitution": 1.0, "stiffness": 2000.0},
        "effects": [
            {"incline": {"angle": "1 deg"}},
            {"drag": {"quadratic": 0.01, "carts": ["A"]}},
        ],
        "until": 0.5,
    }
    done = run(read_scene(plain))
    told = [e for e in done.record.events if e.bodies == ("A", "B")]
    assert [e.kind for e in told[:4]] == ["contact", "peak", "separate", "contact"]
    assert all(e.impulse > 0.0 for e in told if e.kind == "separate")
    slope = G * math.sin(math.radians(1.0))
    assert told[0].t == pytest.approx(math.sqrt(120.0 * 0.01 * slope) / 2000.0, rel=0.3)
    assert done.record.counts["contact"] == sum(e.kind == "contact" for e in done.record.events)
