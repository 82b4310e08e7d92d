"""Numbers beyond the range of floats: a run is refused where a step has them, and only there."""

from __future__ import annotations

import pytest

from sim.dynamics.loop.run import is_of_the_numbers, run
from sim.dynamics.result.outcome import UnsolvedError
from sim.scene import read_scene
from tests.processor_time import budget
from tests.regressions.given import cart

SOON = 20.0
"""s of processor time, on a slow machine; without a count of searches it is hours."""


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


def test_a_series_whose_coefficients_are_no_numbers_is_refused_and_no_search_goes_on() -> None:
    plain = {
        "carts": {"A": cart(0.1, 0.5, 1.92e-30), "B": cart(0.3, 0, 0.535)},
        "track": {"left": "wall", "right": "wall", "length": 0.55},
        "contact": {"law": "push-only", "restitution": 0.5, "stiffness": 105_000},
        "effects": [{"incline": {"angle": "3 deg"}}],
        "until": 3,
    }
    with pytest.raises(UnsolvedError, match="too large or too small"):
        run(read_scene(plain))


def test_searches_among_millions_of_swings_count_as_steps_and_end() -> None:
    """D swings 10^7 times a second on its spring while C comes near; none of it is a step."""
    plain = {
        "carts": {"C": cart(1, -1), "D": cart(1.3, -0.3, 1e-19), "E": cart(1.7, 0.5)},
        "contact": {"law": "push-only", "stiffness": 13.9},
        "effects": [{"spring": {"between": ["D", "E"], "stiffness": 2.07, "length": 0.3}}],
        "until": 3,
    }
    with budget(SOON):
        done = run(read_scene(plain), max_steps=500)
    assert done.stopped is not None


@pytest.mark.parametrize(
    ("error", "is_"),
    [
        (OverflowError("math range error"), True),
        (ValueError("math domain error"), True),
        (ValueError("expected a nonnegative input, got -1.0"), True),
        (ValueError("-inf + inf in fsum"), True),
        (ValueError("cannot convert float NaN to integer"), True),
        (ValueError("not enough values to unpack (expected 2, got 1)"), False),
        (ValueError("zip() argument 2 is shorter than argument 1"), False),
        (ValueError("max() iterable argument is empty"), False),
        (UnsolvedError("no solver", "none", 0.0, ()), False),
    ],
)
def test_only_what_numbers_do_is_called_too_large_a_number(error: ValueError, is_: bool) -> None:
    """A mistake of ours rises as what it is."""
    assert is_of_the_numbers(error) == is_
