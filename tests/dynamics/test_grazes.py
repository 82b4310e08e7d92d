"""A bumper that comes just as deep as before is not pressed further: no event, no further steps."""

from __future__ import annotations

import math
from typing import Any

import mpmath
import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.motion.guards import passed
from sim.laws.branch import Guard
from sim.scene import read_scene

FIRST, MORE, END = 1.0, 3.0, 3.0  # N, N, s
STIFFNESS, SPEED, GRIP, GRAVITY = 400.0, 0.5, 0.05, 9.81
A, B = 1.0, 0.5  # kg


def later(e: float) -> float:
    """s. A quarter of a swing on the steep line after the first turn: nothing parts before that."""
    soft = math.sqrt(STIFFNESS * (A + B) / (A * B))
    return math.pi / soft * (1.0 + 0.5 * e)


def pushed_harder(e: float) -> dict[str, Any]:
    """Two carts that touch and slide; A is pushed, and soon four times as hard."""
    return {
        "carts": {
            "A": {"mass": A, "position": 0.1, "velocity": SPEED, "length": 0.2},
            "B": {"mass": B, "position": 0.3, "velocity": SPEED, "length": 0.2},
        },
        "track": {"left": "open", "right": "open", "length": 20},
        "contact": {"law": "bumper", "restitution": e, "stiffness": STIFFNESS},
        "effects": [
            {"friction": {"coefficient": GRIP}},
            {"push": {"cart": "A", "force": FIRST, "from": 0, "until": END}},
            {"push": {"cart": "A", "force": MORE, "from": later(e), "until": END}},
        ],
        "until": END,
    }


def overlap_at_the_end(e: float) -> Any:
    """m. By hand: pressed in, back on the steep line, up and further in, and on the steep line."""
    mp, start = mpmath.mpf, later(e)
    e, k = mp(e), mp(STIFFNESS)
    mu = mp(A) * B / (mp(A) + B)
    soft = mpmath.sqrt(k / mu)
    steep = soft / e
    first, all_of = (mu * force / A for force in (mp(FIRST), mp(FIRST) + MORE))  # N in the contact
    deep = 2 * first / k  # from no overlap, at the same speed
    rest, small = (1 - e * e) * deep, e * e * first / k
    turned = mpmath.pi / soft
    angle = steep * (mp(start) - turned)  # from the greatest overlap on, about rest + small
    o, rate = rest + small * (1 + mpmath.cos(angle)), -small * steep * mpmath.sin(angle)
    away, swing = o - rest - e * e * all_of / k, rate / steep
    reach = mpmath.hypot(away, swing)
    up = deep - rest - e * e * all_of / k  # of the centre
    # away = reach cos(x), swing = −reach sin(x), x growing; it climbs at cos(x) = up/reach, x < 0
    x = mpmath.atan2(-swing, away)
    turn = (-mpmath.acos(up / reach) - x) % (2 * mpmath.pi)
    now = mp(start) + turn / steep
    rate = steep * mpmath.sqrt(reach**2 - up**2)
    middle = all_of / k
    reach = mpmath.hypot(deep - middle, rate / soft)
    now += mpmath.atan2(rate / soft, deep - middle) / soft
    deep = middle + reach
    rest, centre = (1 - e * e) * deep, (1 - e * e) * deep + e * e * all_of / k
    return centre + (deep - centre) * mpmath.cos(steep * (mp(END) - now))


@pytest.mark.parametrize("e", [0.01, 0.03, 0.1, 0.3, 0.45])
def test_a_cart_that_shakes_under_a_steady_push_takes_few_steps_and_shakes_as_by_hand(
    e: float,
) -> None:
    found = run(read_scene(pushed_harder(e)))
    assert sum(found.solvers.values()) <= 40  # a step for every event would be hundreds
    with mpmath.workdps(40):
        expected = overlap_at_the_end(e)
    assert abs(found.x[0] - found.x[1] + 0.2 - expected) <= 1e-14
    centre = (A * found.x[0] + B * found.x[1]) / (A + B)
    pushed = (FIRST * END**2 + MORE * (END - later(e)) ** 2) / (2 * (A + B))
    begun = (A * 0.1 + B * 0.3) / (A + B) + SPEED * END
    assert centre == pytest.approx(begun + pushed - GRIP * GRAVITY * END**2 / 2, rel=1e-13)


def test_a_cart_that_hops_on_its_steep_line_takes_one_phase_for_a_hop() -> None:
    hops = pushed_harder(0.01)
    hops["carts"]["A"]["velocity"], hops["carts"]["B"]["velocity"] = 0.1, 0.0
    hops["effects"].pop()
    hops["effects"][1]["push"]["force"] = 2.0
    hops["until"] = 1
    found = run(read_scene(hops))
    phases = found.solvers["modes"] + found.solvers["power-series"]
    assert found.record.counts["contact"] > 300
    assert phases <= found.record.counts["contact"] + 70  # the first hundred steps are a series


def test_only_a_bumper_that_climbs_to_its_overlap_is_given_rounding() -> None:
    deep = 3e-3
    climb = Guard("climb", "overlap", rises=True, level=deep)
    assert deep * (1 + 1e-15) < passed(climb) < deep * (1 + 3e-15)
    for guard in (
        Guard("climb", "force", rises=True, level=deep),
        Guard("touch", "overlap", rises=True, level=deep),
        Guard("clear", "overlap", level=deep),
    ):
        assert passed(guard) == guard.level
