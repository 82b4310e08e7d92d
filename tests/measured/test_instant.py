"""Of a fitted brake the form is never quite right: that must not make a short contact last."""

from __future__ import annotations

from typing import Any

import numpy as np

from sim.measured.analysis import analysed
from sim.measured.model.fit import Asked, fit
from sim.measured.model.instant import perhaps_instant
from sim.measured.model.lasting import MEANS, frame_of
from sim.measured.tracks import read_measured
from tests.measured.makers import film, truth

BRAKED: tuple[dict[str, Any], ...] = ({"friction": {"coefficient": 0.012}},)
RATE = 50


def rolling(seed: int) -> str:
    """An instant bounce, e = 0.7, equals; the brake grows with the velocity from 0.08 m/s² on."""
    dice, t, v = np.random.default_rng(seed), 0.0, np.array([0.9, 0.2])
    x, met, rows = np.array([0.2, 0.9]), False, ["t (s),x_A (m),x_B (m)"]
    for _ in range(2 * RATE):
        a, b = x + 5e-4 * dice.standard_normal(2)
        rows.append(f"{t:.4f},{a:.5f},{b:.5f}")
        for _ in range(200):
            h = 1.0 / RATE / 200
            x, v, t = x + h * v, v - h * (0.08 + 0.06 * v) * (v > 0.0), t + h
            if not met and x[1] - x[0] <= 0.2:
                met, mean, apart = True, v.mean(), v[0] - v[1]
                v = np.array([mean - 0.35 * apart, mean + 0.35 * apart])
    return "\n".join(rows)


def test_a_contact_as_short_as_a_frame_is_not_told_to_last_for_several() -> None:
    for seed in range(3):
        report = analysed(read_measured([rolling(seed)])).report
        assert report["outcome"] == "bounce"
        for one in report["known"]:
            assert one["key"] != "duration" or one["low"] < 1.0 / RATE


def test_a_long_contact_and_one_without_a_brake_are_told_as_before() -> None:
    long = film(truth(contact=0.2, effects=BRAKED), 60, 3e-4)
    made = fit(long, Asked(effect="friction"))
    assert made.duration > MEANS * frame_of(long)
    assert perhaps_instant(made, long) is made
    plain = film(truth(contact=0.05), 60, 3e-4)
    made = fit(plain)
    assert perhaps_instant(made, plain) is made


def test_a_contact_that_readings_show_to_last_keeps_its_length() -> None:
    measured = film(truth(contact=0.1, effects=BRAKED), 60, 3e-4)
    made = fit(measured, Asked(effect="friction"))
    assert made.duration < MEANS * frame_of(measured)
    assert perhaps_instant(made, measured) is made
