"""Contacts of a row: a meeting, what ends a motion of bodies that touch, and what follows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager

from sim.certify import peaks
from sim.certify.bodies import Body, Gap
from sim.certify.coupled import CoupledPhase
from sim.certify.forming import Forming, no_joint, rest_against
from sim.certify.impacts import common_velocity, impact, no_last_bounce, reduced_mass
from sim.certify.instants import Instant
from sim.certify.numbers.balls import ZERO, Ball, NoBoundError, NotProvableError, is_zero
from sim.certify.phases import ContactPhase
from sim.certify.row import Next
from sim.certify.touches import Touch
from sim.scene.said import said


class Contacts(Forming):
    """What happens between two bodies."""

    def meet(self, gap: Gap, now: Instant) -> None:
        """Two bodies meet; either may be in another contact."""
        both = (gap.left, gap.right)
        pressed = self.interrupt(both, now)
        held = [body for body in both if body.held]
        self.forget(both)
        self.settle(both, now)
        if gap.tail is None and is_zero(gap.memory):
            gap.room = ZERO
        if not gap.contact.sudden:
            self.begin([gap], now, pressed)
            return
        if not gap.rate < 0:
            hopeless = NoBoundError if gap.rate >= 0 else NotProvableError
            raise hopeless(said("{pair} are pressed together without a duration", pair=gap.shown))
        self.tell(now, "contact", gap.names)
        if gap.contact.joins:
            with self.damped_anew(gap, pressed):
                self.join(gap, now)
        else:
            no_last_bounce(gap)
            impact(gap)
            rate, free = gap.rate, [body for body in both if not self._touches(body)]
            self.fly(free, now)
            gap.rate = rate
            self._tell_grips(free, held, now)
            for body in both:
                if body not in free:  # who touches others is judged with them
                    body.held, body.sliding = body in held, 0
        self.form_beside(gap, pressed, now)

    def form_beside(self, gap: Gap, pressed: Iterable[Gap], now: Instant) -> None:
        """What was pressed goes on after velocities have changed at once at a gap."""
        for one in pressed:
            if one is not gap:
                one.rate = one.right.v - one.left.v
            if one.touching:
                self.touches[one.index].still_pushes(now)
        self.form(pressed, now)

    @contextmanager
    def damped_anew(self, gap: Gap, pressed: Iterable[Gap]) -> Iterator[None]:
        """Around what changes the bodies at `gap`: a damper is that of the two that it is between.

        One that pushes just now would change on the way: no bound.
        """
        for one in pressed:
            if one.touching:
                no_joint(self.touches[one.index])
        linger = [one for one in self.gaps if one.tail is not None and one is not gap]
        before = [reduced_mass(one.left, one.right) for one in linger]
        yield
        for one, mu in zip(linger, before, strict=True):
            _damp_anew(one, mu)

    def join(self, gap: Gap, now: Instant) -> None:
        """Two bodies become one: by velcro, or by the latch of an exploder."""
        left, right = gap.left, gap.right
        v = left.v if is_zero(gap.rate) else common_velocity(left, right)
        mass = None if left.mass is None or right.mass is None else left.mass + right.mass
        one = Body([*left.carts, *right.carts], mass, v, now, load=[*left.load, *right.load])
        gap.joined = True
        for k in one.carts:
            self.bodies[k] = one
        for other in self.gaps:
            if other.left is left or other.left is right:
                other.left = one
            if other.right is left or other.right is right:
                other.right = one
        held = (left if left.carts else right).held  # the joint goes on as this one
        if self._touches(one):
            for near in self.gaps:  # who is beside it, and not pressed, sees another velocity
                if one in (near.left, near.right) and not (near.joined or near.bound):
                    near.rate = near.right.speed(now) - near.left.speed(now)
            one.held = held
            return
        self.fly((one,), now)
        if one.mass is not None and held != one.held and self.running:
            self.tell_carts(now, "stop" if one.held else "start", one)

    def _touches(self, body: Body) -> bool:
        return any(gap.bound and body in (gap.left, gap.right) for gap in self.gaps)

    def begin(self, gaps: Sequence[Gap], now: Instant, pressed: Iterable[Gap] = ()) -> None:
        """Contacts of finite duration begin; `pressed`: what else touches around them."""
        for gap in gaps:
            self.tell(now, "contact", gap.names)
            self.touches[gap.index] = Touch(gap, now)
            gap.touching = True
        self.form([*gaps, *pressed], now)

    def phase_ends(self, one: Next) -> None:
        """A bumper turns, two come apart or meet, or friction takes hold of somebody."""
        now, cause, gap = one.when, one.cause, one.gap
        if gap is not None and cause == "touch":
            self.meet(gap, now)
            return
        key = next(k for k, (_, ends) in self.phases.items() if one in ends)
        phase, _ = self.phases[key]
        for other in phase.gaps:
            if other.touching:
                touch = self.touches[other.index]
                seen = cause if other is gap and one.body is None else ""
                if isinstance(phase, ContactPhase) and _turns(touch, cause):
                    seen = "turn"
                self._see(phase, other, now, seen)
                touch.fresh = touch.fresh and other is gap and one.body is None
        self.leave(key, now)
        if one.body is not None:
            self._grip(one.body, cause, phase.gaps, now)
            if not phase.gaps:
                self._alone(one.body, now)
            self.form(phase.gaps, now)
        elif gap is not None and cause == "fall":
            self.fall_off(gap, now)
            self._go_on(phase.gaps, gap, [body for body in phase.bodies if body.held], now)
        elif gap is not None and cause == "clear":
            gap.room, gap.memory, gap.tail = ZERO, ZERO, None
            self.form(phase.gaps, now)
        elif gap is not None:
            self._contact_ends(gap, phase, one)

    def fall_off(self, gap: Gap, now: Instant) -> None:
        """The spring that was let go has its full length, and pushes no more."""
        gap.springs = tuple(one for one in gap.springs if one not in gap.loose)
        gap.loose = ()
        self.tell(now, "separate", gap.names)

    def _alone(self, body: Body, now: Instant) -> None:
        """Friction stops a body in the air."""
        self.fly((body,), now)
        if body.held:
            self.tell_carts(now, "stop", body)

    def _contact_ends(self, gap: Gap, phase: ContactPhase | CoupledPhase, one: Next) -> None:
        now, cause, touch = one.when, one.cause, self.touches[gap.index]
        turned, alone = cause == "turn", isinstance(phase, ContactPhase)
        held = [body for body in phase.bodies if body.held]
        if turned:
            gap.rate = ZERO
            if gap.left.still or gap.right.still:  # the cart itself stands still now
                for body in (gap.left, gap.right):
                    body.v, body.sliding = ZERO, 0
        if cause == "climb":
            touch.climb()
        if cause == "climb" or (turned and touch.turn(now)):
            self.form(phase.gaps, now)
            return
        self._part(gap, now, turned=turned, alone=alone)
        self._go_on(phase.gaps, gap, held, now)
        if turned and self._pressed_on(gap, alone=alone):
            raise NoBoundError(said("{pair} stay pressed together under a force", pair=gap.shown))

    def _grip(self, body: Body, cause: str, gaps: Sequence[Gap], now: Instant) -> None:
        """Friction stops a body, or lets it go."""
        if cause == "halt":
            body.v, body.sliding = ZERO, 0
            for gap in gaps:
                if body in (gap.left, gap.right):
                    rest_against(gap)
            return
        total = body.force(now)
        for gap in gaps:
            if body in (gap.left, gap.right):
                push = self.push(gap)
                total = total - push if body is gap.left else total + push
        body.v, body.held, body.slips = ZERO, False, now
        body.balanced = now if all(one.even for one in body.load) else None
        if not total > 0 and not total < 0:
            raise NotProvableError(said("which way a cart begins to slide"))
        body.sliding = 1 if total > 0 else -1
        self.tell_carts(now, "start", body)

    def _part(self, gap: Gap, now: Instant, *, turned: bool, alone: bool) -> None:
        touch = self.touches.pop(gap.index)
        touch.part(turned=turned)
        gap.spent, gap.touching = True, False
        if turned and alone:
            same = common_velocity(gap.left, gap.right)
            for body in (gap.left, gap.right):
                body.v = same
        peak = peaks.greatest(touch)
        if peak is not None:
            self.tell(peak, "peak", gap.names)
        self.tell(now, "separate", gap.names)

    def _go_on(self, gaps: Sequence[Gap], gap: Gap, held: Sequence[Body], now: Instant) -> None:
        """After a separation: who is free flies, the others form anew."""
        room, rate = gap.room, gap.rate
        free = [body for body in (gap.left, gap.right) if not self._touches(body)]
        self.fly(free, now)
        gap.room, gap.rate = room, rate
        self._tell_grips(free, held, now)
        self.form(gaps, now)

    def _pressed_on(self, gap: Gap, *, alone: bool) -> bool:
        """Is a bumper that does not spring back held at its greatest overlap by other forces?"""
        if not alone:
            return not gap.right.rate(gap.since) - gap.left.rate(gap.since) > 0
        pairs = gap.left.mass is not None and gap.right.mass is not None
        return bool(not is_zero(gap.pull) or (pairs and self.scene.effects))

    def _tell_grips(self, bodies: Iterable[Body], held: Sequence[Body], now: Instant) -> None:
        """Which of these friction has just taken hold of, or let go; `held`: before."""
        for body in bodies:
            if body.mass is not None and body.held != (body in held):
                self.tell_carts(now, "stop" if body.held else "start", body)


def _damp_anew(gap: Gap, before: Ball) -> None:
    """The damper of a pair that has not recovered is that of its two masses, joined ones too."""
    mu = reduced_mass(gap.left, gap.right)
    if gap.tail is not None and mu is not None and before is not None:
        gap.tail = gap.tail[0], gap.tail[1] * (mu / before).sqrt()


def _turns(touch: Touch, cause: str) -> bool:
    """Does a cart that stops at a wall thereby turn there? o′ is its velocity."""
    walls = touch.gap.left.mass is None or touch.gap.right.mass is None
    return walls and cause == "halt" and is_zero(touch.line.gamma)
