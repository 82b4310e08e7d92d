"""What comes next: for every gap, every sliding cart and every contact."""

from __future__ import annotations

from sim.certify.bodies import Gap
from sim.certify.instants import Instant, instant
from sim.certify.numbers.balls import (
    ZERO,
    Ball,
    NotProvableError,
    is_zero,
)
from sim.certify.numbers.roots import Function, falls_to_zero, first_root
from sim.certify.order import Order
from sim.certify.row import Next
from sim.scene.said import Said, said


def _opening(gap: Gap) -> Function | None:
    """Of two that touch at rest to each other: how their room grows, if it does."""
    if not (gap.touches and is_zero(gap.rate)):
        return None
    return lambda t: gap.pull_at(gap.since.after(t))


class Foresight(Order):
    """What is still to come of a row."""

    def presses(self, gap: Gap, now: Instant) -> bool:
        """Do two that touch at rest to each other press at once?"""
        raise NotImplementedError

    def halts(self) -> list[Next]:
        """Where friction brings carts in flight to rest."""
        found = []
        for body in dict.fromkeys(self.bodies):
            if body.phase is None and body.sliding and not body.still:
                braked = body.sliding * body.a
                if braked < 0:
                    when = body.begun.after(-body.v / body.a)
                    found.append(Next(when, "halt", (body,), body=body))
                elif not braked >= 0:
                    raise NotProvableError(said("whether a cart comes to rest"))
        return found

    def of_gap(self, gap: Gap) -> list[Next]:
        """A meeting, and the recovery of bumpers; kept until one of the bodies changes."""
        if gap.joined or gap.bound:
            return []
        found = self.ahead.get(gap.index)
        if found is None:
            found = self.ahead[gap.index] = list(self._meeting(gap))
        return found

    def _meeting(self, gap: Gap) -> list[Next]:
        bodies = (gap.left, gap.right)
        if gap.left.still and gap.right.still:
            return []
        doubt = said("whether {pair} meet", pair=gap.shown)
        found = []
        tail = gap.tail is not None or not is_zero(gap.memory)
        if self._pushes_again(gap, doubt):
            tau = ZERO
        elif gap.simple:
            left = self.until.minus(gap.since).upper().mid()
            tau = falls_to_zero(*self._force_left(gap), left, doubt)
            if tail:
                clear = falls_to_zero(-gap.room, -gap.rate, -gap.pull, left, doubt)
                if clear is not None:
                    found.append(Next(gap.since.after(clear), "clear", bodies, gap))
        elif gap.touches and self._closes(gap):
            tau = ZERO
        else:
            left = (self.horizon(gap) - gap.since.ball).upper().mid()
            tau = first_root(*self._closing(gap), left, doubt, curve=_opening(gap))
            if tail:
                clear = first_root(
                    lambda t: -gap.room_at(gap.since.after(t)),
                    lambda t: -gap.rate_at(gap.since.after(t)),
                    left,
                    doubt,
                )
                if clear is not None:
                    found.append(Next(gap.since.after(clear), "clear", bodies, gap))
        if tau is not None:
            found.append(Next(gap.since.after(tau), "touch", bodies, gap))
        return found

    def _pushes_again(self, gap: Gap, doubt: Said) -> bool:
        """Has a rate that changed at once, at a neighbour, brought back the force of a dashpot?"""
        if gap.tail is None or gap.spent:
            return False
        k, c = gap.tail
        left = k * gap.room + c * gap.rate
        if not left < 0 and not left >= 0:
            raise NotProvableError(doubt)
        return bool(left < 0)

    def _closes(self, gap: Gap) -> bool:
        """Do two that touch come together at once?"""
        return bool(gap.rate < 0) or (is_zero(gap.rate) and self.presses(gap, gap.since))

    def _force_left(self, gap: Gap) -> tuple[Ball, Ball, Ball]:
        """What has to fall to nought for a touch, as a parabola: room, or −N where it lingers."""
        if gap.tail is not None:
            k, c = gap.tail
            first = ZERO if gap.spent else k * gap.room + c * gap.rate
            return first, k * gap.rate + c * gap.pull, k * gap.pull
        if not is_zero(gap.memory):
            room = ZERO if gap.spent else gap.room + gap.rest()
            return room, gap.rate, gap.pull
        return gap.room, gap.rate, gap.pull

    def _closing(self, gap: Gap) -> tuple[Function, Function]:
        """The same and its slope, s after `since`, while one of the bodies is in a contact."""

        def room(t: Ball) -> Ball:
            return gap.room_at(gap.since.after(t))

        def rate(t: Ball) -> Ball:
            return gap.rate_at(gap.since.after(t))

        if gap.tail is not None:
            k, c = gap.tail
            return (
                lambda t: k * room(t) + c * rate(t),
                lambda t: k * rate(t) + c * gap.pull_at(gap.since.after(t)),
            )
        if gap.touches:  # of what is left of the room nothing has to cancel
            return (lambda t: gap.displacement_at(gap.since.after(t))), rate
        rest = ZERO if is_zero(gap.memory) else gap.rest()
        return (lambda t: room(t) + rest), rate

    def horizon(self, gap: Gap) -> Ball:
        """s. Up to there the present motions of both bodies hold."""
        ends = [self.until.ball]
        for _, coming in self.phases.values():
            for one in coming:
                if gap.left in one.bodies or gap.right in one.bodies:
                    ends.append(one.when.ball.upper())
        best = ends[0]
        for end in ends[1:]:
            best = min(best, end)
        return best

    def switches(self) -> list[Next]:
        """When pushes begin and end: nothing is told of it."""
        found: dict[float, set[int]] = {}
        for k, load in enumerate(self.inputs.loads):
            for begin, end, _ in load.pushes:
                for t in (begin, end):
                    if 0.0 < t <= self.scene.until:
                        found.setdefault(t, set()).add(k)
        return [
            Next(instant(t), "switch", (), carts=tuple(sorted(found[t]))) for t in sorted(found)
        ]
