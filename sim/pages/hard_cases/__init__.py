"""Hard cases: scenes that break step-by-step engines. One home, for the tests and for the page."""

from __future__ import annotations

from sim.pages.hard_cases.collisions import CRADLES, IMPACTS, PI
from sim.pages.hard_cases.row import HardCase
from sim.pages.hard_cases.under_effects import DRY
from sim.pages.hard_cases.under_forces import FORCES, LONG
from sim.pages.language import mark

GROUPS: tuple[tuple[str, tuple[HardCase, ...]], ...] = (
    (mark("Digits of π"), tuple(PI)),
    (mark("Impacts"), tuple(IMPACTS)),
    (mark("Cradles"), tuple(CRADLES)),
    (mark("Friction and slopes"), tuple(DRY)),
    (mark("Air, magnets, springs, pushes"), tuple(FORCES)),
    (mark("Long times, many carts"), tuple(LONG)),
)
"""All cases under the headings of the page."""

ALL: tuple[HardCase, ...] = tuple(case for _, cases in GROUPS for case in cases)

__all__ = ["ALL", "GROUPS", "HardCase"]
