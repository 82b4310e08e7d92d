"""A written law between the two bodies of one gap, as located steps ask for it.

Each side is asked for itself, at the same instant. Of two answers F_L and F_R [N]

    push = (F_L + F_R)/2       on both, in opposite directions: what Newton's third law leaves
    odd  = (F_L − F_R)/2       more on the left one and less on the right one

With `odd` = 0 this is a force between two bodies like any other. Where a step looks a little beyond
the end of a contact the law is asked at overlap 0: that is its own continuation, not a guess.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from sim.laws.stepping import Mode, TouchOrPart
from sim.mine.arguments import PLACES
from sim.mine.instance import Instance, too_large
from sim.mine.wrong import WrongLawError
from sim.scene.said import said

OVERLAP, RATE, TIME = (PLACES[name] for name in ("overlap", "rate", "time"))
VELOCITY_SELF, VELOCITY_OTHER = PLACES["velocity_self"], PLACES["velocity_other"]


FAR = 100.0
"""Times the closing speed. A well that a law digs may take carts in some times faster than they
came, and give them back."""

HUGE = 1e9
"""N. Where steps find no end beside such a force, it is the force."""

SLOW = 0.1
"""m/s. Of carts that close in less quickly, or stand, this is taken for it."""


@dataclass(slots=True)
class Side:
    """One of the two: what it is called and weighs [kg]; a wall is never asked."""

    name: str
    mass: float
    wall: bool = False


@dataclass(slots=True)
class Apart:
    """The instant at which the two answers differed most."""

    odd: float = 0.0  # N
    time: float = 0.0  # s
    left: float = 0.0  # N
    right: float = 0.0


@dataclass(slots=True)
class WrittenForce(TouchOrPart):
    """The force of one pair. `look` tells it of each instant before it is asked."""

    law: Instance
    sides: tuple[Side, Side]
    stiffness: float
    restitution: float
    right_first: bool = False
    time: float = field(default=0.0, init=False)
    rows: list[list[Any]] = field(init=False)
    asked: tuple[int, ...] = field(init=False)
    odd: float = field(default=0.0, init=False)
    greatest: float = field(default=0.0, init=False)
    """N. The greatest force that was answered so far."""
    apart: Apart = field(default_factory=Apart, init=False)
    last: tuple[float, float] = field(default=(0.0, 0.0), init=False)
    """N. What was answered last, to the left one and to the right one."""
    pushed: bool = field(default=False, init=False)
    """Was anything but a pull answered in this contact?"""
    pulled: float = field(default=0.0, init=False)
    """N. The strongest pull on both in this contact, of those at the ends of steps."""

    def __post_init__(self) -> None:
        self.rows = [self._row(k) for k in (0, 1)]
        self.asked = tuple(k for k in (0, 1) if not self.sides[k].wall)
        if self.right_first:
            self.asked = self.asked[::-1]

    def _row(self, k: int) -> list[Any]:
        """The values of all `ARGUMENTS` for one side; `look` and `on` fill in what changes."""
        me, other = self.sides[k], self.sides[1 - k]
        inverse = (0.0 if me.wall else 1.0 / me.mass) + (0.0 if other.wall else 1.0 / other.mass)
        return [
            *(0.0, 0.0, me.mass, other.mass, 1.0 / inverse),
            *(0.0, 0.0, 0.0),
            *(self.stiffness, self.restitution, me.name, other.name, ("left", "right")[k]),
        ]

    def look(self, time: float, left: float, right: float) -> None:
        """s and m/s of the two, now."""
        self.time, self.odd = time, 0.0
        for row, own, other in ((self.rows[0], left, right), (self.rows[1], right, left)):
            row[VELOCITY_SELF], row[VELOCITY_OTHER], row[TIME] = own, other, time

    def on(self, mode: Mode, d: float, v: float, memory: float) -> float:
        """N, the push; nought while they are apart."""
        if mode == "apart":
            self.last, self.pushed, self.pulled = (0.0, 0.0), False, 0.0
            return 0.0
        answers = [0.0, 0.0]
        for k in self.asked:
            row = self.rows[k]
            row[OVERLAP], row[RATE] = max(d, 0.0), v
            answers[k] = self.law.ask(row)
        if len(self.asked) == 1:
            answers = [answers[self.asked[0]]] * 2
        self.last = left, right = answers[0], answers[1]
        self.pushed = self.pushed or (d > 0.0 and max(left, right) >= 0.0)
        self.odd = 0.5 * (left - right)
        self.greatest = max(self.greatest, abs(left), abs(right))
        if abs(self.odd) > abs(self.apart.odd):
            self.apart = Apart(self.odd, self.time, left, right)
        return 0.5 * (left + right)

    def look_at(self, d: float, v: float, closing: float, *, stuck: bool = False) -> None:
        """A step has ended with this overlap [m] and rate [m/s], or finds no end (`stuck`).

        Raises `WrongLawError` where the law pulls the two into each other, the deeper the harder,
        and never pushed. Such a motion is smooth and goes on for ever: neither steps nor any law
        of physics would say what is wrong with it. A well has a bottom: towards it a pull fades.
        """
        fast, written = 0.0 if stuck else FAR * max(closing, SLOW), self.law.written
        pull = -max(self.last)
        grows = d > 0.0 and not self.pushed and 0.0 < pull >= self.pulled
        self.pulled = max(self.pulled, pull)
        if grows and v > fast:
            message = said(
                "the force pulls the carts into each other: "
                "at an overlap of {overlap} it is {force}",
                overlap=f"{d:.3g} m",
                force=f"\N{MINUS SIGN}{pull:.3g} N",
            )
            hint = said("is its sign right? A force above 0 pushes a cart away from the other one")
            raise WrongLawError(written.file, written.line, message, hint)
        if stuck and self.greatest > HUGE:
            raise too_large(written, written.line, self.greatest)

    def push(self, d: float, v: float, memory: float) -> float:
        """Decided by the state."""
        return self.on("press" if d > 0.0 else "apart", d, v, memory)

    def pushes(self, d: Any, v: Any, memory: Any) -> Any:
        """A written law is asked one instant at a time."""
        raise NotImplementedError

    def warming(self, push: float, d: float, v: float) -> float:
        """W. All that the contact takes; what it gives back is taken from that again."""
        return push * v


def side_of(name: str, mass: float | None) -> Side:
    """A cart, or without a mass a wall."""
    return Side(name, math.inf if mass is None else mass, wall=mass is None)
