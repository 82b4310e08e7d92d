"""Hard cases: scenes that break step-by-step engines. One home, for the tests and for the page."""

from __future__ import annotations

from sim.pages.hard_cases.collisions import CRADLES, IMPACTS, PI
from sim.pages.hard_cases.row import HardCase
from sim.pages.hard_cases.under_effects import DRY
from sim.pages.hard_cases.under_forces import FORCES, LONG

GROUPS: tuple[tuple[str, tuple[HardCase, ...]], ...] = (
    ("Digits of π", tuple(PI)),
    ("Impacts", tuple(IMPACTS)),
    ("Cradles", tuple(CRADLES)),
    ("Friction and slopes", tuple(DRY)),
    ("Air, magnets, springs, pushes", tuple(FORCES)),
    ("Long times, many carts", tuple(LONG)),
)
"""All cases under the headings of the page."""

ALL: tuple[HardCase, ...] = tuple(case for _, cases in GROUPS for case in cases)

__all__ = ["ALL", "GROUPS", "HardCase"]
