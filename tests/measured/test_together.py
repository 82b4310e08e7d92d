"""Carts that seem to stick: whether their distance grows afterwards tells more than velocities."""

from __future__ import annotations

from random import Random
from typing import Any

import numpy as np
import pytest

from sim.measured.analysis import analysed
from sim.measured.events.together import together
from sim.measured.tracks import read_measured


def report(e: float, noise: float, after: float = 1.0, rate: int = 50) -> dict[str, Any]:
    """A with 0.4 m/s meets B, its equal and at rest, at 1 s."""
    r, rows = Random(3), ["t (s),x_A (m),x_B (m)"]
    for k in range(round((1.0 + after) * rate)):
        t = k / rate
        late = max(t - 1.0, 0.0)
        a, b = 0.4 * (t - late) + 0.2 * (1.0 - e) * late, 0.6 + 0.2 * (1.0 + e) * late
        rows.append(f"{t:.4f},{a + r.gauss(0, noise):.5f},{b + r.gauss(0, noise):.5f}")
    return analysed(read_measured(["\n".join(rows)])).report


def test_carts_whose_distance_grows_do_not_stick() -> None:
    told = report(0.05, 3e-4)
    assert told["outcome"] == "bounce"
    (e,) = (one for one in told["known"] if one["key"] == "e")
    assert e["low"] <= 0.05 <= e["high"] < 0.15


def test_carts_that_keep_their_distance_stick_and_have_no_bounciness() -> None:
    told = report(0.0, 3e-4)
    assert told["outcome"] == "stick"
    assert "There is no bounciness." in told["sentences"][0]


@pytest.mark.parametrize("e", [0.0, 0.03, 0.07])
def test_where_noise_hides_a_parting_e_is_told_as_below_a_limit(e: float) -> None:
    told = report(e, 1e-3, after=0.25)
    assert told["outcome"] == "stick"
    first = told["sentences"][0]
    limit = float(first.rstrip(".").rsplit(" ", 1)[1])
    assert "as far as these readings show" in first and e < limit < 0.3
    assert f"e is below {limit:.2f}" in next(o for o in told["untold"] if o["key"] == "e")["reason"]


def test_too_few_common_instants_tell_nothing() -> None:
    early, late = np.array([0.1, 0.2, 0.3, 0.4]), np.array([0.35, 0.4, 0.5, 0.6])
    side = early, np.zeros(4)
    assert together([side, side, side, (late, late)]) is None
