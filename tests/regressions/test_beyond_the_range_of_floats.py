"""Numbers beyond the range of floats: a run is refused where a step has them, and only there."""

from __future__ import annotations

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.outcome import UnsolvedError
from sim.scene import read_scene
from tests.regressions.given import cart


def test_magnets_that_are_met_too_fast_for_the_range_of_floats_are_refused() -> None:
    """Two magnets of F = C/r never stop what comes at 20 km/s. Near them the coefficients of the
    series, 1/s to the 26th power, leave the range: steps took no time, without end."""
    plain = {
        "carts": {"A": cart(0.1, 1e4), "B": cart(0.31, -1e4)},
        "effects": [
            {"magnets": {"between": ["A", "B"], "strength": 1e-3, "power": 1}},
            {"spring": {"between": ["A", "B"], "stiffness": 50, "length": 0.02}},
        ],
        "until": 1,
    }
    with pytest.raises(UnsolvedError, match="too large or too small"):
        run(read_scene(plain), max_steps=1_000)


def test_a_trial_series_that_leaves_the_range_of_floats_refuses_nothing() -> None:
    """A strong damper beside magnets is tried as led; where that does not converge the plain series
    goes on. The damper takes A's motion at once, the magnets push B: energy and momentum close."""
    plain = {
        "carts": {"A": cart(0.1, mass=0.54), "B": cart(0.4, mass=0.233)},
        "track": {"left": "wall"},
        "effects": [
            {"drag": {"quadratic": 0.02}},
            {"spring": {"between": ["left", "A"], "stiffness": 5.22, "length": 0.1, "damping": 50}},
            {"magnets": {"between": ["A", "B"], "strength": 0.000558, "power": 1.5}},
        ],
        "until": 1,
    }
    done = run(read_scene(plain), max_steps=2_000)
    assert done.stopped is None
    assert done.ledger.imbalance() < 1e-13
