"""A brake of another form than the model's: its numbers are no surer than the velocities allow."""

from __future__ import annotations

from dataclasses import replace

import pytest

from sim.measured.analysis import Wanted, analysed
from sim.measured.model.brake_doubt import HALF, TOLD, doubted, form_told
from sim.measured.model.fit import Asked, Fit, fit
from sim.measured.model.quantity import Known
from tests.measured.makers import film, truth

DRAGGED = truth(
    mass=0.2, ratio=1.0, e=0.75, v=(0.15, 0.0), gap=0.15, after=3.5,
    effects=({"drag": {"linear": "0.02 kg/s"}},),
)  # fmt: skip
"""Air brakes a fast cart more than a slow one; friction, which the model knows, does not."""


@pytest.fixture(scope="module")
def made() -> Fit:
    plain = truth()
    return fit(film(plain), Asked(law="bumper", effect="friction"))


def velocities(e: float, sd: float) -> list[Known]:
    return [Known("e", "bounciness e", e, e - 2 * sd, e + 2 * sd, sd, "")]


def test_a_model_is_no_surer_than_the_velocities_that_it_agrees_with(made: Fit) -> None:
    own, e = made.sd("e"), made.parameters.e
    assert doubted(made, velocities(e, 0.5 * own), told=False).covariance == made.covariance
    found = doubted(made, velocities(e + 2.0 * own, 3.0 * own), told=False)
    assert found.sd("e") == pytest.approx(3.0 * own, rel=1e-12)
    known = doubted(made, velocities(e + 2.0 * own, 3.0 * own), told=True)  # the form of the brake
    assert known.covariance == made.covariance
    assert found.sd("ln_ratio") == made.sd("ln_ratio")
    assert found.parameters == made.parameters


def test_of_what_noise_does_not_explain_half_is_one_standard_deviation_more(made: Fit) -> None:
    sd, apart = 0.01, 0.05
    found = doubted(made, velocities(made.parameters.e - apart, sd), told=False)
    more = found.sd("e") ** 2 - max(made.sd("e"), sd) ** 2
    assert more == pytest.approx(HALF**2 * (apart**2 - sd**2), rel=1e-9)


def test_a_form_is_told_where_all_others_miss_readings_by_much_more() -> None:
    ladder = [("nothing", 3.0), ("friction", 1.0), ("tilt", 2.0), ("drag", 1.01 * TOLD)]
    assert form_told("friction", ladder)
    assert not form_told("tilt", ladder)
    assert not form_told("friction", [*ladder[:3], ("drag", 0.99 * TOLD)])


def test_a_model_without_a_brake_has_none_of_another_form(made: Fit) -> None:
    plain = replace(made, asked=Asked(law="bumper", effect="none"))
    assert doubted(plain, velocities(0.2, 0.001), told=False) is plain


def test_carts_that_air_brakes_are_fitted_with_friction_and_the_interval_says_so() -> None:
    """It was four times too narrow: 0.706 ± 0.011 for 0.75."""
    found = analysed(film(DRAGGED, 60.0, 5e-4, seed=1)).report
    assert found["effect"] == "friction"
    e = next(row for row in found["known"] if row["key"] == "e")
    assert e["low"] < DRAGGED.e < e["high"]
    asked = analysed(film(DRAGGED, 60.0, 5e-4, seed=1), Wanted(effect="friction")).report
    sure = next(row for row in asked["known"] if row["key"] == "e")
    assert sure["high"] - sure["low"] < 0.5 * (e["high"] - e["low"])  # the reader's own to judge


@pytest.mark.parametrize(("drag", "even"), [("0 kg/s", True), ("0.05 kg/s", False)])
def test_a_cart_that_is_braked_otherwise_when_it_is_faster_is_not_told_by_friction_alone(
    drag: str, even: bool
) -> None:
    """Bearings and air together: what friction alone makes of them is 0.01 off, told to 0.006."""
    effects = ({"friction": {"coefficient": "0.01"}}, {"drag": {"linear": drag}})
    made = truth(ratio=0.6, e=0.8, v=(0.7, 0.0), after=2.0, effects=effects)
    story = analysed(film(made, 60.0, 3e-4)).story
    assert story.speeds is not None
    assert story.speeds.even is even
