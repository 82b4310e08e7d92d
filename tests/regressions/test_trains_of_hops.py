"""Trains of thousands of hops on a bumper's steep line, found by the adversary (`tests.fuzz`).

They are contacts that the law has. What is tested is how many solvers one of them takes, and that
the end is where the power series, step by step, had it.
"""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene
from tests.fuzz.kinds import scene_of

SERIES = {
    ("collisions", 42, 0.5): (1050, 110, (-0.0977580093663780, -0.0956334093382269)),
    ("overlaps", 71, 2.0): (1220, 330, (-0.2851721435351572, -0.0861597388961339)),
    ("dead bumpers", 65, 0.3): (1500, 220, (0.2657718610418871, 0.4631545489703450)),
}
"""Kind, number, end [s]: the most solvers (the series took up to twice as many), the most of them
steps of the series (one that rests while the other hops is one of them), places [m]."""


@pytest.mark.parametrize("kind, seed, until", SERIES)
def test_a_train_of_hops_takes_one_phase_from_change_to_change(
    kind: str, seed: int, until: float
) -> None:
    most, steps, places = SERIES[kind, seed, until]
    done = run(read_scene(scene_of(kind, seed) | {"until": until}))
    assert sum(done.solvers.values()) <= most
    assert done.solvers["power-series"] <= steps
    assert done.x == pytest.approx(places, rel=1e-11)
    assert done.ledger.imbalance() < 1e-12


LAST_BIT_PLACES = (
    0.04153111245574232,
    0.22898176203534942,
    0.42757673929893410,
    0.62024040279065110,
    0.81467106732056420,
)
"""m. Of inputs moved by 2e-15 and 1e-13 the same to 2e-14."""


def test_the_last_bit_of_a_velocity_is_not_handed_to_and_fro_between_dead_bumpers() -> None:
    scene = scene_of("dead bumpers", 85) | {"until": 0.5}
    done = run(read_scene(scene), max_events=5000)
    assert done.stopped is None
    assert done.x == pytest.approx(LAST_BIT_PLACES, rel=1e-9)


HOP = 1e-9
"""Relative. A hop is a millionth of the run; its two ends are known to 1e-16 of the run."""


def test_a_cart_that_hops_on_one_at_rest_flies_a_parabola_and_the_other_stands() -> None:
    scene = read_scene(
        {
            "carts": {
                "A": {"mass": 2.2, "position": 0.1, "velocity": 1},
                "B": {"mass": 1, "position": 0.3, "velocity": 0.5},
            },
            "track": {"left": "open", "right": "wall", "length": 0.5479},
            "contact": {
                "law": "bumper",
                "pairs": {
                    "A-B": {"restitution": 0.01, "stiffness": 5800},
                    "B-right": {"restitution": 0, "stiffness": 12700},
                },
            },
            "effects": [{"incline": {"angle": "5 deg"}}],
            "until": 2,
        }
    )
    done = run(scene)
    downhill = 9.81 * math.sin(math.radians(5))
    told = [
        e for e in done.record.events if e.bodies == ("A", "B") and e.kind not in ("peak", "end")
    ]
    hops = [(a, b) for a, b in pairwise(told[-40:]) if a.kind == "separate"]
    assert len(hops) >= 19
    for parted, touched in hops:
        speed = -parted.after["A"]  # uphill
        assert touched.t - parted.t == pytest.approx(2.0 * speed / downhill, rel=HOP)
        assert touched.before["A"] == pytest.approx(speed, rel=HOP)
        assert parted.after["B"] == pytest.approx(0.0, abs=1e-12)
    assert done.v[1] == 0.0  # not what rounding left of it when it was caught
