"""Square matrices of balls: products, and the Taylor coefficients of y′ = A y.

Arb multiplies in C. Intervals do it number by number, and leave out what is nought.
"""

from __future__ import annotations

from collections.abc import Sequence

from sim.certify.numbers.arithmetic import ARB, Ball, arb
from sim.certify.numbers.balls import ZERO, is_zero

if ARB:
    from flint import arb_mat


class Matrix:
    """By its rows."""

    def __init__(self, rows: Sequence[Sequence[Ball]]) -> None:
        self.size = len(rows)
        if ARB:
            self.balls = arb_mat([list(row) for row in rows])
        else:
            self.rows = [[(k, a) for k, a in enumerate(row) if not is_zero(a)] for row in rows]

    def __matmul__(self, other: Matrix) -> Matrix:
        """This after the other."""
        if not ARB:
            return Matrix([self._mixed(row, other) for row in self.rows])
        made = Matrix.__new__(Matrix)
        made.size, made.balls = self.size, self.balls * other.balls
        return made

    def _mixed(self, row: list[tuple[int, Ball]], other: Matrix) -> list[Ball]:
        found = [ZERO for _ in range(self.size)]
        for k, factor in row:
            for j, a in other.rows[k]:
                found[j] = found[j] + factor * a
        return found

    def of(self, y: Sequence[Ball]) -> list[Ball]:
        """A y."""
        if ARB:
            return list((self.balls * arb_mat(self.size, 1, list(y))).entries())
        return [sum((a * y[k] for k, a in row), ZERO) for row in self.rows]

    def taylor(self, first: Sequence[Ball], order: int) -> list[list[Ball]]:
        """y₁ … y_order of y′ = A y, from y₁ on."""
        found = [list(first)]
        if ARB:
            y = arb_mat(self.size, 1, list(first))
            for n in range(2, order + 1):
                y = self.balls * y / n
                found.append(list(y.entries()))
            return found
        for n in range(2, order + 1):
            share = arb(1) / n
            found.append([one if is_zero(one) else one * share for one in self.of(found[-1])])
        return found
