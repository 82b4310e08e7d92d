"""What every contact law of finite duration has to say.

* `IsolatedContact`: what one from first touch comes to, per unit of approach speed (every linear
  law scales with that speed), and
* `stretches`: the closed form of the overlap from any start, for drawing and for hard cases,
* `branch` and `guards`: the same part by part, where others push too.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Protocol

from sim.laws.branch import Branch, Guard
from sim.laws.damped_oscillation import Swing

if TYPE_CHECKING:
    from sim.laws.stepping import SteppedContact

Memory = float
"""m. The greatest overlap that a bumper has seen since it was last clear; 0 for other laws."""


def reduced_mass(a: float, b: float) -> float:
    """kg; a wall, and what sticks to it, is infinite."""
    return min(a, b) if math.inf in (a, b) else a * b / (a + b)


@dataclass(frozen=True, slots=True)
class IsolatedContact:
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


class ContactLaw(Protocol):
    """A law of finite duration. Overlaps d in m, their rates v in m/s, mu: reduced mass in kg."""

    linear: ClassVar[bool]
    """Is one isolated contact a closed form? Else the law is integrated."""
    recontacts: ClassVar[bool]
    """May a pair that separated with an overlap push again before the overlap has cleared?"""
    held_below: ClassVar[float]
    """Restitution below which, in a group of contacts, it is held at its greatest overlap."""
    grows: ClassVar[tuple[float, float]]
    """Powers (p, q): for an overlap r times as great, a stiffness r^p times as small, a speed r^q
    times as great."""

    @property
    def stiffness(self) -> float:
        """N/m, or in the law's own unit."""

    @property
    def e(self) -> float:
        """Restitution asked for."""

    @property
    def steepest(self) -> float:
        """N/m (or the law's own unit). Of its steepest line, for the length of a step."""

    def figures(self, mu: float) -> IsolatedContact:
        """The isolated contact from first touch."""

    def stretches(self, mu: float, d0: float, v0: float, memory: Memory) -> tuple[Swing, ...]:
        """The contact from overlap d0 and rate v0 until the force is zero."""

    def force(self, mu: float, d: float, v: float) -> float:
        """N, of a law that remembers nothing; not clipped."""

    def damper(self, mu: float) -> float:
        """N s/m (or the law's own unit) of its damper; 0 without one."""

    def branch(self, mu: float, d: float, v: float, memory: Memory, *, pressing: bool) -> Branch:
        """The linear branch that holds just after now; `pressing`: about to be pressed further."""

    def guards(self, branch: Branch, d: float, memory: Memory) -> tuple[Guard, ...]:
        """What ends this branch."""

    def resting_overlap(self, memory: Memory) -> float:
        """m. While a pair flies, its force turns positive when the overlap grows beyond this."""

    def residual_overlap(self, d: float, memory: Memory) -> float:
        """m. The overlap at which a contact that was found to end at d has its end exactly."""

    def last_force(self, mu: float, v: float) -> float:
        """N just before the end, at the rate v."""

    def stored(self, d: float, v: float, memory: Memory) -> float:
        """J. Energy that the contact would give back."""

    def stored_under(self, d: float, force: float) -> float:
        """J. The same from the overlap and the force [N] there (0: they have parted)."""

    def dissipated(self, mu: float, d: float, v: float) -> float:
        """W. What a curved law's damper takes just now."""

    def kept(self, branch: Branch, start: float, end: float) -> float:
        """J. What a branch without a damper keeps for good between two overlaps."""

    def remember(self, d: float, memory: Memory) -> Memory:
        """The memory after an overlap of d."""

    def stepping(self, mu: float) -> SteppedContact:
        """Its force as stepping methods ask for it."""
