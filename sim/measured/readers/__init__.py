"""Readers of what devices write, a module each: `claims(text)` and `read(text, units)`.

A new device is a new module here and its name in `_ALL`, before `plain`, which takes everything.
"""

from __future__ import annotations

from types import ModuleType

from sim.measured.readers import (
    optitrack,
    phyphox,
    plain,
    qualisys,
    sensors,
    tracker_project,
    vicon,
)
from sim.measured.track import Reading
from sim.measured.units import Units

_ALL: tuple[ModuleType, ...] = (
    tracker_project, qualisys, optitrack, vicon, phyphox, sensors, plain,
)  # fmt: skip


def read_text(text: str, units: Units) -> Reading:
    """What one text holds; raises ReadingError."""
    text = text.removeprefix("\ufeff")
    reader = next(one for one in _ALL if one.claims(text))
    reading: Reading = reader.read(text, units)
    return reading
