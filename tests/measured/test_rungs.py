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
    quiet = [one for one in speeds.rungs if one.verdict == "not-shown"]
    assert quiet and all("cannot show it" in of_rung(one) for one in quiet)
    assert "mm" in of_scatter(speeds)


# What acts over 0.8 s, the noise, and what is to be said of each rung, the largest change first.
# A tilt bends all four sides one way; friction and drag bend each against its velocity, and one of
# them goes the other way. So friction fits no tilt, and a tilt where carts rub makes it worse.
VERDICTS = {
    "a tilt of 0.3 m/s², 0.1 mm": (
        ("tilt", 0.3, 1e-4),
        {"tilt": "shown", "drag": "shown", "friction": "not-shown"},
    ),
    "friction of 0.2 m/s², 0.2 mm": (
        ("friction", 0.2, 2e-4),
        {"friction": "shown", "tilt": "against", "drag": "shown"},
    ),
    "drag of 0.4 /s, 0.2 mm": (
        ("drag", 0.4, 2e-4),
        {"drag": "shown", "friction": "shown", "tilt": "shown"},
    ),
    "6 mm of friction in 20 mm of noise": (
        ("friction", 0.02, 2e-2),
        {"friction": "against", "tilt": "not-shown", "drag": "not-shown"},
    ),
    "nothing, in 1 mm of noise": (
        ("nothing", 0.0, 1e-3),
        {"friction": "against", "tilt": "not-shown", "drag": "not-shown"},
    ),
}


@pytest.mark.parametrize("name", VERDICTS)
def test_rungs_stand_largest_first_and_say_which_changes_readings_bear_out(name: str) -> None:
    made, told = VERDICTS[name]
    assert [(one.step, one.verdict) for one in speeds_of(sides(*made)).rungs] == [*told.items()]
