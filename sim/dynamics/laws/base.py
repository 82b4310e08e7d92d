"""What every contact law of finite duration has to say."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from sim.dynamics.laws.swing import Swing

Memory = float
"""m. The greatest overlap that a bumper has seen since it was last clear; 0 for other laws."""


@dataclass(frozen=True, slots=True)
class Figures:
    """One isolated contact from first touch (d = 0) at approach speed 1 m/s.

    Times hold for every approach speed u; overlaps, rates and forces are to be multiplied by u.
    """

    duration: float  # s, inf: never separates
    e: float  # separation speed
    out_overlap: float  # m, left when the force becomes zero
    peak_time: float  # s, of the greatest force
    peak_force: float  # N
    peak_rate: float  # m/s, of overlap, at the greatest force
    peak_overlap: float  # m, greatest
    first_force: float = 0.0  # N, at touch
    last_force: float = 0.0  # N, just before the end; negative: pulls


class FiniteLaw(Protocol):
    """A contact law for one pair of neighbours with reduced mass mu."""

    @property
    def stiffness(self) -> float:
        """N/m."""

    @property
    def e(self) -> float:
        """Restitution asked for."""

    def figures(self, mu: float) -> Figures:
        """The isolated contact from first touch."""

    def stretches(self, mu: float, d0: float, v0: float, memory: Memory) -> tuple[Swing, ...]:
        """The contact from overlap d0 [m] and rate v0 [m/s] until the force is zero."""

    def resting_overlap(self, memory: Memory) -> float:
        """m. While a pair flies, its force turns positive when the overlap grows beyond this."""

    def stored(self, d: float, v: float, memory: Memory) -> float:
        """J. Energy that the contact would give back."""

    def remember(self, d: float, memory: Memory) -> Memory:
        """The memory after an overlap of d."""
