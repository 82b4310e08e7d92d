"""Exploders: a latch that holds two together, and the energy E that parts them.

At one instant ½ μ w′² = ½ μ w² + E for the speed of separation w; with a spring of stiffness k
N = k (L − r) from then on until the room r it makes is its length L = √(2 E/k).
"""

from __future__ import annotations

from fractions import Fraction

from sim.certify.bodies import Body, Gap
from sim.certify.contacts import Contacts
from sim.certify.impacts import common_velocity, reduced_mass
from sim.certify.instants import Instant
from sim.certify.loads import Burst
from sim.certify.numbers.balls import ZERO, NoBoundError, NotProvableError, is_zero, lower
from sim.certify.order import at_once, called
from sim.certify.oscillation import Line
from sim.certify.row import Next
from sim.scene.said import said

TOUCHING = Fraction(1, 10**12)
"""m. An exploder between two that are farther apart does nothing: what a run takes for rounding."""


class Releases(Contacts):
    """What exploders do to a row."""

    def latch(self) -> None:
        """Two that touch at the start with one velocity stay together until they are set free."""
        for burst in self.inputs.bursts:
            gap = self._gap(burst)
            if not gap.joined and gap.room <= 0 and is_zero(gap.rate):
                self.join(gap, self.zero)

    def coming_release(self, bursts: list[Burst]) -> list[Next]:
        """The next of them, with the bodies that its gap has now."""
        return [
            Next(burst.when, "burst", (gap.left, gap.right), gap)
            for burst in bursts[:1]
            for gap in [self._gap(burst)]
        ]

    def nothing_strikes_first(self, burst: Burst) -> None:
        """At the start impacts come before an exploder: none may be due. Raises NoBoundError."""
        for gap in self.gaps:
            struck = gap.contact.sudden and not gap.joined and not lower(gap.room) > 0
            opens = gap.rate > 0 or (is_zero(gap.rate) and not gap.contact.joins)
            if struck and not opens:
                apart = self._gap(burst).called
                raise NoBoundError(at_once(called("touch", gap.called), called("burst", apart)))

    def set_free(self, burst: Burst, now: Instant) -> None:
        """The energy goes into the two, or a spring lies between them from now on."""
        gap = self._gap(burst)
        latched = gap.joined
        pressed = self.interrupt((gap.left, gap.right), now, stuck=latched)
        self.forget((gap.left, gap.right))
        self.settle((gap.left, gap.right), now)
        if latched:
            with self.damped_anew(gap, pressed):
                self._split(gap, now)
        elif lower(gap.room) > TOUCHING:
            self.fly([b for b in (gap.left, gap.right) if not self._touches(b)], now)
            self.form(pressed, now)
            return
        self._only_touches(gap)
        self.tell(now, "release", gap.names)
        if burst.stiffness is None:
            self._part_at_once(gap, burst)
        else:
            length = (2 * burst.energy / burst.stiffness).sqrt()
            spring = Line(burst.stiffness, ZERO, -length)
            gap.springs, gap.loose = (*gap.springs, spring), (*gap.loose, spring)
            pressed = [gap, *pressed]
        self._go_on_after(gap, pressed, now)

    def _gap(self, burst: Burst) -> Gap:
        return next(gap for gap in self.gaps if gap.index == burst.gap)

    def _only_touches(self, gap: Gap) -> None:
        """No bumper may hold energy of its own, and the room is nought, exactly."""
        recovered = is_zero(gap.memory) and gap.tail is None and not gap.loose
        if gap.touching or not recovered or gap.room < 0:
            raise NoBoundError(
                said("{pair} are released while their bumpers are pressed", pair=gap.shown)
            )
        if not is_zero(gap.room):
            raise NotProvableError(
                said("whether {pair} touch as they are released", pair=gap.shown)
            )

    def _part_at_once(self, gap: Gap, burst: Burst) -> None:
        left, right = gap.left, gap.right
        mu, centre = reduced_mass(left, right), common_velocity(left, right)
        apart = (gap.rate * gap.rate + 2 * burst.energy / mu).sqrt()
        for body, direction in ((left, -1), (right, 1)):
            body.held, body.sliding = False, 0
            if body.mass is not None:
                body.v = centre + direction * mu / body.mass * apart
        gap.rate = apart

    def _go_on_after(self, gap: Gap, pressed: list[Gap], now: Instant) -> None:
        """Who touches nobody flies, the others form anew."""
        rate = gap.rate
        both = (gap.left, gap.right)
        self.fly([body for body in both if not self._touches(body)], now)
        gap.rate = rate
        self.form_beside(gap, pressed, now)

    def _split(self, gap: Gap, now: Instant) -> None:
        """One body becomes two, left and right of a gap that held it together."""
        one = gap.left
        parts = []
        for carts in (
            [k for k in one.carts if k < gap.index],
            [k for k in one.carts if k >= gap.index],
        ):
            load = [self.inputs.loads[k] for k in carts]
            body = Body(carts, self._mass(carts), one.v, now, load=load)
            parts.append(body)
            for k in carts:
                self.bodies[k] = body
        left, right = parts
        left.held, right.held, gap.joined = one.held, one.held, False
        for near in self.gaps:
            if near.left is one:
                near.left = left if near.index < gap.index else right
            if near.right is one:
                near.right = left if near.index < gap.index else right
        gap.left, gap.right, gap.rate, gap.since = left, right, ZERO, now

    def _mass(self, carts: list[int]) -> object:
        """kg. None where they stick to a wall."""
        for end, cart in ((0, 0), (len(self.names), len(self.names) - 1)):
            if cart in carts and any(gap.joined and gap.index == end for gap in self.gaps):
                return None
        return sum((self.inputs.masses[k] for k in carts), ZERO)
