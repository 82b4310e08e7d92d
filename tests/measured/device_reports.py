"""What is found in the text of a device, and a motion as a logger of sensors writes it."""

from __future__ import annotations

from typing import Any

from sim.measured.analysis import Wanted, analysed
from sim.measured.tracks import read_measured
from tests.measured.devices import Motion

LOGGED = Motion(v=(0.5, 0.0), ratio=1.6, e=0.9, push=0.6, touch=1.3, lasts=0.2, until=3.0)


def report(text: str, **masses: float) -> dict[str, Any]:
    measured = read_measured([text])
    names = dict(zip("AB", measured.names, strict=True))
    found = analysed(measured, Wanted(masses={names[k]: m for k, m in masses.items()}))
    return found.report


def known(told: dict[str, Any]) -> dict[str, dict[str, Any]]:
    return {one["key"]: one for one in told["known"]}
