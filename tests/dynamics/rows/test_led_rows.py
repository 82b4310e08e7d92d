"""Stiff contacts whose swing has faded beside slow forces: as 25 digits say, in few steps."""

from __future__ import annotations

from typing import Any

import mpmath
import pytest
from mpmath import mpf

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample
from sim.scene import read_scene

ROUNDING = 3e-15
"""m/s and m, of speeds and lengths about 1: what a hundred steps leave."""

STEPS = 60
"""Of the series. As short as the swing would have them there were 183."""


def pressed(effects: list[Any], **more: Any) -> dict[str, Any]:
    """A heavy cart pushes a light one; their bumper is critically damped, w = 150/s."""
    return {
        "carts": {
            "A": {"mass": 4.0, "position": 0.1, "velocity": 1.0},
            "B": {"mass": 0.5, "position": 0.3, "velocity": 0.5},
        },
        "contact": {"law": "paper", "restitution": 0, "stiffness": 10_000},
        "effects": effects,
        "until": 1.0,
        **more,
    }


def in_25_digits(
    plain: dict[str, Any], drag: float, until: float, spring: tuple[float, float] = (0.0, 0.0)
) -> tuple[Any, Any]:
    """Speeds and ways of the two, by Taylor series of order 28; nothing of `sim`.

    `spring`: stiffness and damping of one that is as long as the gap at the start. No stiffness of
    the contact: the two do not touch.
    """
    with mpmath.workdps(25):
        a, b = (mpf(c["mass"]) for c in plain["carts"].values())
        v, w = (mpf(c["velocity"]) for c in plain["carts"].values())
        k, q = mpf(plain["contact"]["stiffness"]), mpf(drag)
        damper = 2 * mpmath.sqrt(k * a * b / (a + b)) + mpf(spring[1])
        k += mpf(spring[0])
        over, x, y, steps = mpf(0), mpf(0), mpf(0), round(140 * until)
        h = mpf(until) / steps
        for _ in range(steps):
            vs, ws, os = [v], [w], [over]
            for n in range(28):
                os.append((vs[n] - ws[n]) / (n + 1))
                push = k * os[n] + damper * (vs[n] - ws[n])
                square = [sum(s[i] * s[n - i] for i in range(n + 1)) for s in (vs, ws)]
                vs.append((-push - q * square[0]) / a / (n + 1))
                ws.append((push - q * square[1]) / b / (n + 1))
            x += sum(c * h ** (n + 1) / (n + 1) for n, c in enumerate(vs))
            y += sum(c * h ** (n + 1) / (n + 1) for n, c in enumerate(ws))
            v, w, over = (sum(c * h**n for n, c in enumerate(s)) for s in (vs, ws, os))
        return (float(v), float(w)), (float(x), float(y))


def test_two_that_drag_presses_together_slow_down_as_in_25_digits_say() -> None:
    plain = pressed([{"drag": {"quadratic": 0.5}}])
    done = run(read_scene(plain))
    speeds, ways = in_25_digits(plain, 0.5, plain["until"])
    assert done.solvers["power-series"] <= STEPS
    assert done.v == pytest.approx(speeds, abs=ROUNDING)
    assert [x - c["position"] for x, c in zip(done.x, plain["carts"].values(), strict=True)] == (
        pytest.approx(ways, abs=ROUNDING)
    )
    assert done.ledger.imbalance() < 1e-14


@pytest.mark.parametrize(
    ("room", "most"), [(0.0, 80), (0.1, 60)], ids=["beside a contact", "across a gap"]
)
def test_a_spring_whose_swing_a_damper_has_taken_leads_too(room: float, most: int) -> None:
    """Drag slows the two in unlike ways; as short as the swing would have them, steps were 778
    beside the contact and 73 across the gap."""
    stiffness, damping = 100.0, 13.0
    spring = {"stiffness": stiffness, "length": room, "damping": damping}
    plain = pressed(
        [{"drag": {"quadratic": 0.5}}, {"spring": {"between": ["A", "B"], **spring}}], until=4.0
    )
    plain["carts"]["B"]["position"] += room
    oracle = plain | {"contact": {"stiffness": 0.0 if room else 10_000}}
    done = run(read_scene(plain))
    speeds, ways = in_25_digits(oracle, 0.5, 4.0, (stiffness, damping))
    assert done.solvers["power-series"] <= most
    assert done.v == pytest.approx(speeds, abs=ROUNDING)
    assert [x - c["position"] for x, c in zip(done.x, plain["carts"].values(), strict=True)] == (
        pytest.approx(ways, abs=4 * ROUNDING)
    )
    assert done.ledger.imbalance() < 1e-14


def test_the_force_of_a_led_contact_is_what_the_cart_in_front_needs() -> None:
    """Newton's second law of B, from three samples of its speed."""
    done = run(read_scene(pressed([{"drag": {"quadratic": 0.5}}])))
    t, d = 0.8, 1e-4
    before, here, after = (sample(done, one)[1][1] for one in (t - d, t, t + d))
    needed = 0.5 * (after - before) / (2 * d) + 0.5 * here**2
    (solver,) = [p.solver for p in done.record.solved if p.begin <= t < p.end]
    force, _ = solver.force(1, t - solver.begun[0])
    assert force == pytest.approx(needed, rel=1e-7)


def test_a_magnet_leads_a_row_that_is_pressed_against_a_wall() -> None:
    """The energy of the magnet, of the cart and of the bumper balance; the steps are few."""
    plain = {
        "carts": {
            "A": {"mass": 0.6, "position": 0.1},
            "B": {"mass": 0.76, "position": 0.4, "velocity": -0.3},
        },
        "track": {"left": "wall", "length": 1.0},
        "contact": {"law": "paper", "restitution": 0.5, "stiffness": 400_000},
        "effects": [{"magnets": {"between": ["A", "B"], "strength": 1e-3, "power": 4}}],
        "until": 2.0,
    }
    done = run(read_scene(plain))
    assert done.solvers["power-series"] < 300  # 1,000 as the bumper would swing
    assert done.ledger.imbalance() < 1e-14


def test_a_row_that_still_swings_is_not_led() -> None:
    """Without a damper the swing stays, and with it the short steps."""
    plain = pressed([{"drag": {"quadratic": 0.5}}], until=0.2)
    plain["carts"]["B"]["position"] = 0.29
    plain["start"] = {"overlap": True}
    plain["contact"]["restitution"] = 1
    done = run(read_scene(plain))
    assert max(p.end - p.begin for p in done.record.solved if p.solver.tier == 2) < 0.02
