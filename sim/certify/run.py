"""The run in balls: the provably first event, its consequences, and so on to the end.

A run is built in seven classes, each on the one before:

    RowState    bodies and gaps at one moment, settled from one event to the next
    Order       which of all that may happen next is first
    Foresight   what is still to come of gaps, of sliding carts and of switches
    Forming     which motion moves what touches, and how one ends before its time
    Contacts    what a touch and the end of a contact change
    Releases    what exploders do
    BallRun     the loop over all of it
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from math import inf
from time import monotonic
from typing import NamedTuple

from sim.certify import peaks
from sim.certify.numbers.balls import ZERO, NoBoundError, NotProvableError, is_zero
from sim.certify.releases import Releases
from sim.certify.row import Next
from sim.scene.said import reason_of, said

MOST_EVENTS = 10_000
"""Consequences of one run. A certificate of more takes minutes and is asked for by nobody."""


def _nobody() -> None:
    """Nobody waits for signs of life."""


class Limit(NamedTuple):
    """Where a run gives up: after so many changes, or past a time of `monotonic` [s]. `alive` is
    called all along: a proof may take long, and who waits for it should know that it is at work."""

    changes: int = MOST_EVENTS
    moment: float = inf
    alive: Callable[[], object] = _nobody


class BallRun(Releases):
    """A scene on its way from 0 to its end."""

    def go(self, limit: Limit, instants: Sequence[float] = ()) -> None:
        """To the end, within a limit; `seen` then holds the `instants` [s], in order.

        Raises NoBoundError; `told` then holds what was proved before.
        """
        waiting = deque(instants)
        self._start()
        switches, bursts = self.switches(), list(self.inputs.bursts)
        while bursts and is_zero(bursts[0].when.ball):
            self.nothing_strikes_first(bursts[0])
            self.set_free(bursts.pop(0), self.zero)
        self.running = True
        while True:
            limit.alive()
            coming = [one for _, ends in self.phases.values() for one in ends]
            coming += [one for gap in self.gaps for one in self.of_gap(gap)]
            coming += self.halts() + [self._now(one) for one in switches[:1]]
            coming += self.coming_release(bursts)
            first = self.first(coming)
            if waiting:
                known = min((one.when.ends()[0] for one in coming), default=waiting[-1])
                while waiting and waiting[0] <= known:
                    limit.alive()
                    self.look(waiting.popleft())
            if first is None:
                break
            for t in waiting:
                if t > first.when.ends()[1]:
                    break
                limit.alive()
                self.glimpse(t)
            if first.kind == "switch":
                switches = switches[1:]
            elif first.kind == "burst":
                bursts.pop(0)
            self.happened += 1
            if self.happened > limit.changes:
                most = str(limit.changes)
                raise NoBoundError(said("there are more than {most} changes", most=most))
            if monotonic() > limit.moment:
                raise NoBoundError(said("the proof takes too long here"))
            self.present = first.when
            self._happen(first)
        self._peaks_so_far()
        self.settle(self.bodies, self.until)
        self.tell(self.until, "end", tuple(self.names))

    def _peaks_so_far(self) -> None:
        """Of contacts in progress at the end: a force that still grows then has had no peak."""
        for phase, _ in self.phases.values():
            for gap in phase.gaps:
                if not gap.touching:
                    continue
                try:
                    self._see(phase, gap, self.until, "")
                    peak = peaks.greatest(self.touches[gap.index])
                except NotProvableError as error:  # the end is proved all the same
                    self.doubt = self.doubt or reason_of(error)
                    continue
                if peak is not None and peak is not self.until:
                    self.tell(peak, "peak", gap.names)

    def _now(self, one: Next) -> Next:
        """A switch with the bodies that its carts are in now."""
        bodies = tuple(dict.fromkeys(self.bodies[k] for k in one.carts))
        return Next(one.when, one.kind, bodies)

    def _start(self) -> None:
        for gap in self.gaps:
            gap.rate = gap.right.v - gap.left.v
        self.latch()
        for body in self.bodies:
            body.fly(self.zero)
        pulled = [gap for gap in self.gaps if gap.springs]
        self.begin([gap for gap in self.gaps if gap.room < 0 and not gap.joined], self.zero, pulled)
        self.fly([body for body in self.bodies if not self._touches(body)], self.zero)

    def _happen(self, one: Next) -> None:
        if one.kind == "touch" and one.gap is not None:
            self.meet(one.gap, one.when)
        elif one.kind == "clear" and one.gap is not None:
            self.forget(one.bodies)
            self.settle(one.bodies, one.when)
            one.gap.room, one.gap.memory, one.gap.tail = ZERO, ZERO, None
            self.fly(one.bodies, one.when)
        elif one.kind == "end":
            self.phase_ends(one)
        elif one.kind == "burst":
            self.set_free(next(b for b in self.inputs.bursts if b.when is one.when), one.when)
        elif one.kind == "halt" and one.body is not None:
            self.forget(one.bodies)
            self.settle(one.bodies, one.when)
            one.body.v = ZERO
            self.fly(one.bodies, one.when)
            if one.body.held:
                self.tell_carts(one.when, "stop", one.body)
        else:
            self._switch(one)

    def _switch(self, one: Next) -> None:
        held = [body for body in one.bodies if body.held and body.phase is None]
        pressed = self.interrupt(one.bodies, one.when)
        in_contact = {body for gap in pressed for body in (gap.left, gap.right)}
        self.form(pressed, one.when)
        free = [body for body in one.bodies if body not in in_contact]
        self.forget(free)
        self.settle(free, one.when)
        self.fly(free, one.when)
        for body in held:
            if not body.held:
                self.tell_carts(one.when, "start", body)
