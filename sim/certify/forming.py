"""What is pressed together at a moment, and which motion moves it.

A pair that nobody else touches has a closed form (`phases`); a longer row its series (`coupled`).
Whatever happens to one of its bodies ends the motion of all of them: everything is brought to that
moment, changed, and formed again. A held body belongs to the row, because both of its neighbours
decide whether it slips; a wall does not connect what it touches.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from sim.certify import peaks
from sim.certify.bodies import Body, Gap
from sim.certify.coupled import CoupledPhase
from sim.certify.foresight import Foresight
from sim.certify.instants import Instant
from sim.certify.numbers.balls import ZERO, Ball, NoBoundError, NotProvableError, is_zero
from sim.certify.oscillation import together
from sim.certify.phases import ContactPhase
from sim.certify.row import Next
from sim.certify.touches import Touch
from sim.certify.watches import Watch, grips, open_gap, swing_ends
from sim.scene.said import said


class Forming(Foresight):
    """Motions of bodies that touch."""

    def interrupt(self, bodies: Iterable[Body], now: Instant, *, stuck: bool = False) -> list[Gap]:
        """End the motions of these bodies at `now`; returns the gaps that they pushed in.

        What pushes carts that stick to a wall goes on, unless `stuck`: these may come loose.
        """
        found: list[Gap] = []
        mine = {body for body in bodies if body.mass is not None or (stuck and body.carts)}
        for key in [k for k, (phase, _) in self.phases.items() if mine & _beside(phase)]:
            phase, _ = self.phases[key]
            for gap in phase.gaps:
                if phase.begun is not now and gap.touching:
                    self._see(phase, gap, now, "")
                    self.touches[gap.index].fresh = False
            self.leave(key, now)
            found += phase.gaps
        return found

    def _see(self, phase: ContactPhase | CoupledPhase, gap: Gap, now: Instant, cause: str) -> None:
        peaks.note_peak(self.touches[gap.index], phase, now, cause)

    def leave(self, key: int, now: Instant) -> None:
        """Out of a motion: bodies and gaps are settled, and in flight."""
        phase, _ = self.phases[key]
        self.forget(phase.bodies)
        self.settle(phase.bodies, now)
        del self.phases[key]
        for body in phase.bodies:
            body.phase = None
        for gap in phase.gaps:
            self.coupled.pop(gap.index, None)

    def form(self, gaps: Iterable[Gap], now: Instant) -> None:
        """What touches at these gaps moves on from `now`; everything around is settled."""
        waiting = {gap.index: gap for gap in gaps if gap.bound}
        while waiting:
            row = self._row_of(waiting[min(waiting)])
            for gap in row:
                waiting.pop(gap.index, None)
            self._judge(row, now)
            gap = row[0]
            if len(row) == 1 and not gap.springs and not self._dragged(gap):
                self._pair(gap, now)
            elif len(row) == 1 and gap.swings and not self._dragged(gap):
                self._swing(gap, now)
            else:
                self._coupled([gap.left, *(one.right for one in row)], row, now)

    def _row_of(self, gap: Gap) -> list[Gap]:
        """The gaps in which something acts, connected to this one, from left to right."""
        found = {gap.index: gap}
        grows = True
        while grows:
            bodies = {b for g in found.values() for b in (g.left, g.right) if b.mass is not None}
            more = [
                g
                for g in self.gaps
                if g.bound and g.index not in found and {g.left, g.right} & bodies
            ]
            found |= {g.index: g for g in more}
            grows = bool(more)
        return [found[k] for k in sorted(found)]

    def _judge(self, row: list[Gap], now: Instant) -> None:
        """Whom friction holds under the forces of all its contacts."""
        pushes: dict[Body, Ball] = {}
        for gap in row:
            force = self.push(gap)
            for body, direction in ((gap.left, -1), (gap.right, 1)):
                if body.mass is not None:
                    pushes[body] = pushes.get(body, ZERO) + direction * force
        for body, push in pushes.items():
            if body.slips is not now or not is_zero(body.v):  # else its force is that of friction
                held = body.held
                body.fly(now, push)
                if held != body.held and self.running:
                    self._tell_grip(body, now)
            body.phase = None

    def _tell_grip(self, body: Body, now: Instant) -> None:
        """Friction lets go of it, or takes hold; but not for one of two touches of an instant."""
        kind, undone = ("stop", "start") if body.held else ("start", "stop")
        if not self.untell_carts(now, undone, body):
            self.tell_carts(now, kind, body)

    def push(self, gap: Gap) -> Ball:
        """N. Of all that acts in a gap, at its `since`."""
        contact = self.touches[gap.index].force() if gap.touching else ZERO
        return contact + gap.pulled() if gap.springs else contact

    def fly(self, bodies: Iterable[Body], now: Instant) -> None:
        """New motions of who is free; where air drags, that is a series too."""
        bodies = [body for body in bodies if body.carts]
        super().fly(bodies, now)
        for body in dict.fromkeys(bodies):
            if body.phase is None and not body.still and not is_zero(body.drag):
                self._coupled([body], [], now)

    def _dragged(self, gap: Gap) -> bool:
        both = (gap.left, gap.right)
        return all(b.still for b in both) or any(not b.still and not is_zero(b.drag) for b in both)

    def _pair(self, gap: Gap, now: Instant) -> None:
        touch = self.touches[gap.index]
        phase = ContactPhase(gap, touch.line, now)
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
        self._moves(phase, ends)

    def _swing(self, gap: Gap, now: Instant) -> None:
        """Springs alone between two: a formula, for as many swings as they like."""
        phase = ContactPhase(gap, together(gap.springs), now)
        horizon = self.until.minus(now).upper().mid()
        bodies, ends = (gap.left, gap.right), []
        if horizon > 0:
            for tau, cause in swing_ends(phase, horizon):
                ends.append(Next(now.after(tau), "end", bodies, gap, cause))
                horizon = min(horizon, tau.upper().mid())
            for tau, cause, body in phase.grips(horizon):
                ends.append(Next(now.after(tau), "end", bodies, gap, cause, body))
        self._moves(phase, ends)
        self.coupled[gap.index] = phase

    def _coupled(self, row: list[Body], gaps: list[Gap], now: Instant) -> None:
        touches = {k: self.touches[gap.index] for k, gap in enumerate(gaps) if gap.touching}
        lines = [
            ((touches[k].line, *gap.springs) if gap.touching else gap.springs)
            for k, gap in enumerate(gaps)
        ]
        phase = CoupledPhase(row, gaps, lines, now)
        watches: list[Watch] = []
        for k, gap in enumerate(gaps):
            watches += touches[k].watches(k, now) if gap.touching else open_gap(gap, k)
        silent = {b for t in touches.values() if t.turns_at_rest for b in (t.gap.left, t.gap.right)}
        watches += grips(row, gaps, now, silent)
        horizon = self.until.minus(now).upper().mid()
        ends = []
        if horizon > 0:
            for tau, watch in phase.first(watches, horizon):
                when, bodies = now.after(tau), phase.bodies
                ends.append(Next(when, "end", bodies, watch.gap, watch.cause, watch.body))
        self._moves(phase, ends)
        self.coupled |= {gap.index: phase for gap in gaps}

    def _moves(self, phase: ContactPhase | CoupledPhase, ends: list[Next]) -> None:
        for body in phase.bodies:
            body.phase = phase
        key = phase.gaps[0].index if phase.gaps else -1 - phase.bodies[0].carts[0]
        self.phases[key] = (phase, ends)
        self.forget(phase.bodies)

    def presses(self, gap: Gap, now: Instant) -> bool:
        """Do two that touch at rest to each other press at once? By the first known derivative."""
        displacements = []
        for body in (gap.left, gap.right):
            phase: Any = body.phase
            if phase is None:
                displacements.append([ZERO])
                continue
            if phase.begun is not now:
                raise NotProvableError(said("whether {pair} meet", pair=gap.shown))
            if isinstance(phase, ContactPhase):
                phase = CoupledPhase([phase.left, phase.right], [phase.gap], [(phase.line,)], now)
            terms = phase.jerks(body)
            if body.balanced is now:
                terms[2] = ZERO
            displacements.append(terms)
        steady = (
            ZERO if b.still or b.balanced is now else b.acceleration(now)
            for b in (gap.left, gap.right)
        )
        left, right = steady
        loads = ZERO if left is right else (right - left) / 2
        for n in range(2, max(map(len, displacements))):
            one, other = (own[n] if n < len(own) else ZERO for own in displacements)
            term = other - one + (loads if n == 2 else ZERO)
            if term < 0:
                return True
            if term > 0:
                return False
            if not is_zero(term):
                break
        raise NotProvableError(said("whether {pair} meet", pair=gap.shown))


def _beside(phase: ContactPhase | CoupledPhase) -> set[Body]:
    """Its bodies, and what does not move and is pushed by them."""
    return {*phase.bodies, *(body for gap in phase.gaps for body in (gap.left, gap.right))}


def rest_against(gap: Gap) -> None:
    """A body whose neighbour is still has stopped: the gap neither opens nor closes, exactly."""
    if gap.left.still or gap.right.still:
        gap.rate = ZERO


def no_joint(touch: Touch) -> None:
    """The damper of a pair is that of its two masses: a joint would change it on the way."""
    if not is_zero(touch.line.gamma):
        raise NoBoundError(
            said("a cart joins or leaves another while {pair} touch", pair=touch.gap.shown)
        )
