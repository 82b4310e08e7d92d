"""Contacts of a row: a meeting, the phases of a contact one after the other, its end."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from sim.certify.balls import ZERO, NoBoundError, is_zero
from sim.certify.bodies import Body, Gap
from sim.certify.foresight import Foresight
from sim.certify.instants import Instant
from sim.certify.phases import ContactPhase
from sim.certify.row import Next
from sim.certify.touches import Touch, common_velocity, impact
from sim.scene.said import said


class Contacts(Foresight):
    """What happens between two bodies."""

    def meet(self, gap: Gap, now: Instant) -> None:
        """Two bodies in flight meet."""
        for body in (gap.left, gap.right):
            if body.phase is not None:
                raise NoBoundError(
                    said(
                        "{pair} meet while one of them is in another contact: coupled contacts "
                        "have no bound yet",
                        pair=gap.shown,
                    )
                )
        if gap.tail is not None or not is_zero(gap.memory):
            raise NoBoundError(
                said("{pair} meet again before their bumpers have recovered", pair=gap.shown)
            )
        held = [body for body in (gap.left, gap.right) if body.held]
        self.forget((gap.left, gap.right))
        self.settle((gap.left, gap.right), now)
        gap.room = ZERO
        if not gap.contact.sudden:
            self.touch(gap, now)
            return
        if not gap.rate < 0:
            raise NoBoundError(
                said("{pair} are pressed together without a duration", pair=gap.shown)
            )
        self.tell(now, "contact", gap.names)
        if gap.contact.joins:
            self._join(gap, now)
            return
        impact(gap)
        rate = gap.rate
        self.fly((gap.left, gap.right), now)
        gap.rate = rate
        self._tell_grips((gap.left, gap.right), held, now)

    def _join(self, gap: Gap, now: Instant) -> None:
        left, right = gap.left, gap.right
        v = common_velocity(left, right)
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
        self.fly((one,), now)
        if one.mass is not None and held != one.held:
            self.tell_carts(now, "stop" if one.held else "start", one)

    def touch(self, gap: Gap, now: Instant) -> None:
        """A contact of finite duration begins."""
        self.tell(now, "contact", gap.names)
        self.touches[gap.index] = Touch(gap, now)
        gap.touching = True
        self.press(gap, now)

    def press(self, gap: Gap, now: Instant) -> None:
        """A phase begins; both bodies are settled."""
        touch = self.touches[gap.index]
        push = touch.force()
        for body, way in ((gap.left, -1), (gap.right, 1)):
            if body.mass is not None and not (body.sliding and is_zero(body.v)):
                held = body.held
                body.fly(now, way * push)
                if held != body.held:
                    self.tell_carts(now, "stop" if body.held else "start", body)
        phase = ContactPhase(gap, touch.line, now)
        gap.left.phase = gap.right.phase = None
        for body in (gap.left, gap.right):
            if body.carts:
                body.phase = phase
        horizon = self.until.minus(now).upper().mid()
        ends: list[Next] = []
        bodies = (gap.left, gap.right)
        if horizon > 0:
            own = touch.end(phase, horizon)
            if own is not None:
                ends.append(Next(now.after(own[0]), "end", bodies, gap, own[1]))
                horizon = min(horizon, own[0].upper().mid())
            for tau, cause, body in () if touch.turns_alone else phase.grips(horizon):
                ends.append(Next(now.after(tau), "end", bodies, gap, cause, body))
        self.phases[gap.index] = (phase, ends)
        for near in self.gaps:
            if {near.left, near.right} & {body for body in bodies if body.carts}:
                self.ahead.pop(near.index, None)

    def phase_ends(self, gap: Gap, one: Next) -> None:
        """Its bumper turns, it comes apart, or friction takes hold of one of the two."""
        if one.cause in ("halt", "slip") and one.body is not None:
            self.again(gap, one.when, ((one.body, one.cause),))
            return
        touch, (phase, _) = self.touches[gap.index], self.phases[gap.index]
        touch.see_peak(phase, one.when.minus(phase.begun), one.when, one.cause)
        self._leave(gap, one.when)
        if one.cause == "turn":
            gap.rate = ZERO
            if touch.turns_alone:  # at a wall the cart itself stands still now
                for body in (gap.left, gap.right):
                    body.v, body.sliding = ZERO, 0
            if touch.turn():
                self.press(gap, one.when)
                return
        touch.part(turned=one.cause == "turn")
        gap.spent = one.cause == "apart"
        gap.touching = False
        del self.touches[gap.index]
        room, rate = gap.room, gap.rate
        if one.cause == "turn":
            same = common_velocity(gap.left, gap.right)
            for body in (gap.left, gap.right):
                body.v = same
        held = [body for body in (gap.left, gap.right) if body.held]
        self.fly((gap.left, gap.right), one.when)
        gap.room, gap.rate = room, rate
        pairs = gap.left.mass is not None and gap.right.mass is not None
        loaded = not is_zero(gap.pull) or (pairs and self.scene.effects)
        if one.cause == "turn" and loaded:  # it is held at its greatest overlap, and never parts
            raise NoBoundError(said("{pair} stay pressed together under a force", pair=gap.shown))
        peak = touch.peak()
        if peak is not None:
            self.tell(peak, "peak", gap.names)
        self.tell(one.when, "separate", gap.names)
        self._tell_grips((gap.left, gap.right), held, one.when)

    def _tell_grips(self, bodies: Iterable[Body], held: Sequence[Body], now: Instant) -> None:
        """Which of these friction has just taken hold of, or let go; `held`: before."""
        for body in bodies:
            if body.mass is not None and body.held != (body in held):
                self.tell_carts(now, "stop" if body.held else "start", body)

    def _leave(self, gap: Gap, now: Instant) -> None:
        """Out of a phase: bodies and gaps are settled, and in flight."""
        bodies = tuple(body for body in (gap.left, gap.right) if body.carts)
        self.forget(bodies)
        self.settle(bodies, now)
        del self.phases[gap.index]
        for body in bodies:
            body.phase = None

    def again(self, gap: Gap, now: Instant, grips: tuple[tuple[Body, str], ...]) -> None:
        """The same stage goes on with other loads."""
        touch, (phase, _) = self.touches[gap.index], self.phases[gap.index]
        alone = gap.left.mass is None or gap.right.mass is None
        turns = alone and any(cause == "halt" for _, cause in grips)
        still = turns and is_zero(touch.line.gamma)  # at a wall: o′ is the cart's velocity
        touch.see_peak(phase, now.minus(phase.begun), now, "turn" if still else "")
        self._leave(gap, now)
        touch.fresh = False
        if turns:
            gap.rate = ZERO
        push = touch.force()
        for body, cause in grips:
            if cause == "halt":
                body.v, body.sliding = ZERO, 0
                body.fly(now, -push if body is gap.left else push)
                if body.held:
                    self.tell_carts(now, "stop", body)
            else:
                total = body.force(now) + (-push if body is gap.left else push)
                body.v, body.held = ZERO, False
                body.sliding = 1 if total > 0 else -1
                self.tell_carts(now, "start", body)
        self.press(gap, now)
