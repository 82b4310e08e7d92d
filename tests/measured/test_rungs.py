"""The ladder of readings: what friction, a tilt or drag changes, and whether readings show it."""

from __future__ import annotations

import numpy as np
import pytest

from sim.measured.events.brakes import Side
from sim.measured.events.rungs import Rung
from sim.measured.events.sides import Speeds, speeds_of
from sim.measured.events.words import of_rung, of_scatter

SPEEDS = (0.6, 0.05, -0.2, 0.5)  # m/s, of A and B before and after
RATE = 50.0  # readings a second


def sides(brake: str, strength: float, noise: float) -> tuple[Side, ...]:
    """Four sides of 0.8 s; `strength` in m/s² (drag: 1/s), `noise` in m."""
    dice = np.random.default_rng(4)
    found = []
    for k, v in enumerate(SPEEDS):
        tau = (np.arange(1, 41) / RATE) * (1 if k > 1 else -1)
        pull = {"friction": -np.sign(v) * strength, "tilt": strength, "drag": -v * strength}
        bend = pull.get(brake, 0.0) * tau**2 / 2
        found.append((tau, v * tau + bend + noise * dice.standard_normal(40)))
    return tuple(found)


def rung(speeds: Speeds, step: str) -> Rung:
    return next(one for one in speeds.rungs if one.step == step)


@pytest.mark.parametrize(("brake", "strength"), [("friction", 0.2), ("tilt", 0.2), ("drag", 0.4)])
def test_what_brakes_the_carts_is_shown_and_stands_with_its_size(
    brake: str, strength: float
) -> None:
    speeds = speeds_of(sides(brake, strength, 2e-4))
    found = rung(speeds, brake)
    assert speeds.step == brake and found.verdict == "shown"
    assert found.missed < 0.3 * found.without and speeds.scatter < 0.3 * found.without
    assert found.changes == pytest.approx(found.without, rel=0.2)  # without it this much is missed
    assert "your readings show it" in of_rung(found)


def test_readings_that_scatter_more_than_it_changes_cannot_show_it() -> None:
    speeds = speeds_of(sides("friction", 0.02, 2e-2))
    assert speeds.scatter == pytest.approx(2e-2, rel=0.15)
    for found in speeds.rungs:
        assert (found.verdict == "not-shown") == (found.changes <= speeds.scatter)
    quiet = [one for one in speeds.rungs if one.verdict == "not-shown"]
    assert quiet and all("cannot show it" in of_rung(one) for one in quiet)
    assert "mm" in of_scatter(speeds)


def test_rungs_stand_largest_first_and_a_change_that_makes_it_worse_is_not_borne_out() -> None:
    speeds = speeds_of(sides("tilt", 0.3, 1e-4))
    sizes = [one.changes for one in speeds.rungs]
    assert sizes == sorted(sizes, reverse=True) and len(sizes) == 3
    for found in speeds.rungs:
        assert (found.verdict == "against") <= (found.missed > 0.9 * found.without)
