"""A cart that rolls out by friction is no stop, and its rest is no motion."""

from __future__ import annotations

import numpy as np
import pytest

from sim.measured.analysis import analysed
from sim.measured.events.stops import comes_to_rest
from sim.measured.tracks import Measured
from tests.measured.makers import film, truth

RATIO, E = 2.0, 0.8
RESTS = 5.0
"""s filmed after the contact: both carts rest long before."""

SURELY = 1.5
"""Half-widths of a 95 % interval: of these few films none may miss the truth by more."""


def rolled(mu: float, rate: float = 50.0, noise: float = 5e-4, v: float = 0.8) -> Measured:
    effects = ({"friction": {"coefficient": str(mu)}},)
    made = truth(ratio=RATIO, e=E, v=(v, 0.0), after=RESTS, effects=effects)
    return film(made, rate, noise)


@pytest.mark.parametrize("mu", [0.006, 0.012, 0.02, 0.03])
@pytest.mark.parametrize(("rate", "noise"), [(20.0, 5e-4), (50.0, 5e-4), (50.0, 1e-3)])
def test_carts_that_roll_out_are_fitted_and_the_intervals_hold_the_truth(
    mu: float, rate: float, noise: float
) -> None:
    found = analysed(rolled(mu, rate, noise))
    assert found.refused is None
    known = {row["key"]: row for row in found.report["known"]}
    for key, true in (("e", E), ("mass_ratio", RATIO)):
        if key in known:  # what is too wide is not printed
            half = 0.5 * (known[key]["high"] - known[key]["low"])
            assert abs(known[key]["value"] - true) < SURELY * half
    assert "e" in known or "mass_ratio" in known or rate < 50.0


def test_a_long_even_parabola_down_to_rest_is_friction_and_no_stop() -> None:
    found = analysed(rolled(0.012, v=0.6))
    after = [s for s in found.story.segments if s.cart == 1 and s.begin > 0.7]
    assert [s.kind for s in after] == ["friction", "rest"]
    assert after[0].end - after[0].begin > 1.5


def test_the_contact_ends_before_both_carts_have_rolled_out() -> None:
    contact = analysed(rolled(0.03)).story.contact
    assert contact and contact.end - contact.begin < 0.3


@pytest.mark.parametrize("rate", [30.0, 60.0, 120.0])
def test_a_cart_that_a_bounce_leaves_slow_rolls_out_before_it_rests(rate: float) -> None:
    """A tenth of its speed is left: 20 mm in half a second, forty times the noise."""
    made = truth(
        ratio=2.0, e=0.7, v=(0.6, 0.0), after=1.7, effects=({"friction": {"coefficient": "0.01"}},)
    )
    found = analysed(film(made, rate, 5e-4))
    after = [s for s in found.story.segments if s.cart == 0 and s.begin > 0.7]
    assert [s.kind for s in after] == ["friction", "rest"]
    known = {row["key"]: row for row in found.report["known"]}
    assert known["e"]["low"] < 0.7 < known["e"]["high"]
    assert known["e"]["high"] - known["e"]["low"] < 0.2


@pytest.mark.parametrize("e", [0.59, 0.6, 0.61])
def test_a_cart_that_stops_soon_after_the_contact_had_a_velocity(e: float) -> None:
    """40 mm/s, for a fifth of a second: in one line with the rest behind it, it was 4 ± 6 mm/s."""
    effects = ({"friction": {"coefficient": "0.02"}},)
    made = truth(ratio=2.0, e=e, v=(0.6, 0.0), after=1.7, effects=effects)
    known = {row["key"]: row for row in analysed(film(made, 120.0, 3e-4)).report["known"]}
    assert known["v_a_after"]["high"] < -0.01
    assert known["e"]["low"] < e < known["e"]["high"]


def test_readings_that_are_all_alike_are_a_rest() -> None:
    t = np.arange(60) / 30.0
    for x in (np.full(60, 0.5), np.full(60, 0.123), np.round(0.5 + 1e-4 * (t > 1), 3)):
        assert comes_to_rest(t, x) is None
