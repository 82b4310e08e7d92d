"""Which of all that may happen next is first.

An event is taken only if it is proved to come before every other that shares a body or a gap with
it. Two that have nothing to do with each other may come in either order: the end is the same, and
only the order of the list is then not proved.
"""

from __future__ import annotations

from collections.abc import Sequence

from sim.certify.numbers.balls import NotProvableError
from sim.certify.row import Next, RowState
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
    "turn": said("the turn"),
    "climb": said("the next squeeze"),
    "apart": said("the end of the contact"),
    "fall": said("the end of the spring"),
    "slip": said("the start"),
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


def _strikes(one: Next) -> bool:
    """Does it change velocities at once?"""
    return one.kind == "burst" or (one.kind == "touch" and not _soft(one))


class Order(RowState):
    """A row, and the order of what is foreseen in it."""

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
            near = bool(self._around(other) & around)
            if self._in_one_row(first, other) or (
                near and not (exactly and self._apart(first, other))
            ):
                raise NotProvableError(self._unknown(first, other))
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

    def _in_one_row(self, one: Next, other: Next) -> bool:
        """Do blows pass from one to the other at once, through what touches in between?

        The order of two then matters, though they have no body in common: what one of them sets
        off may come before the other, or after it.
        """
        if one.gap is None or other.gap is None or not (_strikes(one) and _strikes(other)):
            return False
        first, last = sorted((one.gap.index, other.gap.index))
        return all(
            gap.joined or (gap.contact.sudden and gap.touches)
            for gap in self.gaps
            if first < gap.index < last
        )

    def _unknown(self, one: Next, other: Next) -> Said:
        """Neither of two is provably first; two of one name are of two ways to the same."""
        first, second = self._called(one), self._called(other)
        if first == second:
            return said("when {event} comes", event=first)
        return said("what comes first: {one} or {other}", one=first, other=second)

    def _called(self, one: Next) -> Said:
        """What ends a motion is called by its cause: the end of a contact, or a cart that stops."""
        kind = one.cause if one.kind == "end" and one.cause in WORDS else one.kind
        if one.gap is not None and one.body is None:
            return called(kind, one.gap.called)
        bodies = one.bodies if one.body is None else (one.body,)
        return called(kind, [self.names[k] for body in bodies for k in body.carts])
