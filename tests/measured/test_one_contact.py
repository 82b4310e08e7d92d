"""Carts that catch each other shake: what a latch gives a moment later is the same contact."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from sim.measured.events.contacts import contacts
from sim.measured.events.grid import grid_of
from sim.measured.track import Track

BEGIN, LASTS, QUIET = 1.4, 0.08, 0.06
"""s. The catch, and how long nothing pushes until the second push."""

FINE, FRAMES = 1e-3, 20
"""s, and of these a frame: 50 frames a second."""


def shaken(seed: int) -> tuple[Track, Track]:
    """Places of both carts with noise of 0.06 mm: a push of 0.09 m/s, then one of 0.01 m/s."""
    t = np.arange(0.0, 3.2, FINE)
    random = np.random.default_rng(seed)

    def push(begin: float, change: float) -> NDArray[np.float64]:
        s = np.clip((t - begin) / LASTS, 0.0, 1.0)
        return np.asarray(change * s * s * (3.0 - 2.0 * s))

    after = BEGIN + LASTS + QUIET
    carts = {
        "A": (0.2, push(BEGIN, -0.088) + push(after, -0.010)),
        "B": (0.6, -0.188 + push(BEGIN, 0.082) + push(after, 0.008)),
    }
    seen = np.arange(0, len(t), FRAMES)
    noise = random.normal(scale=6e-5, size=(2, len(seen)))
    first, second = (
        Track(name, tuple(t[seen]), tuple((x + np.cumsum(v) * FINE)[seen] + own), tuple(seen + 1))
        for (name, (x, v)), own in zip(carts.items(), noise, strict=True)
    )
    return first, second


@pytest.mark.parametrize("seed", range(8))
def test_a_latch_that_shakes_is_one_contact(seed: int) -> None:
    (found,) = contacts(grid_of(shaken(seed)))
    assert found.begin < BEGIN + 0.02
    assert found.end > BEGIN + LASTS
