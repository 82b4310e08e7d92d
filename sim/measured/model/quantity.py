"""A quantity that readings tell, or the reason why they do not."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sim.scene.said import said


@dataclass(frozen=True, slots=True)
class Known:
    """A quantity with its 95 % interval, in `unit`."""

    key: str
    name: str
    value: float
    low: float
    high: float
    sd: float
    unit: str
    alone: tuple[float, float] | None = None
    """The interval that the readings alone give, where more is counted."""

    @property
    def half(self) -> float:
        """Half of the interval: what stands behind ±."""
        return 0.5 * (self.high - self.low)


@dataclass(frozen=True, slots=True)
class Untold:
    """A quantity that is not printed, and why."""

    key: str
    name: str
    reason: str


def known_and_untold(found: Sequence[Known | Untold]) -> tuple[list[Known], list[Untold]]:
    """Both kinds apart, each in the order it has."""
    known = [one for one in found if isinstance(one, Known)]
    return known, [one for one in found if isinstance(one, Untold)]


def not_shown(masses: str) -> str:
    """Why a motion tells none of `masses`, the plural of what would all be twice as large."""
    return said(
        "a motion does not show it: with {masses} twice as large, the same film comes out. Weigh "
        "one cart and give its mass",
        masses=masses,
    )
