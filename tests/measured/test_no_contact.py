"""Where only one cart, or none, changes its velocity, no contact is told."""

from __future__ import annotations

import pytest

from sim.measured.analysis import analysed
from sim.measured.refusal import of_readings
from sim.measured.synthetic import filmed
from sim.measured.tracks import read_measured
from sim.scene import read_scene

APART = 0.6
"""m. So far A would have to roll."""


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize("rate", [20.0, 50.0])
@pytest.mark.parametrize(
    ("v", "mu"),
    [(0.5, 0.03), (0.1, 0.0), (0.001, 0.0)],
    ids=["stops-before-it-reaches-B", "too-slow-to-reach-B", "both-rest"],
)
def test_a_run_without_a_contact_is_refused_as_one(
    v: float, mu: float, rate: float, seed: int
) -> None:
    scene = {
        "carts": {
            "A": {"mass": 0.5, "position": 0.5, "velocity": v},
            "B": {"mass": 1.0, "position": 0.7 + APART, "velocity": 0.0},
        },
        "contact": {"restitution": 0.8, "stiffness": 300.0},
        "effects": [{"friction": {"coefficient": str(mu)}}] if mu else [],
        "until": 3.0,
    }
    found = analysed(filmed(read_scene(scene), rate=rate, noise=5e-4, seed=seed))
    assert found.refused and found.refused.code == "no-contact"


def test_carts_that_never_met_are_not_told_what_the_model_takes_for_granted() -> None:
    """The refusal was the model's: “the carts do not come closer to each other”."""
    t = [k / 30 for k in range(60)]
    rows = "".join(f"{x:.4f}\t{0.2 + 0.1 * x:.5f}\t{0.9 + 0.25 * x:.5f}\n" for x in t)
    refused = analysed(read_measured(["t\tx_A\tx_B\n" + rows])).report["refused"]
    assert refused["code"] == "no-contact"
    assert refused["sentence"].startswith("no contact is found: at no time do the readings show")


def test_one_reading_is_no_readings() -> None:
    assert [of_readings(count) for count in (0, 1, 2)] == ["0 readings", "1 reading", "2 readings"]
