"""Readings without a contact are refused in words."""

from __future__ import annotations

import pytest

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
