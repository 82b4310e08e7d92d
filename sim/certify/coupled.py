"""Three and more bodies that push each other at once: one motion, enclosed by its series.

The linear branch of every contact holds until one of them ends. Piece after piece of the series is
searched for the first zero of each of their ends; the first piece that has one has them all. A
function that is nought at the beginning (an overlap at the touch, a rate at the turn) is divided by
the powers of τ that are exactly a factor of it.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator

from sim.certify.bodies import Body, Gap
from sim.certify.equations import RowEquations, State
from sim.certify.instants import Instant
from sim.certify.numbers.arithmetic import ARB, arb
from sim.certify.numbers.balls import ZERO, Ball, NoBoundError, NotProvableError, is_zero
from sim.certify.numbers.roots import first_root
from sim.certify.oscillation import Line
from sim.certify.series import REACH, SPARE_TIME, Piece
from sim.certify.signals import Signal
from sim.certify.transport import Transport
from sim.certify.watches import Watch
from sim.scene.said import Said, listed, said

MOST_PIECES = 5000 if ARB else 400
"""Of one motion: some thousand swings of its stiffest mode, or a hundred where intervals take
ten times as long. Between two events of a contact there are one to five."""


WRAPPED = 4
"""Pieces that begin where the one before ends: a contact is over before it shows."""


class CoupledPhase:
    """A row in one branch of each of its contacts; all its bodies point here until one ends."""

    def __init__(
        self, row: list[Body], gaps: list[Gap], lines: list[tuple[Line, ...]], now: Instant
    ) -> None:
        self.row, self.gaps, self.begun = row, gaps, now
        self.bodies = tuple(body for body in self.row if body.mass is not None)
        loads = [ZERO if body.still else body.acceleration(now) for body in self.row]
        inverses = [ZERO if body.still else 1 / body.mass for body in self.row]
        self.equations = RowEquations(
            tuple(lines),
            tuple(inverses),
            tuple(loads),
            tuple(ZERO if a is b else a - b for a, b in itertools.pairwise(loads)),
            tuple(ZERO if body.still else body.drag / body.mass for body in self.row),
        )
        self.omega, self.rate = self.equations.rates()
        self.length = arb(REACH / float(self.rate))
        self.transport: Transport | None = None
        start = State(
            tuple(-gap.room for gap in gaps),
            tuple(-gap.rate for gap in gaps),
            tuple(ZERO for _ in self.row),
            tuple(ZERO if body.still else body.v for body in self.row),
        )
        slipping = [j for j, body in enumerate(row) if body.balanced is now]
        self.pieces = [
            Piece(self.equations, start, self.length, self.omega, self.rate, balanced=slipping)
        ]

    def piece(self, p: int) -> Piece:
        """From p lengths after the beginning on."""
        while len(self.pieces) <= p:
            if p >= MOST_PIECES:
                reason = said(
                    "{carts} push each other for more than {most} pieces of the series",
                    carts=listed([gap.shown for gap in self.gaps]),
                    most=str(MOST_PIECES),
                )
                raise NoBoundError(reason)
            start = self.pieces[-1].end() if p < WRAPPED else self._carried(len(self.pieces))
            self.pieces.append(Piece(self.equations, start, self.length, self.omega, self.rate))
        return self.pieces[p]

    def _carried(self, p: int) -> State:
        if self.transport is None:
            start = self.pieces[0].start
            self.transport = Transport(self.equations, start, self.length, self.omega, self.rate)
        return self.transport.state(p)

    # ------------------------------------------------------------------ where everything is

    def _at(self, signal: Callable[[Piece], Signal], tau: Ball) -> Ball:
        """A signal at a time, or over some, after the beginning."""
        p = max(0, int(float(tau.mid() / self.length)))
        inner = tau - p * self.length
        slack = (SPARE_TIME - 1) * self.length
        if inner + slack >= 0 and inner <= self.length + slack:
            return signal(self.piece(p)).at(inner)
        first = max(0, int(float(tau.lower() / self.length)) - 1)
        last = int(float(tau.upper() / self.length)) + 1
        whole = ZERO.union(self.length)
        values = [signal(self.piece(p)).at(whole) for p in range(first, last + 1)]
        found = values[0]
        for one in values[1:]:
            found = found.union(one)
        return found

    def displacement(self, body: Body, start: Instant, end: Instant) -> Ball:
        """m. Between two times of the motion."""
        if body.still:
            return ZERO
        j = self.row.index(body)
        until = self._at(lambda piece: piece.displacement(j), end.minus(self.begun))
        if start is self.begun:
            return until
        return until - self._at(lambda piece: piece.displacement(j), start.minus(self.begun))

    def speed(self, body: Body, now: Instant) -> Ball:
        """m/s."""
        if body.still:
            return ZERO
        j = self.row.index(body)
        return self._at(lambda piece: piece.speed(j), now.minus(self.begun))

    def acceleration(self, body: Body, now: Instant) -> Ball:
        """m/s²."""
        if body.still:
            return ZERO
        j = self.row.index(body)
        return self._at(lambda piece: piece.speed(j).slope(), now.minus(self.begun))

    def between(self, gap: Gap, now: Instant) -> tuple[Ball, Ball]:
        """Room [m] and rate [m/s] of one of its gaps."""
        k, tau = self.gaps.index(gap), now.minus(self.begun)
        one, none = arb(1), ZERO
        room = self._at(lambda piece: piece.overlap(k, (-one, none, none)), tau)
        return room, self._at(lambda piece: piece.overlap(k, (none, -one, none)), tau)

    def force(self, gap: Gap, tau: Ball) -> Ball:
        """N of the contact in a gap."""
        k = self.gaps.index(gap)
        return self._at(lambda piece: piece.contact(k), tau)

    def jerks(self, body: Body) -> list[Ball]:
        """Taylor coefficients of the displacement at the beginning, without what its load does."""
        if body.still:
            return [ZERO]
        first, j = self.pieces[0], self.row.index(body)
        forces = self.equations.forces(first.start.o, first.start.s, rest=True)
        terms = list(first.x[j])
        terms[2] = (self.equations.pushed(forces, j) - self.equations.drags[j] * body.v) / 2
        return terms

    # ------------------------------------------------------------------ what ends it

    def first(self, watches: list[Watch], horizon: Ball) -> list[tuple[Ball, Watch]]:
        """The first zero of each in the first piece that has one; none up to `horizon` [s]."""
        p = 0
        while p * self.length < horizon:
            piece = self.piece(p)
            found = self._in_piece(piece, watches, self.length)
            beyond = max((one[0].upper() for one in found), default=ZERO)
            if beyond > self.length:
                found = self._in_piece(piece, watches, beyond)
            if found:
                return [(tau + p * self.length, watch) for tau, watch in found]
            p += 1
        return []

    def _in_piece(self, piece: Piece, watches: list[Watch], end: Ball) -> list[tuple[Ball, Watch]]:
        found = []
        for watch in watches:
            signal = watch.signal(piece)
            if piece.first:
                signal = signal.begun(piece.reach)
                if signal.terms[0] < 0:
                    raise NotProvableError(watch.doubt)
            tau = first_root(signal.at, signal.slope().at, end, watch.doubt)
            if tau is not None:
                found.append((tau, watch))
        return found

    def crests(self, gap: Gap, until: Ball) -> Iterator[tuple[Ball, Ball]]:
        """When the force of a gap stops growing [s], and what it is then [N]; perhaps at once."""
        k = self.gaps.index(gap)
        doubt = said("when the force between {pair} is greatest", pair=gap.shown)
        at, rising, p = ZERO, False, 0
        while p * self.length < until.upper():
            piece = self.piece(p)
            slope = piece.contact(k).slope()
            if p == 0:
                slope = slope.begun(piece.reach)
                rising = bool(slope.terms[0] > 0)
                if not rising:
                    if not slope.terms[0] <= 0:
                        raise NotProvableError(doubt)
                    yield ZERO, self.force(gap, ZERO)
                if all(map(is_zero, slope.terms)):  # friction holds all of them
                    return
            while at < self.length:
                root = _turns(slope, at, self.length, doubt, rising=rising)
                if root is None:
                    break
                tau = root + p * self.length
                if rising and tau < until:
                    yield tau, piece.contact(k).at(root)
                elif not tau > until and not tau < until:
                    raise NotProvableError(doubt)
                rising, at = not rising, root.upper().mid()
            at = max(ZERO, at - self.length)
            p += 1


def _turns(slope: Signal, at: Ball, end: Ball, doubt: Said, *, rising: bool) -> Ball | None:
    """Where a slope changes its sign next after `at`."""
    sign, curve = (1 if rising else -1), slope.slope()
    root = first_root(
        lambda t: sign * slope.at(at + t),
        lambda t: sign * curve.at(at + t),
        (end - at).mid(),
        doubt,
    )
    return None if root is None else root + at
