"""What a fit finds is what the simulator was told; what cannot be known is not printed."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from sim.measured.model.effects import called_for, compare
from sim.measured.model.fit import Asked, Fit, fit
from sim.measured.model.known import quantities_of_fit
from sim.measured.model.motion import Motion, Parameters
from sim.measured.report import motion_report
from sim.measured.tracks import Measured
from sim.measured.words.fit import of_balance
from tests.measured.cramer_rao import bound
from tests.measured.makers import TOLD, film, random_truth, truth

FRICTION = ({"friction": {"coefficient": "0.005"}},)
TILT = ({"incline": {"angle": "0.3 deg"}},)
EXACTLY = 1e-12  # m
SECOND_ORDER = 5e-7  # m; instants of turning are those without friction


@pytest.mark.parametrize("law", ["bumper", "paper"])
@pytest.mark.parametrize(
    ("effect", "listed", "left"),
    [("none", (), EXACTLY), ("tilt", TILT, EXACTLY), ("friction", FRICTION, SECOND_ORDER)],
)
def test_without_noise_the_model_is_the_simulators_run(
    law: Any, effect: Any, listed: Any, left: float
) -> None:
    made = truth(law=law, effects=listed, v=(0.8, -0.3))
    found = fit(film(made, noise=0.0), Asked(law=law, effect=effect))
    assert max(abs(r) for track in found.residuals for r in track) < left
    tolerance = 1e-6 if effect != "friction" else 1e-3
    assert found.parameters.e == pytest.approx(made.e, abs=tolerance)
    assert found.parameters.ratio == pytest.approx(made.ratio, rel=tolerance)
    assert found.parameters.w0 == pytest.approx(made.w0, rel=tolerance)


def test_friction_of_each_cart_and_a_tilt_are_found() -> None:
    braked = fit(film(truth(effects=FRICTION), noise=0.0), Asked(effect="friction"))
    assert braked.parameters.friction == pytest.approx((0.005 * 9.81,) * 2, rel=1e-3)
    tilted = fit(film(truth(effects=TILT, v=(0.8, -0.3)), noise=0.0), Asked(effect="tilt"))
    wanted = 9.81 * math.sin(math.radians(0.3))
    assert tilted.parameters.tilt == pytest.approx(wanted, rel=1e-6)


@pytest.mark.parametrize("rests", [True, False])
def test_a_cart_that_stands_still_before_the_touch_is_seen(rests: bool) -> None:
    made = truth(effects=FRICTION, v=(0.8, 0.0 if rests else -0.2))
    found = fit(film(made), Asked(effect="friction"))
    assert found.parameters.rests == (False, rests)


def test_the_true_value_lies_in_the_interval_as_often_as_promised() -> None:
    inside: Counter[str] = Counter()
    films = 60
    for seed in range(films):
        made, rate = random_truth(seed)
        found = fit(film(made, rate, seed=seed))
        for key in TOLD:
            value = found.values[found.unknowns.index(key)]
            inside[key] += abs(value - made.of(key)) <= found.factor * found.sd(key)
    # Binomial: 360 looks at 95 % scatter by 1.2 % (by more, as those of one film go together).
    assert 0.90 <= sum(inside.values()) / (films * len(TOLD)) <= 0.99
    # With one kind in 60 films, 5 misses are more than three standard deviations too many.
    assert all(count >= films - 9 for count in inside.values()), inside


def test_velocities_after_the_contact_lie_in_their_intervals_as_often_as_promised() -> None:
    inside, looks = 0, 0
    for seed in range(30):
        made, rate = random_truth(seed)
        found = fit(film(made, rate, seed=seed))
        known = {one.key: one for one in quantities_of_fit(found, ("A", "B"))[0]}
        m1, m2 = 1.0, made.ratio
        centre = (m1 * made.v[0] + m2 * made.v[1]) / (m1 + m2)
        apart = made.e * (made.v[1] - made.v[0]) / (m1 + m2)  # e turns the approach round
        for key, true in (("v_a_after", centre + m2 * apart), ("v_b_after", centre - m1 * apart)):
            one = known[key]
            inside += one.low <= true <= one.high
            looks += 1
            assert one.sd < 0.1 * abs(made.v[0] - made.v[1])
    assert 0.88 <= inside / looks <= 1.0  # 60 looks at 95 % scatter by 2.8 %


@pytest.mark.parametrize("rate", [30, 60, 240])
def test_standard_deviations_are_those_of_the_cramer_rao_bound(rate: int) -> None:
    made = truth(contact=0.15, v=(0.8, -0.2))
    wanted = bound(made, rate)
    found = [fit(film(made, rate, seed=seed)) for seed in range(5)]
    for key in TOLD:
        told_sd = float(np.mean([one.sd(key) for one in found]))
        assert told_sd == pytest.approx(wanted[key], rel=0.2), key


def keys(listed: Any) -> set[str]:
    return {one.key for one in listed}


def test_masses_and_stiffness_are_refused_until_a_cart_was_weighed() -> None:
    made = truth()
    measured = film(made)
    found = fit(measured)
    known, untold = quantities_of_fit(found, ("A", "B"))
    assert {"mass", "k"} <= keys(untold)
    assert not {"mass", "k"} & keys(known)
    for name, kg in (("A", 0.5), ("B", 1.0)):
        known, untold = quantities_of_fit(found, ("A", "B"), (name, kg))
        values = {one.key: one for one in known}
        assert not keys(untold)
        assert values["mass"].low <= 1.5 - kg <= values["mass"].high
        stiffness = made.scene.contacts[1].stiffness  # type: ignore[union-attr]
        assert values["k"].low <= stiffness <= values["k"].high


def test_the_same_film_comes_out_with_all_masses_and_k_doubled() -> None:
    light, heavy = truth(mass=0.4), truth(mass=0.8)
    a, b = film(light, noise=0.0), film(heavy, noise=0.0)
    assert a.tracks[0].value == pytest.approx(b.tracks[0].value, abs=1e-13)


def test_a_hard_contact_between_two_frames_is_not_timed() -> None:
    measured = film(truth(contact=0.004, v=(0.8, -0.3)), rate=30)
    known, untold = quantities_of_fit(fit(measured), ("A", "B"))
    assert {"duration", "w0"} <= keys(untold)
    assert {"e", "mass_ratio"} <= keys(known)
    assert all("frames" in one.reason for one in untold if one.key in ("duration", "w0"))


def test_the_distance_at_the_touch_tells_how_long_a_short_contact_lasts() -> None:
    made = truth(contact=0.03, v=(0.8, -0.3))
    measured = film(made, rate=120)
    free, held = fit(measured), fit(measured, Asked(distance=0.2))
    assert held.sd("ln_w0") < 0.5 * free.sd("ln_w0")
    value = held.values[held.unknowns.index("ln_w0")]
    assert abs(value - math.log(made.w0)) <= held.factor * held.sd("ln_w0")


@pytest.mark.parametrize(
    ("listed", "wanted"), [((), "none"), (FRICTION, "friction"), (TILT, "tilt")]
)
def test_the_residuals_say_which_effect_a_film_calls_for(listed: Any, wanted: str) -> None:
    measured = film(truth(effects=listed, v=(0.8, -0.3)), rate=120)
    rows = compare(measured, fit(measured))
    assert called_for(rows) == wanted


def test_residuals_that_follow_each_other_are_told() -> None:
    measured = film(truth(effects=TILT, v=(0.8, -0.3)))
    plain = fit(measured)
    report = motion_report(measured, plain, compare(measured, plain))
    assert any("not random" in sentence for sentence in report["sentences"])
    better = next(row.fit for row in compare(measured, plain) if row.effect == "tilt")
    report = motion_report(measured, better, compare(measured, plain))
    assert not any("not random" in sentence for sentence in report["sentences"])


def test_two_weighed_carts_are_compared_with_their_motion() -> None:
    measured = film(truth())
    known, _ = quantities_of_fit(fit(measured), ("A", "B"))
    ratio = next(one for one in known if one.key == "mass_ratio")
    assert "They agree" in of_balance(ratio, {"A": 0.5, "B": 1.0}, ("A", "B"))
    assert "do not agree" in of_balance(ratio, {"A": 0.5, "B": 1.2}, ("A", "B"))


def test_an_impossible_bounciness_is_told() -> None:
    made = Motion(
        Parameters(touch=0.4, x=0.8, distance=0.2, v=(0.8, 0.0), ratio=1.5, e=1.2, w0=20.0),
        "bumper",
    )
    measured = film(truth())
    tracks = [
        replace(
            track, value=tuple(made.state(t)[0][k] + r for t, r in zip(track.t, noise, strict=True))
        )
        for k, (track, noise) in enumerate(
            zip(measured.tracks, fit(measured).residuals, strict=True)
        )
    ]
    measured = Measured("length", (tracks[0], tracks[1]), ())
    found = fit(measured)
    assert found.parameters.e == pytest.approx(1.2, abs=0.02)
    assert any("e is above 1" in one for one in motion_report(measured, found)["sentences"])


def test_centimetres_taken_for_metres_are_noticed() -> None:
    measured = film(truth())
    tracks = [
        replace(track, value=tuple(100 * x for x in track.value)) for track in measured.tracks
    ]
    large = Measured("length", (tracks[0], tracks[1]), ())
    said = motion_report(large, fit(large))["sentences"]
    assert any("really in the units" in one for one in said)
    said = motion_report(measured, fit(measured))["sentences"]
    assert not any("really in the units" in one for one in said)


@pytest.mark.parametrize("e", [0.0, 1.0])
def test_carts_that_stay_together_and_carts_that_lose_nothing_are_fitted(e: float) -> None:
    measured = film(truth(e=e, v=(0.8, -0.1)))
    found: Fit = fit(measured)
    assert abs(found.parameters.e - e) <= 1.5 * found.factor * found.sd("e") + 1e-3
