"""The equations of a row of bodies that push each other.

Member j has inverse mass i_j (nought: it does not move) and the acceleration a_j of its loads; gap
k lies between members k and k + 1, with overlap o, rate s = o′ and N = κ (o − rest) + γ s:

    o′ = s      s′_k = c_k − c_{k+1} + (a_k − a_{k+1})      c_j = i_j (N_{j−1} − N_j − b_j v_j)
    x′ = v      v′_j = c_j + a_j

All of it together is y′ = A y + b. Overlaps and rates are carried on their own and not as
differences of places, so what touches stays 0 exactly.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import cached_property

from sim.certify.numbers.arithmetic import arb
from sim.certify.numbers.balls import ZERO, Ball, is_zero
from sim.certify.numbers.matrices import Matrix
from sim.certify.oscillation import Line

STILL = 1e-6
"""1/s. As fast as nothing moves: a row that friction holds. Its series has one term."""


@dataclass(frozen=True, slots=True)
class State:
    """Overlaps [m] and rates [m/s] by gap, displacements [m] and velocities by member."""

    o: tuple[Ball, ...]
    s: tuple[Ball, ...]
    x: tuple[Ball, ...]
    v: tuple[Ball, ...]

    def numbers(self) -> list[Ball]:
        """All of them, o, s, x, v."""
        return [*self.o, *self.s, *self.x, *self.v]

    def reshaped(self, numbers: Sequence[Ball]) -> State:
        """The flat list `numbers` as a State of the same sizes."""
        g, m = len(self.o), len(self.x)
        ends = (0, g, 2 * g, 2 * g + m, 2 * (g + m))
        return State(*(tuple(numbers[a:b]) for a, b in itertools.pairwise(ends)))


@dataclass(frozen=True)
class RowEquations:
    """The equations; `pulls` of a gap is a_k − a_{k+1}, exactly nought where both are the same."""

    lines: tuple[tuple[Line, ...], ...]  # of each gap: a contact's first
    inverses: tuple[Ball, ...]  # 1/kg
    loads: tuple[Ball, ...]  # m/s²
    pulls: tuple[Ball, ...]  # m/s²
    drags: tuple[Ball, ...]  # b/m, 1/s

    def rates(self) -> tuple[Ball, Ball]:
        """Ω and L, 1/s."""
        gaps = range(len(self.lines))
        stiff, damped = (
            max((float(self._row(k, key).upper()) for k in gaps), default=0.0)
            for key in ("kappa", "gamma")
        )
        dragged = greatest([ZERO, *self.drags])
        slowest = max(damped, float(dragged), STILL)
        omega = arb(stiff**0.5 or slowest)
        strengths = [self._row(k, "kappa") / omega + self._row(k, "gamma") for k in gaps]
        return omega, greatest([omega, *(one + 2 * dragged for one in strengths), dragged])

    def _row(self, k: int, key: str) -> Ball:
        """How strongly the forces of a gap and its neighbours act on its rate."""
        total = ZERO
        for other in (k - 1, k, k + 1):
            if 0 <= other < len(self.lines):
                shared = {k, k + 1} & {other, other + 1}
                weight = sum((self.inverses[j] for j in shared), ZERO)
                lines = sum((getattr(line, key) for line in self.lines[other]), ZERO)
                total = total + lines * weight
        return total

    def forces(self, o: Sequence[Ball], s: Sequence[Ball], *, rest: bool) -> list[Ball]:
        """N of every gap, or a Taylor coefficient of it: `rest` belongs to the first alone."""
        return [
            sum((_push(line, over, rate, rest=rest) for line in lines), ZERO)
            for lines, over, rate in zip(self.lines, o, s, strict=True)
        ]

    def _net(self, j: int, pushed: list[Ball], balanced: Collection[int]) -> Ball:
        return ZERO if j in balanced else pushed[j] + self.loads[j]

    def pushed(self, forces: list[Ball], j: int) -> Ball:
        """m/s². What the forces of the gaps around a member do to it."""
        if is_zero(self.inverses[j]):
            return ZERO
        left = forces[j - 1] if j else ZERO
        right = forces[j] if j < len(forces) else ZERO
        return self.inverses[j] * (left - right)

    @cached_property
    def matrix(self) -> Matrix:
        """A, of (o, s, x, v)."""
        g, m = len(self.lines), len(self.inverses)
        rows = [[ZERO] * (2 * g + 2 * m) for _ in range(2 * g + 2 * m)]
        places, speeds = 2 * g, 2 * g + m
        for k in range(g):
            rows[k][g + k] = arb(1)
        for j, inverse in enumerate(self.inverses):
            rows[places + j][speeds + j] = arb(1)
            mine = rows[speeds + j]
            mine[speeds + j] = -self.drags[j]
            for k, sign in ((j - 1, 1), (j, -1)):
                if 0 <= k < g and not is_zero(inverse):
                    for at, key in ((k, "kappa"), (g + k, "gamma")):
                        total = sum((getattr(line, key) for line in self.lines[k]), ZERO)
                        mine[at] = sign * inverse * total
        for k in range(g):
            left, right = rows[speeds + k], rows[speeds + k + 1]
            rows[g + k] = [a - b for a, b in zip(left, right, strict=True)]
        return Matrix(rows)

    def _first(self, start: State, balanced: Collection[int]) -> list[Ball]:
        """y₁: what is the same for two neighbours, or nought, is so exactly."""
        forces = self.forces(start.o, start.s, rest=True)
        pushed = [self.pushed(forces, j) for j in range(len(self.inverses))]
        for j, drag in enumerate(self.drags):
            if not is_zero(drag):
                pushed[j] = pushed[j] - drag * start.v[j]
        net = [self._net(j, pushed, balanced) for j in range(len(self.inverses))]
        turns = [
            net[k] - net[k + 1]
            if {k, k + 1} & {*balanced}
            else pushed[k] - pushed[k + 1] + self.pulls[k]
            for k in range(len(self.lines))
        ]
        return [*start.s, *turns, *start.v, *net]

    def terms(
        self, start: State, order: int, balanced: Collection[int]
    ) -> tuple[tuple[tuple[Ball, ...], ...], ...]:
        """Taylor coefficients up to `order`: of o, s, x, v."""
        rows = [start.numbers(), *self.matrix.taylor(self._first(start, balanced), order)]
        found = start.reshaped(list(zip(*rows, strict=True)))
        return found.o, found.s, found.x, found.v


def _push(line: Line, over: Ball, rate: Ball, *, rest: bool) -> Ball:
    return line.kappa * (over - line.rest if rest else over) + line.gamma * rate


def greatest(balls: list[Ball]) -> Ball:
    """The upper end of them all."""
    best = balls[0].upper()
    for one in balls[1:]:
        best = max(best, one.upper())
    return best
