"""bumper: bilinear hysteresis, the default of student lessons (Walton & Braun's force law).

    pressing in     N = k d                              up to the greatest overlap dm
    springing back  N = (k/e²) (d − (1 − e²) dm)         until N = 0

The force starts from zero, never pulls, and the delivered restitution is exactly e for
0 <= e <= 1. With w = sqrt(k/mu) and approach speed u:

    dm = u/w      N_max = u sqrt(k mu) for every e      duration = (pi/2) (1 + e)/w
    separation speed e u      overlap left at separation (1 − e²) dm

e = 0 ends at the greatest overlap with equal velocities. The overlap dm is remembered until the
bumpers are clear of each other: pressed again before that, the force climbs the steep line
first. The part 1 − e² of the work pressed in warms the bumpers; e² is given back.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from sim.laws.branch import APART_AT_NO_FORCE, LOCKED, Branch, Guard
from sim.laws.contact_law import IsolatedContact, Memory
from sim.laws.damped_oscillation import Swing, undamped

if TYPE_CHECKING:
    from sim.laws.stepping import SteppedContact

RIGID = 1e-7
"""Restitution. In a group of contacts, a bumper that springs back less than this is held at its
greatest overlap as one with e = 0 is: followed exactly it would swing 1/e times as fast as all
else, and when the group ends it does not spring back. Velocities are off by at most this part of
the approach speed; a pair that is alone from touch to separation is exact."""


@dataclass(frozen=True, slots=True, eq=False)
class Bumper:
    """Bilinear hysteresis with stiffness k [N/m] and restitution e."""

    linear: ClassVar[bool] = True
    recontacts: ClassVar[bool] = False
    held_below: ClassVar[float] = RIGID
    grows: ClassVar[tuple[float, float]] = (2.0, 1.0)
    stiffness: float
    e: float

    @property
    def steepest(self) -> float:
        """Springing back."""
        return self.stiffness / self.e**2 if self.e else self.stiffness

    def figures(self, mu: float) -> IsolatedContact:
        """Two quarter swings, the second e times as long as the first."""
        w = math.sqrt(self.stiffness / mu)
        quarter = 0.5 * math.pi / w
        return IsolatedContact(
            duration=quarter * (1.0 + self.e),
            e=self.e,
            out_overlap=(1.0 - self.e * self.e) / w,
            peak_time=quarter,
            peak_force=math.sqrt(self.stiffness * mu),
            peak_rate=0.0,
            peak_overlap=1.0 / w,
        )

    def stretches(self, mu: float, d0: float, v0: float, memory: Memory) -> tuple[Swing, ...]:
        """Climb back to the remembered overlap, press in, spring back: those of them that occur."""
        out: list[Swing] = []
        w = math.sqrt(self.stiffness / mu)
        t, d, v = 0.0, d0, v0
        memory = max(memory, d0)
        if self.e <= RIGID and d == memory and v == 0.0:
            return ()  # held so far, in a group; which of its ends came first is no matter
        if self.e > 0.0 and (d < memory or v < 0.0):
            steep, rest = undamped(w / self.e), self.resting_overlap(memory)
            if v < 0.0 and d <= rest:
                return ()  # out of force already, by rounding at least: it would pull for a swing
            reach = math.hypot(d - rest, v / steep.w)
            if reach <= memory - rest or v < 0.0:  # turns before the remembered overlap
                angle = math.atan2((d - rest) * steep.w, v)
                return (Swing(steep, 0.0, (math.pi - angle) / steep.w, rest, d - rest, v),)
            angle = math.asin((memory - rest) / reach) - math.asin((d - rest) / reach)
            out.append(Swing(steep, 0.0, angle / steep.w, rest, d - rest, v))
            t, d, v = angle / steep.w, memory, math.sqrt(reach**2 - (memory - rest) ** 2) * steep.w
        if v > 0.0:
            press = Swing(undamped(w), t, math.atan2(v, d * w) / w, 0.0, d, v)
            out.append(press)
            t, d = t + press.duration, math.hypot(d, v / w)
        if self.e > 0.0:
            steep = undamped(w / self.e)
            out.append(
                Swing(
                    steep,
                    t,
                    0.5 * math.pi / steep.w,
                    self.resting_overlap(d),
                    self.e * self.e * d,
                    0.0,
                )
            )
        return tuple(out)

    def resting_overlap(self, memory: Memory) -> float:
        """Where the springing-back line meets zero force."""
        return (1.0 - self.e * self.e) * memory

    def stored(self, d: float, v: float, memory: Memory) -> float:
        """e² of the work pressed in, on either line."""
        if d >= memory:
            return 0.5 * self.stiffness * self.e * self.e * d * d
        if self.e == 0.0:
            return 0.0
        over = d - self.resting_overlap(memory)
        return 0.5 * self.stiffness * over * over / (self.e * self.e) if over > 0.0 else 0.0

    def remember(self, d: float, memory: Memory) -> Memory:
        """The greatest overlap so far."""
        return max(d, memory)

    def force(self, mu: float, d: float, v: float) -> float:
        """Not defined by d and v alone: ask `branch`. Raises NotImplementedError."""
        raise NotImplementedError

    def damper(self, mu: float) -> float:
        """None."""
        return 0.0

    def branch(self, mu: float, d: float, v: float, memory: Memory, *, pressing: bool) -> Branch:
        """Pressing in, springing back, or held at its greatest overlap."""
        # a fresh touch without speed is about to be pressed: there is nothing to spring back yet
        if self.e == 1.0 or (d >= memory and (v > 0.0 or pressing or d == 0.0)):
            return Branch(self.stiffness, 0.0, 0.0)
        if self.e <= RIGID:
            return LOCKED
        return Branch(self.stiffness / self.e**2, 0.0, self.resting_overlap(max(memory, d)))

    def guards(self, branch: Branch, d: float, memory: Memory) -> tuple[Guard, ...]:
        """It comes apart, turns, or is pressed further."""
        if self.e == 1.0:
            return APART_AT_NO_FORCE
        if branch.locked:
            climb = Guard("climb", "force", rises=True, level=self.stiffness * d)
        elif branch.kappa == self.stiffness:
            return (*APART_AT_NO_FORCE, Guard("turn", "rate"))
        else:
            climb = Guard("climb", "overlap", rises=True, level=memory)
        return (*APART_AT_NO_FORCE, climb)

    def residual_overlap(self, d: float, memory: Memory) -> float:
        """Where the springing-back line meets zero force."""
        return self.resting_overlap(memory)

    def last_force(self, mu: float, v: float) -> float:
        """It ends where there is none."""
        return 0.0

    def stored_under(self, d: float, force: float) -> float:
        """e² N²/(2 k)."""
        push = max(0.0, min(force, self.stiffness * d))
        return (self.e * push) ** 2 / (2.0 * self.stiffness)

    def dissipated(self, mu: float, d: float, v: float) -> float:
        """No damper."""
        return 0.0

    def kept(self, branch: Branch, start: float, end: float) -> float:
        """The part 1 − e² of the work that presses in."""
        if branch.kappa != self.stiffness or self.e == 1.0:
            return 0.0
        kept = 0.5 * self.stiffness * (1.0 - self.e) * (1.0 + self.e)
        return kept * (end - start) * (end + start)

    def stepping(self, mu: float) -> SteppedContact:
        """Its two lines."""
        from sim.laws.bumper.stepping import BumperForce  # only where a method steps

        return BumperForce(self.stiffness, self.e)


make = Bumper
