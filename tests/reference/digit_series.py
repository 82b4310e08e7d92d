"""The motion of a row as a power series, with some eighty digits.

Time is counted in units h of the stiffest swing, so that all coefficients yₙ hⁿ are of one size:
integers in units of 2⁻ᴮᴵᵀˢ m hold them, and Python adds and multiplies those ten times as fast as
floating numbers of so many digits. What ends a branch is one such series too (`digit_roots`).
"""

from __future__ import annotations

from typing import Any

from mpmath import mp, mpf
from mpmath.libmp import from_man_exp, to_fixed

from tests.reference.digit_row import DigitRow, Group

BITS = 280
"""Of the fraction: 84 digits. A step loses two or three of them."""

REACH = mpf("0.8")
"""A step in units of the stiffest swing of one gap; of a row it may be twice as much."""

ORDER = 60
"""1.6⁶⁰/60! = 2e-70, four digits less than what is looked at."""

Series = list[int]
"""Coefficients of powers of t/h."""


def fixed(x: Any) -> int:
    """In units of 2⁻ᴮᴵᵀˢ."""
    return int(to_fixed(mpf(x)._mpf_, BITS))


def digits(n: int) -> mpf:
    """Back, exactly."""
    return mp.make_mpf(from_man_exp(n, -BITS))


def value(coefficients: Series, t: int) -> int:
    """Of a series at a time in units of h, both in units of 2⁻ᴮᴵᵀˢ."""
    total = 0
    for one in reversed(coefficients):
        total = (total * t >> BITS) + one
    return total


class Motions(DigitRow):
    """Motions of a row as power series in the time from now on."""

    def series(self) -> None:
        """`sx`, `sv`: displacement [m] and velocity times h [m] of every group."""
        self.h = self._unit()
        h, groups = self.h, self.groups
        index = {k: j for j, g in enumerate(groups) for k in g.carts}
        gaps = [
            (index.get(k - 1), index.get(k), self._start(k), fixed(a * h * h), fixed(b * h), c)
            for k, (a, b, c) in self.acting()
        ]
        still = [g.held or g.fixed for g in groups]
        x = [[0] for _ in groups]
        v = [[0 if rests else fixed(g.v * h)] for g, rests in zip(groups, still, strict=True)]
        light = [0 if r else fixed(1 / self.mass(g)) for g, r in zip(groups, still, strict=True)]
        drag = [fixed(sum(self.drag[k] for k in g.carts) * h) for g in groups]
        first = [fixed((self.outer(g) - g.sliding * self.grip(g)[0]) * h * h) for g in groups]
        for n in range(ORDER if gaps or any(drag) else 2):
            push = first if n == 0 else [0] * len(groups)
            for left, right, start, a, b, c in gaps:
                over = start if n == 0 else _differ(x, left, right, n)
                force = a * over + b * _differ(v, left, right, n) >> BITS
                force += fixed(c * h * h) if n == 0 else 0
                if left is not None:
                    push[left] -= force
                if right is not None:
                    push[right] += force
            for j, total in enumerate(push):
                net = total - (drag[j] * v[j][n] >> BITS)
                x[j].append(v[j][n] // (n + 1))
                v[j].append((net * light[j] >> BITS) // (n + 1))
        self.index, self.sx, self.sv = index, x, v

    def _start(self, k: int) -> int:
        return fixed(self.overlap(k)[0])

    def _unit(self) -> mpf:
        """s. In which nothing changes much; all the time where nothing swings."""
        rate = mpf(0)
        for k, (a, b, _) in self.acting():
            light = self._inverse(k - 1) + self._inverse(k)
            rate = max(rate, mp.sqrt(a * light) + b * light)
        for g in self.groups:
            rate = max(rate, sum(self.drag[k] for k in g.carts) / self.mass(g))
        end = mpf(self.scene.until)
        return min(REACH / rate, end) if rate else end

    def of_gap(self, k: int, factors: tuple[Any, Any, Any]) -> Series:
        """a d + b s + c."""
        a, b, c = factors
        left, right = self.index.get(k - 1), self.index.get(k)
        a, b = fixed(a), fixed(b / self.h)
        found = []
        for n in range(len(self.sv[0])):
            over = self._start(k) if n == 0 else _differ(self.sx, left, right, n)
            found.append(a * over + b * _differ(self.sv, left, right, n) >> BITS)
        found[0] += fixed(c)
        return found

    def watches(self) -> list[tuple[Series, tuple[str, Any]]]:
        """What stays positive until it ends a branch, and what it then does."""
        found: list[tuple[Series, tuple[str, Any]]] = []
        for k, length in self.loose.items():
            if k not in self.joined:
                found.append((self.of_gap(k, (1, 0, length)), ("fall", k)))
        for k, pair in self.pairs.items():
            if k in self.joined:
                continue
            if pair is None:
                found.append((self.of_gap(k, (-1, 0, 0)), ("hit", k)))
                continue
            for factors, state in pair.watches():
                found.append((self.of_gap(k, factors), (state, k)))
        for j, g in enumerate(self.groups):
            if g.sliding and not g.fixed:
                found.append(([g.sliding * c for c in self.sv[j]], ("halt", g)))
            elif g.held:
                found += self._slips(g)
        return found

    def _slips(self, g: Group) -> list[tuple[Series, tuple[str, Any]]]:
        total = [0] * len(self.sv[0])
        total[0] = fixed(self.outer(g))
        for k, factors in self.acting():
            for cart, way in ((k - 1, -1), (k, 1)):
                if cart in g.carts:
                    push = self.of_gap(k, factors)
                    total = [a + way * b for a, b in zip(total, push, strict=True)]
        static = fixed(self.grip(g)[1])
        found: list[tuple[Series, tuple[str, Any]]] = []
        for way in (1, -1):
            room = [-way * c for c in total]
            room[0] += static
            found.append((room, ("slip", g)))
        return found


def _differ(of: list[Series], left: int | None, right: int | None, n: int) -> int:
    """Left less right; a wall stands still."""
    return (of[left][n] if left is not None else 0) - (of[right][n] if right is not None else 0)
