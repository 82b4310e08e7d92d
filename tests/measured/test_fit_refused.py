"""Readings without a contact are refused in words, and so are velocities that none can give."""

from __future__ import annotations

from typing import Any

import pytest

from sim.measured.events.outcome import outcome_of
from sim.measured.events.sides import Speeds
from sim.measured.model.fit import fit
from sim.measured.refusal import FitError
from sim.measured.synthetic import filmed
from sim.measured.tracks import Measured, between
from sim.scene import read_scene
from tests.measured.makers import NOISE, film, truth


def parted() -> Measured:
    scene = read_scene({"carts": {"A": {"mass": 1, "position": 0.3, "velocity": 0.1},
                                  "B": {"mass": 1, "position": 0.9, "velocity": 0.5}},
                        "until": 1})  # fmt: skip
    return filmed(scene, rate=60, noise=NOISE, seed=1)


def before_only() -> Measured:
    return between(film(truth()), None, 0.3)


@pytest.mark.parametrize("measured", [parted(), before_only()], ids=["parting", "before only"])
def test_readings_without_a_contact_are_refused_in_words(measured: Measured) -> None:
    with pytest.raises(FitError) as caught:
        fit(measured)
    assert caught.value.hint


@pytest.mark.parametrize(
    ("e", "unsure", "found"),
    [
        (1.25, 0.0, "gained-energy"),
        (1.05, 0.01, "gained-energy"),
        (1.05, 0.05, "bounce"),  # within what the readings tell
        (1.0, 0.0, "bounce"),
        (-0.1, 0.0, "through-each-other"),
        (-0.05, 0.0, "stick"),
        (0.1, 0.0, "bounce"),
        (0.1, 0.04, "bounce"),
        (0.1, 0.06, "stick"),  # 0 is within 2.1 standard deviations
        (0.15, 0.2, "bounce"),
        (0.05, 0.0, "stick"),
        (0.07, 0.0, "bounce"),
    ],
)
def test_what_happened_follows_from_e_and_how_sure_it_is(
    e: float, unsure: float, found: str
) -> None:
    """A comes with 1 m/s and stops, B leaves with e m/s; only the last is unsure."""
    rows = [(0.0,) * 4] * 3 + [(0.0, 0.0, 0.0, unsure**2)]
    nothing: Any = None
    speeds = Speeds((1.0, 0.0, 0.0, e), tuple(rows), (0.0,) * 4, nothing, (), (), 0.0, 0.0)
    if found in ("bounce", "stick"):
        assert outcome_of(speeds) == found
        return
    with pytest.raises(FitError) as caught:
        outcome_of(speeds)
    assert caught.value.code == found
