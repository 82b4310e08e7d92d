"""Friction of each cart on a track that leans: both at once, and neither alone."""

from __future__ import annotations

import numpy as np
import pytest

from sim.measured.analysis import Wanted, analysed
from sim.measured.events.sides import speeds_of
from sim.measured.model.curves import places
from sim.measured.model.effects import called_for, compare
from sim.measured.model.fit import Asked, fit
from sim.measured.model.motion import Motion, Parameters, pull
from tests.measured.makers import film, truth

LEANS = (
    {"friction": {"coefficient": 0.012}},
    {"incline": {"angle": "-0.4 deg"}},
)
BOTH = truth(mass=0.25, ratio=2.5, e=0.65, v=(0.75, 0.0), gap=0.5, after=1.2, effects=LEANS)


def test_friction_holds_a_cart_on_a_track_that_leans_less_than_it() -> None:
    assert pull(0.0, 0.1, 0.05) == (0.0, float("inf"))
    a, stands = pull(0.2, 0.1, 0.05)
    assert a == pytest.approx(-0.05) and stands == pytest.approx(4.0)
    a, stands = pull(0.2, 0.05, 0.1)  # the track leans more: it rolls on
    assert a == pytest.approx(0.05) and stands == float("inf")


@pytest.mark.parametrize(("friction", "tilt"), [((0.1, 0.2), 0.05), ((0.03, 0.0), -0.06)])
def test_places_for_fitting_are_those_of_the_motion(
    friction: tuple[float, float], tilt: float
) -> None:
    motion = Motion(
        Parameters(touch=1.0, x=0.4, distance=0.2, v=(0.6, -0.1), ratio=1.3, e=0.7, w0=30.0,
                   friction=friction, tilt=tilt),
        "bumper",
    )  # fmt: skip
    t = np.linspace(0.0, 5.0, 101)
    for cart in (0, 1):
        wanted = [motion.state(one)[0][cart] for one in t.tolist()]
        assert places(motion, cart, t) == pytest.approx(wanted, abs=1e-12)


def test_friction_of_each_cart_and_the_tilt_are_told_apart() -> None:
    measured = film(BOTH, 120, 3e-4)
    found = fit(measured, Asked(effect="both")).parameters
    assert found.tilt == pytest.approx(-9.81 * np.sin(np.radians(0.4)), rel=0.05)
    assert found.friction == pytest.approx((0.012 * 9.81, 0.012 * 9.81), rel=0.1)
    assert found.e == pytest.approx(0.65, abs=0.01)
    rows = compare(measured, fit(measured))
    assert called_for(rows) == "both"


@pytest.mark.parametrize("effects", [LEANS[:1], LEANS[1:]])
def test_where_one_is_enough_both_are_not_called_for(effects: tuple[dict, ...]) -> None:  # type: ignore[type-arg]
    one = truth(mass=0.25, ratio=1.4, e=0.65, v=(0.75, -0.2), effects=effects)
    measured = film(one, 60, 5e-4)
    assert called_for(compare(measured, fit(measured))) != "both"


@pytest.mark.parametrize("seed", range(3))
def test_the_bounciness_lies_in_its_interval_where_carts_rub_on_a_track_that_leans(
    seed: int,
) -> None:
    """With friction alone it came out a tenth too low, and surely so."""
    found = analysed(film(BOTH, 120, 5e-4, seed=seed)).report
    assert found["effect"] == "both"
    assert "friction on each cart and a tilt of the track" in " ".join(found["sentences"])
    e = next(row for row in found["known"] if row["key"] == "e")
    assert e["low"] < BOTH.e < e["high"] and e["high"] - e["low"] < 0.15


def test_velocities_count_both_where_either_alone_misses_readings() -> None:
    tau = np.arange(1, 41) / 50.0
    dice = np.random.default_rng(3)
    sides = []
    for k, v in enumerate((0.5, -0.4, -0.3, 0.35)):
        times = tau if k > 1 else -tau
        a = -0.12 * np.sign(v) - 0.07 * abs(np.sign(v))
        sides.append((times, v * times + 0.5 * a * times**2 + 2e-4 * dice.standard_normal(40)))
    speeds = speeds_of(sides)
    assert speeds.step == "both"
    assert speeds.v == pytest.approx((0.5, -0.4, -0.3, 0.35), abs=0.004)


def test_both_are_fitted_where_a_reader_asks_for_them_though_nothing_calls_for_them() -> None:
    plain = truth(mass=0.25, ratio=1.4, e=0.65, v=(0.75, -0.2))
    found = analysed(film(plain, 60, 5e-4), Wanted(effect="both")).report
    assert found["effect"] == "both" and found["calls_for"] == "none"
    told = {one["key"]: one for one in found["known"]}
    assert {"friction_a", "friction_b", "tilt"} <= told.keys()
    assert told["tilt"]["low"] < 0.0 < told["tilt"]["high"]
