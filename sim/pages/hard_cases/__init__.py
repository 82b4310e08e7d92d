"""Hard cases: scenes that break step-by-step engines. One home, for the tests and for the page."""

from __future__ import annotations

from sim.pages.hard_cases.collisions import COLLISIONS
from sim.pages.hard_cases.row import HardCase
from sim.pages.hard_cases.under_effects import UNDER_EFFECTS

ALL: tuple[HardCase, ...] = (*COLLISIONS, *UNDER_EFFECTS)

__all__ = ["ALL", "HardCase"]
