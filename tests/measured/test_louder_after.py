"""Numbers read by eye scatter little while a cart hardly moves, and much when it runs: what the
noise is before a contact says nothing of the noise after it."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import pytest

from sim.measured.analysis import analysed
from sim.measured.track import Track
from sim.measured.tracks import Measured
from tests.measured.makers import film, truth

SOFT = truth(mass=0.3, ratio=0.6, e=0.95, v=(0.42, 0.008), contact=0.3, gap=0.6, after=1.6)
SCALE = 1e-3  # m, what the air track's own scale shows
FRAMES = 0.1  # s, three of them: what smooths the velocities


def by_eye(seed: int) -> Measured:
    """Magnets that push for 0.3 s, read on a scale frame by frame; the struck cart creeps."""
    noise = Random(seed)

    def read(cart: int, t: float, x: float) -> float:
        creeps = cart == 1 and t < SOFT.touch
        seen = x if creeps else x + noise.gauss(0.0, SCALE)
        return round(seen / SCALE) * SCALE

    def read_all(cart: int, track: Track) -> Track:
        pairs = zip(track.t, track.value, strict=True)
        return replace(track, value=tuple(read(cart, t, x) for t, x in pairs))

    of = film(SOFT, 30.0, 0.0, seed)
    return replace(of, tracks=(read_all(0, of.tracks[0]), read_all(1, of.tracks[1])))


@pytest.mark.parametrize("seed", [6, 8, 10])
def test_a_contact_ends_though_the_readings_scatter_more_after_it(seed: int) -> None:
    """It went on for 0.3 to 1.4 s more, up to the last reading."""
    found = analysed(by_eye(seed))
    assert found.story.contact
    assert found.story.contact.end < SOFT.touch + SOFT.contact + FRAMES
    told = {row["key"]: row for row in found.report["known"]}
    assert told["e"]["low"] < SOFT.e < told["e"]["high"]
    assert told["mass_ratio"]["low"] < SOFT.ratio < told["mass_ratio"]["high"]
