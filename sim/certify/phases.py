"""One branch of a contact from its beginning until something ends it.

    V′ = A        common centre of those of the two that move
    o             the overlap, `oscillation`
    v_left = V + (μ/m) o′      v_right = V − (μ/m) o′      a still body: V = 0, μ the other's mass

It ends where its law says (`touches`), where a sliding cart stops, or where the force is more than
friction can hold. Each end is the first zero of a function that is positive before.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sim.certify.bodies import Body, Gap
from sim.certify.instants import Instant
from sim.certify.numbers.balls import ZERO, Ball, NoBoundError, is_zero
from sim.certify.numbers.roots import first_root
from sim.certify.oscillation import Line, Oscillation
from sim.scene.said import said


class ContactPhase:
    """A pair in one branch; both bodies point here until it ends."""

    def __init__(self, gap: Gap, line: Line, now: Instant) -> None:
        left, right = gap.left, gap.right
        self.gap, self.begun, self.line = gap, now, line
        self.gaps, self.bodies = [gap], tuple(b for b in (left, right) if b.mass is not None)
        self.left, self.right = left, right
        a = ZERO if left.still else left.acceleration(now)
        b = ZERO if right.still else right.acceleration(now)
        if left.still and right.still:
            raise NoBoundError(said("{pair} press each other at rest", pair=gap.shown))
        if left.still or right.still:
            mover = right if left.still else left
            line = replace(line, critical=line.critical and None in (left.mass, right.mass))
            self.mu, self.drift, self.pull = mover.mass, ZERO, a - b
            self.centre = ZERO
            self.sides = (ZERO if left.still else 1, ZERO if right.still else -1)
        else:
            total = left.mass + right.mass
            self.mu = left.mass * right.mass / total
            self.centre = (left.mass * left.v + right.mass * right.v) / total
            self.drift = ZERO
            if not (is_zero(a) and is_zero(b)):
                self.drift = a if a is b else (left.mass * a + right.mass * b) / total
            self.pull = ZERO if a is b else a - b
            self.sides = (self.mu / left.mass, -self.mu / right.mass)
        self.swing = Oscillation(line, self.mu, -gap.room, -gap.rate, self.pull)

    @property
    def unloaded(self) -> bool:
        """Does nothing act but the contact?"""
        return is_zero(self.pull) and is_zero(self.drift)

    def _side(self, body: Body) -> Ball:
        return self.sides[0] if body is self.left else self.sides[1]

    def displacement(self, body: Body, start: Instant, end: Instant) -> Ball:
        """m. Between two times of the phase."""
        if body.still:
            return ZERO
        tau, side = end.minus(start), self._side(body)
        first = self.swing.o0 if start is self.begun else self.swing.at(start.minus(self.begun))[0]
        over = self.swing.at(end.minus(self.begun))[0] - first
        displacement = self.centre * tau + side * over
        if is_zero(self.drift):
            return displacement
        return displacement + self.drift * tau * (start.minus(self.begun) + tau / 2)

    def between(self, gap: Gap, now: Instant) -> tuple[Ball, Ball]:
        """Room [m] and rate [m/s] of its gap."""
        over, rate = self.swing.at(now.minus(self.begun))
        return -over, -rate

    def speed(self, body: Body, now: Instant) -> Ball:
        """m/s."""
        if body.still:
            return ZERO
        tau = now.minus(self.begun)
        return self.centre + self.drift * tau + self._side(body) * self.swing.at(tau)[1]

    def acceleration(self, body: Body, now: Instant) -> Ball:
        """m/s²."""
        if body.still:
            return ZERO
        return self.drift + self._side(body) * self.swing.all(now.minus(self.begun))[2]

    def grips(self, horizon: Ball) -> Iterator[tuple[Ball, str, Body]]:
        """Where a sliding body stops, or a held one is pushed away, up to `horizon` [s] after."""
        for body, direction in ((self.left, -1), (self.right, 1)):
            if body.mass is None:
                continue
            if body.held:
                yield from self._slips(body, direction, horizon)
            elif body.sliding:
                yield from self._stops(body, horizon)

    def _stops(self, body: Body, horizon: Ball) -> Iterator[tuple[Ball, str, Body]]:
        direction, side = body.sliding, self._side(body)

        def speed(tau: Ball) -> Ball:
            return direction * (self.centre + self.drift * tau + side * self.swing.at(tau)[1])

        def rate(tau: Ball) -> Ball:
            return direction * (self.drift + side * self.swing.all(tau)[2])

        def jerk(tau: Ball) -> Ball:
            return direction * side * self.swing.all(tau)[3]

        # One that has just begun to slide is pushed by a force that grew past friction.
        begins = jerk if is_zero(body.v) else None
        doubt = said("whether a cart stops in the contact of {pair}", pair=self.gap.shown)
        tau = first_root(speed, rate, horizon, doubt, curve=begins)
        if tau is not None:
            yield tau, "halt", body

    def _slips(self, body: Body, direction: int, horizon: Ball) -> Iterator[tuple[Ball, str, Body]]:
        load = body.force(self.begun)
        doubt = said("whether friction holds a cart in the contact of {pair}", pair=self.gap.shown)
        for end in (1, -1):

            def room(tau: Ball, end: int = end) -> Ball:
                return body.static - end * (load + direction * self.swing.force(tau)[0])

            def rate(tau: Ball, end: int = end) -> Ball:
                return -end * direction * self.swing.force(tau)[1]

            tau = first_root(room, rate, horizon, doubt)
            if tau is not None:
                yield tau, "slip", body
