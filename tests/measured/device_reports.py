"""What is found in the text of a device, and a motion as a logger of sensors writes it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from sim.measured.analysis import Wanted, analysed
from sim.measured.tracks import read_measured
from tests.measured.devices import Motion, sensor_carts

LOGGED = Motion(v=(0.5, 0.0), ratio=1.6, e=0.9, push=0.6, touch=1.3, lasts=0.2, until=3.0)
STICKS = Motion(v=(0.6, 0.0), e=0.0, push=0.6, touch=1.3, lasts=0.1, until=2.6)


def report(text: str, **masses: float) -> dict[str, Any]:
    measured = read_measured([text])
    names = dict(zip("AB", measured.names, strict=True))
    found = analysed(measured, Wanted(masses={names[k]: m for k, m in masses.items()}))
    return found.report


def known(told: dict[str, Any]) -> dict[str, dict[str, Any]]:
    return {one["key"]: one for one in told["known"]}


def lost_at_the_touch(ratio: float, seed: int = 1, after: float = 0.0) -> str:
    """The sensor of A loses it at the touch, or some s `after` it: the end of what it can read."""
    made = replace(STICKS, ratio=ratio)
    places = made.places(0, [0.05 * (k + 1) for k in range(round((made.touch + after) / 0.05))])
    return sensor_carts(made, seed, lost=places[-1] - places[0])
