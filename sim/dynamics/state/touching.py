"""The story of one contact from touch to separation, whoever else takes part in it.

A contact may begin as a closed form, be joined by a third body, and end as a closed form again.
What belongs to the whole of it is kept here: when it began, with which velocities, the impulse so
far, and its greatest force.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from sim.dynamics.state.clock import Time
from sim.effects.forces import EnergyRelease, LooseForce


@dataclass(slots=True)
class Peak:
    """The greatest force of a contact so far."""

    time: Time
    force: float  # N
    impulse: float  # N s, up to then
    after: tuple[float, float]  # m/s, of the left and the right body, then


@dataclass(slots=True)
class Touching:
    """One contact in progress."""

    begun: Time
    before: tuple[float, float]  # m/s, of the left and the right body at touch
    impulse: float = 0.0  # N s, booked so far: up to when the solver began
    peak: Peak | None = None
    pressing: bool = False  # a bumper at its greatest overlap that is about to be pressed further

    @property
    def has_pushed(self) -> bool:
        """Did the two ever push each other?"""
        return self.impulse > 0.0 or (self.peak is not None and self.peak.force > 0.0)

    def see(self, peak: Peak) -> None:
        """Keep the greater force; of equal ones the first."""
        if self.peak is None or peak.force > self.peak.force * (1.0 + HANDED_OVER):
            self.peak = peak

    def greatest(self, forces: Iterable[tuple[float, float]]) -> tuple[float, float] | None:
        """Of times and forces the pair whose force `see` would keep; None: that of before."""
        best, found = -math.inf if self.peak is None else self.peak.force, None
        for when, force in forces:
            if best == -math.inf or force > best * (1.0 + HANDED_OVER):
                best, found = force, (when, force)
        return found


@dataclass(slots=True)
class Loose:
    """A spring that was let go, and pushes until it falls off."""

    of: EnergyRelease
    link: LooseForce
    begun: Time
    before: tuple[float, float]  # m/s, of the left and right body when it was let go
    impulse: float = 0.0  # N s, booked so far
    ended: float = math.inf  # s, when it fell off


HANDED_OVER = 1e-12
"""Relative. A force that is handed from one solver to the next is not a new peak."""
