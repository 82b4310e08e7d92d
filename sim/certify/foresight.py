"""What comes next: for every gap, every sliding cart and every contact, and which of it is first.

Of all that may happen next, an event is taken only if it is proved to come before every other that
shares a body or a gap with it. Two that have nothing to do with each other may come in either
order: the end is the same, and only the order of the list is then not proved.
"""

from __future__ import annotations

from collections.abc import Sequence

from sim.certify.bodies import Gap
from sim.certify.instants import Instant, instant
from sim.certify.numbers.balls import (
    ZERO,
    Ball,
    NotProvableError,
    is_zero,
)
from sim.certify.numbers.roots import Function, falls_to_zero, first_root
from sim.certify.row import Next, Row
from sim.scene.said import Said, listed, said

WORDS = {
    "touch": said("the touch"),
    "contact": said("the touch"),
    "clear": said("the recovery"),
    "recovery": said("the recovery"),
    "end": said("the end of the contact"),
    "separate": said("the end of the contact"),
    "peak": said("the greatest force"),
    "halt": said("the stop"),
    "stop": said("the stop"),
    "start": said("the start"),
    "stick": said("the joining"),
    "release": said("the release"),
    "burst": said("the release"),
}
"""What comes next or has come, as a reason calls it."""


def called(kind: str, names: Sequence[str]) -> Said:
    """An event, for a reason."""
    return said("{event} of {carts}", event=WORDS.get(kind, kind), carts=listed(names))


def at_once(one: Said, other: Said) -> Said:
    """Of two events neither is provably first."""
    return said(
        "{one} and {other} come at one instant, as far as can be told", one=one, other=other
    )


def _soft(one: Next) -> bool:
    return one.gap is not None and not one.gap.contact.sudden


def _opening(gap: Gap) -> Function | None:
    """Of two that touch at rest to each other: how their room grows, if it does."""
    if not (gap.touches and is_zero(gap.rate)):
        return None
    return lambda t: gap.pull_at(gap.since.after(t))


class Foresight(Row):
    """What is still to come of a row."""

    def first(self, coming: list[Next]) -> Next | None:
        """The provably first; None if nothing comes before the end."""
        for one in coming:
            if one.when is self.present and one.kind == "touch" and _soft(one):
                return one  # nothing can come before now, and such touches change no velocity
        known = [(*one.when.ends(), one) for one in coming]
        end = self.until.ends()[1]
        known = [row for row in known if not row[0] > end]
        if not known:
            return None
        low, high, first = min(known, key=lambda row: (row[1], row[0]))
        if high > end:
            raise NotProvableError(said("whether something still happens before the end"))
        around = self._around(first)
        for other_low, other_high, other in known:
            if other is first or other_low > high:
                continue
            exactly = low == high == other_low == other_high
            if self._around(other) & around and not (exactly and self._apart(first, other)):
                raise NotProvableError(
                    said(
                        "what comes first: {one} or {other}",
                        one=self._called(first),
                        other=self._called(other),
                    )
                )
            if not exactly:
                self.doubt = self.doubt or at_once(self._called(first), self._called(other))
        return first

    def _around(self, one: Next) -> set[int]:
        """Gaps that an event changes."""
        found = set() if one.gap is None else {one.gap.index}
        for gap in self.gaps:
            if gap.left in one.bodies or gap.right in one.bodies:
                found.add(gap.index)
        return found

    def _apart(self, one: Next, other: Next) -> bool:
        """At exactly one instant: is either order the same, as no body takes part in both?"""
        if one.kind == other.kind == "touch" and _soft(one) and _soft(other):
            return True
        return not set(map(id, one.bodies)) & set(map(id, other.bodies))

    def _called(self, one: Next) -> Said:
        if one.gap is not None:
            return called(one.kind, one.gap.names)
        return called(one.kind, [self.names[k] for body in one.bodies for k in body.carts])

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
            return (lambda t: gap.way_at(gap.since.after(t))), rate
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
