"""A row of bodies that push each other, enclosed by its Taylor series with a proved remainder.

Member j has inverse mass i_j (nought: it does not move) and the acceleration a_j of its loads; gap
k lies between members k and k + 1, with overlap o, rate s = o′ and N = κ (o − rest) + γ s:

    o′ = s      s′_k = c_k − c_{k+1} + (a_k − a_{k+1})      c_j = i_j (N_{j−1} − N_j − b_j v_j)
    x′ = v      v′_j = c_j + a_j

All of it together is y′ = A y + b. From a ball of y(0) follow balls of the Taylor coefficients
y_n = y⁽ⁿ⁾(0)/n!, by the equations themselves. In the norm ‖y‖ = max(|o|, |x|, |s|/Ω, |v|/Ω),
y⁽ⁿ⁺ʲ⁾ is at most Lʲ ‖y⁽ⁿ⁾‖ with L = ‖A‖; so for |τ| ≤ H what the first n terms leave out of the
r-th derivative of o or x (of s or v: Ω times that) is at most

    Σ_{j>n−r} τʲ/j! L^{j+r−n} n! ‖y_n‖  ≤  ‖y_n‖ L H^q (n!/q!) / (1 − L H/(q+1))     q = n − r + 1

That is the bound ‖A‖^{n+1} τ^{n+1}/(n+1)! e^{‖A‖τ} ‖y‖ with the last known term in place of its own
estimate. The time is cut into pieces with L h = 2; the end of one is the beginning of the next.
Overlaps and rates are carried on their own and not as differences of places, so what touches stays
0 exactly. The first few pieces wrap the set of the one before into a box that is up to e^{Lh} times
as wide; later ones are images of the beginning itself (`transport`).

R. E. Moore, Interval Analysis (1966); N. S. Nedialkov, K. R. Jackson, G. F. Corliss, Validated
solutions of initial value problems for ODEs, Appl. Math. Comput. 105 (1999) 21; R. J. Lohner,
Enclosing the solutions of ordinary initial and boundary value problems (1987).
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import cache
from math import lgamma, log

from sim.certify.numbers.arithmetic import arb, ctx
from sim.certify.numbers.balls import UNIT, ZERO, Ball, is_zero
from sim.certify.oscillation import Line
from sim.certify.signals import DERIVATIVES, Signal

REACH = 2.0
"""L h: a piece holds a third of a swing of the stiffest mode, and the terms fall from the third."""

STILL = 1e-6
"""1/s. As fast as nothing moves: a row that friction holds. Its series has one term."""

SPARE_TIME = 1.3
"""A piece holds for so many times its length: the search for a zero looks a quarter beyond."""


@dataclass(frozen=True, slots=True)
class State:
    """At one moment: overlaps [m] and rates [m/s] by gap; ways [m] and velocities by member."""

    o: tuple[Ball, ...]
    s: tuple[Ball, ...]
    x: tuple[Ball, ...]
    v: tuple[Ball, ...]


@dataclass(frozen=True, slots=True)
class Row:
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
        dragged = _greatest([ZERO, *self.drags])
        slowest = max(damped, float(dragged), STILL)
        omega = arb(stiff**0.5 or slowest)
        ways = [self._row(k, "kappa") / omega + self._row(k, "gamma") for k in gaps]
        return omega, _greatest([omega, *(way + 2 * dragged for way in ways), dragged])

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

    def terms(
        self, start: State, order: int, balanced: Collection[int]
    ) -> tuple[list[list[Ball]], ...]:
        """Taylor coefficients up to `order`: of o, s, x, v."""
        o, s, x, v = ([[one] for one in part] for part in (start.o, start.s, start.x, start.v))
        for n in range(order):
            forces = self.forces([one[n] for one in o], [one[n] for one in s], rest=n == 0)
            pushed = [self.pushed(forces, j) for j in range(len(self.inverses))]
            for j, drag in enumerate(self.drags):
                if not is_zero(drag):
                    pushed[j] = pushed[j] - drag * v[j][n]
            for k in range(len(self.lines)):
                a = pushed[k] - pushed[k + 1]
                if n == 0 and not {k, k + 1} & {*balanced}:
                    a = a + self.pulls[k]
                elif n == 0:
                    a = self._net(k, pushed, balanced) - self._net(k + 1, pushed, balanced)
                o[k].append(s[k][n] / (n + 1))
                s[k].append(a / (n + 1))
            for j in range(len(self.inverses)):
                a = pushed[j] if n else self._net(j, pushed, balanced)
                x[j].append(v[j][n] / (n + 1))
                v[j].append(a / (n + 1))
        return o, s, x, v


class Piece:
    """A stretch of time in which one series holds, from `start` on."""

    def __init__(
        self,
        row: Row,
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
        self.tails = _tails(_greatest(last), rate, self.reach, order)

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
        return Signal(tuple(self.v[j]), tuple(self.omega * tail for tail in self.tails))

    def way(self, j: int) -> Signal:
        """x of a member: how far it has gone."""
        return Signal(tuple(self.x[j]), self.tails)

    def end(self) -> State:
        """Where the next piece begins."""
        tau = self.length
        gaps, members = range(len(self.o)), range(len(self.x))
        place, rate = (arb(1), ZERO, ZERO), (ZERO, arb(1), ZERO)
        return State(
            tuple(self.overlap(k, place).at(tau) for k in gaps),
            tuple(self.overlap(k, rate).at(tau) for k in gaps),
            tuple(self.way(j).at(tau) for j in members),
            tuple(self.speed(j).at(tau) for j in members),
        )


def _push(line: Line, over: Ball, rate: Ball, *, rest: bool) -> Ball:
    return line.kappa * (over - line.rest if rest else over) + line.gamma * rate


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


def _greatest(balls: list[Ball]) -> Ball:
    best = balls[0].upper()
    for one in balls[1:]:
        best = max(best, one.upper())
    return best
