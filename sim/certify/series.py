"""A row of bodies that push each other, enclosed by its Taylor series with a proved remainder.

The row obeys y′ = A y + b (`equations`). From a ball of y(0) follow balls of the Taylor
coefficients y_n = y⁽ⁿ⁾(0)/n!. In the norm ‖y‖ = max(|o|, |x|, |s|/Ω, |v|/Ω),
y⁽ⁿ⁺ʲ⁾ is at most Lʲ ‖y⁽ⁿ⁾‖ with L = ‖A‖; so for |τ| ≤ H what the first n terms leave out of the
r-th derivative of o or x (of s or v: Ω times that) is at most

    Σ_{j>n−r} τʲ/j! L^{j+r−n} n! ‖y_n‖  ≤  ‖y_n‖ L H^q (n!/q!) / (1 − L H/(q+1))     q = n − r + 1

That is the bound ‖A‖^{n+1} τ^{n+1}/(n+1)! e^{‖A‖τ} ‖y‖ with the last known term in place of its own
estimate. The time is cut into pieces with L h = 2; the end of one is the beginning of the next.
The first few pieces wrap the set of the one before into a box that is up to e^{Lh} times
as wide; later ones are images of the beginning itself (`transport`).

R. E. Moore, Interval Analysis (1966); N. S. Nedialkov, K. R. Jackson, G. F. Corliss, Validated
solutions of initial value problems for ODEs, Appl. Math. Comput. 105 (1999) 21; R. J. Lohner,
Enclosing the solutions of ordinary initial and boundary value problems (1987).
"""

from __future__ import annotations

from collections.abc import Collection
from functools import cache
from math import lgamma, log

from sim.certify.equations import RowEquations, State, greatest
from sim.certify.numbers.arithmetic import arb, ctx
from sim.certify.numbers.balls import UNIT, ZERO, Ball, is_zero
from sim.certify.signals import DERIVATIVES, Signal

REACH = 2.0
"""L h: a piece holds a third of a swing of the stiffest mode, and the terms fall from the third."""

SPARE_TIME = 1.3
"""A piece holds for so many times its length: the search for a zero looks a quarter beyond."""


class Piece:
    """A stretch of time in which one series holds, from `start` on."""

    def __init__(
        self,
        row: RowEquations,
        start: State,
        length: Ball,
        omega: Ball,
        rate: Ball,
        *,
        balanced: Collection[int] | None = None,
    ) -> None:
        """`balanced`, of a first piece: members that slip just now, with no net force, exactly."""
        self.start, self.length, self.first = start, length, balanced is not None
        self.reach = SPARE_TIME * length
        order = _order(round(float(rate * self.reach), 3), ctx.prec)
        self.o, self.s, self.x, self.v = row.terms(start, order, balanced or ())
        self.row, self.omega = row, omega
        last = [ZERO, *(abs(one[-1]) for one in (*self.o, *self.x))]
        last += [abs(one[-1]) / omega for one in (*self.s, *self.v)]
        self.tails = _tails(greatest(last), rate, self.reach, order)

    def overlap(self, k: int, factors: tuple[Ball, Ball, Ball]) -> Signal:
        """a o + b o′ + c of a gap."""
        a, b, c = factors
        if is_zero(b):
            terms = [a * one for one in self.o[k]]
        elif is_zero(a):
            terms = [b * one for one in self.s[k]]
        else:
            terms = [a * o + b * s for o, s in zip(self.o[k], self.s[k], strict=True)]
        if not is_zero(c):
            terms[0] = terms[0] + c
        wide = abs(a) + abs(b) * self.omega
        return Signal(tuple(terms), tuple(wide * tail for tail in self.tails))

    def contact(self, k: int) -> Signal:
        """N of the contact in a gap."""
        line = self.row.lines[k][0]
        return self.overlap(k, (line.kappa, line.gamma, -line.kappa * line.rest))

    def force(self, k: int) -> Signal:
        """N of all that acts in a gap."""
        lines = self.row.lines[k]
        kappa, gamma = (sum((getattr(o, key) for o in lines), ZERO) for key in ("kappa", "gamma"))
        rest = sum((line.kappa * line.rest for line in lines), ZERO)
        return self.overlap(k, (kappa, gamma, -rest))

    def speed(self, j: int) -> Signal:
        """v of a member."""
        return Signal(self.v[j], tuple(self.omega * tail for tail in self.tails))

    def displacement(self, j: int) -> Signal:
        """x of a member: how far it has gone."""
        return Signal(self.x[j], self.tails)

    def end(self) -> State:
        """Where the next piece begins."""
        tau = self.length
        gaps, members = range(len(self.o)), range(len(self.x))
        place, rate = (arb(1), ZERO, ZERO), (ZERO, arb(1), ZERO)
        return State(
            tuple(self.overlap(k, place).at(tau) for k in gaps),
            tuple(self.overlap(k, rate).at(tau) for k in gaps),
            tuple(self.displacement(j).at(tau) for j in members),
            tuple(self.speed(j).at(tau) for j in members),
        )


@cache
def _order(reach: float, bits: int) -> int:
    """Terms until reachⁿ/n! is less than the last bit."""
    n = 8
    while lgamma(n + 1) - n * log(max(reach, 0.1)) < (bits + 8) * log(2):
        n += 1
    return n


def _tails(last: Ball, rate: Ball, reach: Ball, order: int) -> tuple[Ball, ...]:
    found, ratio = [], arb(1) / (order + 1)  # n!/q! of r = 0
    for r in range(DERIVATIVES):
        q = order - r + 1
        found.append(UNIT * (last * rate * reach**q * ratio / (1 - rate * reach / (q + 1))))
        ratio = ratio * q
    return tuple(found)
