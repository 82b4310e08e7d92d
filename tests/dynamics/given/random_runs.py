"""Runs of random scenes in which effects act: how many, how long, and the run itself."""

from __future__ import annotations

from typing import Any

from hypothesis import HealthCheck, settings

from sim.dynamics.loop.run import run
from sim.dynamics.result.outcome import UnsolvedError
from sim.scene import read_scene

MOST = 300
"""Events. Impacts that crowd at one instant under forces are costly; the laws hold at any time."""
SETTINGS = settings()
FEWER = settings(
    max_examples=max(1, SETTINGS.max_examples // 3), suppress_health_check=list(HealthCheck)
)
"""Integration takes a hundred times as long as the run; and where a law needs two long runs."""
HALF = settings(max_examples=max(1, SETTINGS.max_examples // 2))


def finished(plain: dict[str, Any], **kept: bool) -> Any:
    """The run; None where it is refused in words, as magnets too weak to part their carts are."""
    try:
        return run(read_scene(plain), max_events=MOST, **kept)
    except UnsolvedError:
        return None


FEW = 12
"""Changes of formula. After more of them rounding may decide what comes first."""
