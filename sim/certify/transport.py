"""The state of a linear row after many pieces, without wrapping.

y(p h) = Φᵖ y(0) + φ_p is linear in the beginning: Φ = e^{Ah} and its powers are balls as thin as
rounding makes them, so a set at the beginning (a gap that is known to one unit of its last place, a
mass with a tolerance) is mapped as a whole and not boxed in again piece by piece. That is Lohner's
remedy against the wrapping effect, which here needs no factorisation: the map is the same for all
pieces, as they have one length.
"""

from __future__ import annotations

from dataclasses import replace

from sim.certify.equations import RowEquations, State
from sim.certify.numbers.arithmetic import arb
from sim.certify.numbers.balls import ZERO, Ball
from sim.certify.numbers.matrices import Matrix
from sim.certify.oscillation import Line, together
from sim.certify.series import Piece


class Transport:
    """From piece to piece, y and a 1 after it: Φ has a column for each of them.

    Φᵖ is a product of powers whose exponents are powers of two: rounding grows with the number of
    factors, log p, and not with e^p as in Φ (Φ (… Φ)).
    """

    def __init__(
        self, row: RowEquations, start: State, length: Ball, omega: Ball, rate: Ball
    ) -> None:
        # overlaps are counted from where a gap has no force: less is left to cancel
        self.rests = tuple(together(lines).rest for lines in row.lines)
        row = replace(row, lines=tuple(map(_moved, row.lines, self.rests)))
        turned = tuple(-rest for rest in self.rests)
        self.start = start = replace(start, o=_added(start.o, turned))
        bare = tuple(tuple(replace(line, rest=ZERO) for line in lines) for lines in row.lines)
        nought = tuple(ZERO for _ in row.inverses)
        alone = replace(row, lines=bare, loads=nought, pulls=tuple(ZERO for _ in row.lines))
        size = len(start.numbers())
        places = range(2 * len(start.o), 2 * len(start.o) + len(start.x))
        columns = []
        for number in range(size):
            unit = start.reshaped([arb(1) if k == number else ZERO for k in range(size)])
            if number not in places:  # where a body is matters to nothing
                unit = Piece(alone, unit, length, omega, rate).end()
            columns.append([*unit.numbers(), ZERO])
        zero = start.reshaped([ZERO] * size)
        columns.append([*Piece(row, zero, length, omega, rate).end().numbers(), arb(1)])
        self.powers = {1: Matrix(list(zip(*columns, strict=True)))}

    def state(self, p: int) -> State:
        """Where piece p begins."""
        found = self.start.reshaped(self._power(p).of([*self.start.numbers(), arb(1)]))
        return replace(found, o=_added(found.o, self.rests))

    def _power(self, p: int) -> Matrix:
        if p not in self.powers:
            lowest = p & -p
            part = p - lowest or p // 2
            self.powers[p] = self._power(part) @ self._power(p - part)
        return self.powers[p]


def _moved(lines: tuple[Line, ...], rest: Ball) -> tuple[Line, ...]:
    if len(lines) == 1:
        return (replace(lines[0], rest=ZERO),)
    return tuple(replace(line, rest=line.rest - rest) for line in lines)


def _added(one: tuple[Ball, ...], other: tuple[Ball, ...]) -> tuple[Ball, ...]:
    return tuple(a + b for a, b in zip(one, other, strict=True))
