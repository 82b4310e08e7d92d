"""What moves between events, and what is between two neighbours.

A body is a cart, or carts that velcro holds together. Between events it is held, it flies under a
constant force, or it is in one phase of a contact (`phases`). Of every gap its room and rate are
kept from the last event of one of its bodies on: so that what touches has room 0, exactly.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Protocol

from sim.certify.instants import Instant, instant
from sim.certify.loads import Load
from sim.certify.numbers.balls import ZERO, Ball, NotProvableError, exact, is_zero, sign
from sim.certify.oscillation import Line
from sim.scene.model import Contact
from sim.scene.said import listed, said


class Phase(Protocol):
    """One branch of a contact, as its two bodies see it."""

    begun: Instant

    def displacement(self, body: Body, start: Instant, end: Instant) -> Ball:
        """m. Between two times of the phase."""

    def speed(self, body: Body, now: Instant) -> Ball:
        """m/s."""

    def acceleration(self, body: Body, now: Instant) -> Ball:
        """m/s²."""


@dataclass(slots=True, eq=False)
class Body:
    """`mass` None: it does not move (a wall, or what sticks to one)."""

    carts: list[int]
    mass: Ball  # kg
    v: Ball = ZERO  # m/s, at `begun`
    begun: Instant = field(default_factory=lambda: instant(0.0))
    a: Ball = ZERO  # m/s², in flight
    load: list[Load] = field(default_factory=list)
    held: bool = False  # by friction
    sliding: int = 0
    phase: Phase | None = None
    slips: Instant | None = None  # when the force on it outgrew friction
    balanced: Instant | None = None  # when it did so with no net force, exactly

    @property
    def still(self) -> bool:
        """Does nothing move it?"""
        return self.mass is None or self.held

    @property
    def kinetic(self) -> Ball:
        """N. Friction while it slides."""
        return sum((one.kinetic for one in self.load), ZERO)

    @property
    def static(self) -> Ball:
        """N. What friction can hold."""
        return sum((one.static for one in self.load), ZERO)

    @property
    def drag(self) -> Ball:
        """kg/s."""
        return sum((one.drag for one in self.load), ZERO)

    def force(self, now: Instant) -> Ball:
        """N without contacts, with the friction of its direction."""
        total = sum((one.force(now.ball) for one in self.load), ZERO)
        return total - self.sliding * self.kinetic if self.sliding else total

    def acceleration(self, now: Instant) -> Ball:
        """m/s² without contacts; of carts on one slope and nothing else the very same ball."""
        if not self.sliding and all(one.slope is self.load[0].slope for one in self.load):
            pushed = sum((one.pushed(now.ball) for one in self.load), ZERO)
            slope = self.load[0].slope
            return slope if is_zero(pushed) else slope + pushed / self.mass
        return self.force(now) / self.mass

    def displacement(self, start: Instant, end: Instant) -> Ball:
        """m. Between two times of its present motion."""
        if self.phase is not None:
            return self.phase.displacement(self, start, end)
        if self.still:
            return ZERO
        tau = end.minus(start)
        if is_zero(self.a):
            return self.v * tau
        return (self.v + self.a * start.minus(self.begun)) * tau + self.a * tau * tau / 2

    def speed(self, now: Instant) -> Ball:
        """m/s."""
        if self.phase is not None:
            return self.phase.speed(self, now)
        if self.still:
            return ZERO
        return self.v if is_zero(self.a) else self.v + self.a * now.minus(self.begun)

    def rate(self, now: Instant) -> Ball:
        """m/s². Of its present motion."""
        if self.phase is not None:
            return self.phase.acceleration(self, now)
        return ZERO if self.still else self.a

    def fly(self, now: Instant, push: Ball = ZERO) -> None:
        """From `now` on it is alone, or under the force `push` [N] of a contact besides its load.

        Says whether friction holds it, and which way it slides. Raises where that is not proved.
        """
        self.begun, self.phase, self.a = now, None, ZERO
        if self.mass is None:
            self.v = ZERO
            return
        self.sliding, self.held = 0, False
        force = sum((one.force(now.ball) for one in self.load), ZERO)
        if not (is_zero(self.static) and is_zero(self.kinetic)):
            self._rub(force + push)
        if not self.held:
            self.a = self.acceleration(now)

    def _rub(self, force: Ball) -> None:
        direction = sign(self.v, said("which way a cart slides"))
        if direction == 0:
            if abs(force) <= self.static:
                self.held = True
                return
            if not abs(force) > self.static:
                raise NotProvableError(said("whether friction holds a cart"))
            direction = sign(force, said("which way a cart begins to slide"))
        self.sliding = direction


@dataclass(slots=True, eq=False)
class Gap:
    """Between two neighbours; `contact` None: an open side, and nothing to meet."""

    index: int
    names: tuple[str, str]
    left: Body
    right: Body
    contact: Contact
    room: Ball  # m, at `since`; negative: pressed into each other
    rate: Ball  # m/s
    since: Instant = field(default_factory=lambda: instant(0.0))
    joined: bool = False
    memory: Ball = ZERO  # m, of a bumper that has not recovered
    tail: tuple[Ball, Ball] | None = None  # κ, γ of a dashpot that has not recovered
    spent: bool = False  # its force is nought at `since`, exactly
    touching: bool = False
    springs: tuple[Line, ...] = ()
    struck: int = 0  # impacts so far
    hardest: Ball = ZERO  # m/s, of them
    loose: tuple[Line, ...] = ()  # those of them that an exploder let go
    called: tuple[str, str] = ("", "")  # the two, as a sentence calls them

    @property
    def bound(self) -> bool:
        """Does anything act in it?"""
        return self.touching or (bool(self.springs) and not self.joined)

    @property
    def swings(self) -> bool:
        """Do springs alone act in it?"""
        return bool(self.springs) and not self.touching and self.tail is None and self.clear

    @property
    def clear(self) -> bool:
        """Is no bumper still on its way back?"""
        return is_zero(self.memory)

    @property
    def touches(self) -> bool:
        """Is it, exactly, where the two meet: at no room, or where a bumper springs no further?"""
        if is_zero(self.memory):
            return self.tail is None and is_zero(self.room)
        return self.spent

    @property
    def alike(self) -> bool:
        """Do both go on with one motion, so that nothing changes between them?"""
        return self.simple and is_zero(self.rate) and is_zero(self.pull)

    def rest(self) -> Ball:
        """m. The overlap at which a bumper that has not recovered meets the other again."""
        e = exact(self.contact.restitution or 0.0)
        return (1 - e * e) * self.memory

    def pulled(self) -> Ball:
        """N, of its springs, at `since`; positive pushes the two apart."""
        forces = (s.kappa * (-self.room - s.rest) - s.gamma * self.rate for s in self.springs)
        return sum(forces, ZERO)

    def room_at(self, now: Instant) -> Ball:
        """m."""
        if now is self.since:
            return self.room
        if self.simple:  # of two on one slope it knows that they fall alike
            tau = now.minus(self.since)
            return self.room + tau * (self.rate + self.pull * tau / 2)
        return self.room + self.displacement_at(now)

    def displacement_at(self, now: Instant) -> Ball:
        """m. By how much the room has grown."""
        return self.right.displacement(self.since, now) - self.left.displacement(self.since, now)

    def rate_at(self, now: Instant) -> Ball:
        """m/s."""
        if now is self.since:
            return self.rate
        if self.simple:
            return self.rate + self.pull * now.minus(self.since)
        return self.right.speed(now) - self.left.speed(now)

    def pull_at(self, now: Instant) -> Ball:
        """m/s²."""
        return self.right.rate(now) - self.left.rate(now)

    @property
    def shown(self) -> str:
        """A and the right wall, for a reason."""
        return listed(self.called)

    @property
    def simple(self) -> bool:
        """Are both in flight, so that the room is a parabola?"""
        return self.left.phase is None and self.right.phase is None

    @property
    def pull(self) -> Ball:
        """m/s². Of two bodies in flight."""
        return ZERO if self.left.a is self.right.a else self.right.a - self.left.a
