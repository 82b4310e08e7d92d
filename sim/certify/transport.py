"""The state of a linear row after many pieces, without wrapping.

y(p h) = Φᵖ y(0) + φ_p is linear in the beginning: Φ = e^{Ah} and its powers are balls as thin as
rounding makes them, so a set at the beginning (a gap that is known to one unit of its last place, a
mass with a tolerance) is mapped as a whole and not boxed in again piece by piece. That is Lohner's
remedy against the wrapping effect, which here needs no factorisation: the map is the same for all
pieces, as they have one length.
"""

from __future__ import annotations

from dataclasses import replace

from sim.certify.numbers.arithmetic import arb
from sim.certify.numbers.balls import ZERO, Ball, is_zero
from sim.certify.oscillation import Line
from sim.certify.series import Piece, Row, State


class Transport:
    """From piece to piece: a column for each number of the beginning, and one for the loads."""

    def __init__(self, row: Row, start: State, length: Ball, omega: Ball, rate: Ball) -> None:
        self.rests = tuple(_rest(lines) for lines in row.lines)
        row = replace(row, lines=tuple(map(_moved, row.lines, self.rests)))
        turned = tuple(-rest for rest in self.rests)
        self.start = start = replace(start, o=_added(start.o, turned))
        bare = tuple(tuple(replace(line, rest=ZERO) for line in lines) for lines in row.lines)
        nought = tuple(ZERO for _ in row.inverses)
        alone = replace(row, lines=bare, loads=nought, pulls=tuple(ZERO for _ in row.lines))
        units = [_unit(start, number) for number in range(len(_free(start)))]
        self.images = [Piece(alone, unit, length, omega, rate).end() for unit in units]
        zero = _unit(start, -1)
        self.added = Piece(row, zero, length, omega, rate).end()
        self.columns, self.loads, self.reached = units, zero, 0

    def state(self, p: int) -> State:
        """Where piece p begins; asked for in rising order."""
        while self.reached < p:
            self.columns = [self._image(column) for column in self.columns]
            self.loads = _sum([(arb(1), self._image(self.loads)), (arb(1), self.added)])
            self.reached += 1
        rows = [*zip(_free(self.start), self.columns, strict=True), (arb(1), self.loads)]
        found = _sum(rows)
        return replace(found, x=_added(found.x, self.start.x), o=_added(found.o, self.rests))

    def _image(self, state: State) -> State:
        moved = _sum(list(zip(_free(state), self.images, strict=True)))
        return replace(moved, x=_added(moved.x, state.x))


def _rest(lines: tuple[Line, ...]) -> Ball:
    """m. Overlaps are counted from where a gap has no force: less is left to cancel."""
    if len(lines) == 1:
        return lines[0].rest
    stiff = sum((line.kappa for line in lines), ZERO)
    return sum((line.kappa * line.rest for line in lines), ZERO) / stiff


def _moved(lines: tuple[Line, ...], rest: Ball) -> tuple[Line, ...]:
    if len(lines) == 1:
        return (replace(lines[0], rest=ZERO),)
    return tuple(replace(line, rest=line.rest - rest) for line in lines)


def _free(state: State) -> list[Ball]:
    """All that the motion depends on: where a body is does not matter, but for the overlaps."""
    return [*state.o, *state.s, *state.v]


def _unit(like: State, number: int) -> State:
    gaps, members = len(like.o), len(like.v)
    ones = [arb(1) if k == number else ZERO for k in range(2 * gaps + members)]
    x = tuple(ZERO for _ in like.x)
    return State(tuple(ones[:gaps]), tuple(ones[gaps : 2 * gaps]), x, tuple(ones[2 * gaps :]))


def _sum(weighted: list[tuple[Ball, State]]) -> State:
    rows = [(weight, state) for weight, state in weighted if not is_zero(weight)]

    def part(key: str) -> tuple[Ball, ...]:
        columns = zip(*(getattr(state, key) for _, state in rows), strict=True)
        return tuple(
            sum((w * one for (w, _), one in zip(rows, column, strict=True)), ZERO)
            for column in columns
        )

    if not rows:
        first = weighted[0][1]
        return _unit(first, -1)
    return State(part("o"), part("s"), part("x"), part("v"))


def _added(one: tuple[Ball, ...], other: tuple[Ball, ...]) -> tuple[Ball, ...]:
    return tuple(a + b for a, b in zip(one, other, strict=True))
