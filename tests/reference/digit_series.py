"""The motion of a row as a power series, and the first zero of what ends a branch."""

from __future__ import annotations

from typing import Any

from mpmath import mp, mpf

from tests.reference.digit_row import NOTHING, DigitRow, Group

ORDER = 44
GRID = 24


class Series(DigitRow):
    """Motions of a row as power series in the time from now on."""

    def series(self) -> None:
        """Coefficients of displacement and velocity of every group."""
        self.sx = {id(g): [mpf(0)] for g in self.groups}
        self.sv = {id(g): [mpf(0) if g.held or g.fixed else g.v] for g in self.groups}
        constant = {}
        for g in self.groups:
            constant[id(g)] = self.outer(g) - g.sliding * self.grip(g)[0]
        acting = self.acting()
        order = ORDER if acting or any(self.drag) else 3
        for n in range(order):
            force = {id(g): (constant[id(g)] if n == 0 else mpf(0)) for g in self.groups}
            for k, (a, b, c) in acting:
                d, s = self._term(k, n)
                push = a * d + b * s + (c if n == 0 else 0)
                for cart, way in ((k - 1, -1), (k, 1)):
                    if (g := self.group(cart)) is not None:
                        force[id(g)] += way * push
            for g in self.groups:
                still = g.held or g.fixed
                force[id(g)] -= sum(self.drag[k] for k in g.carts) * self.sv[id(g)][n]
                a = mpf(0) if still else force[id(g)] / self.mass(g)
                self.sx[id(g)].append(self.sv[id(g)][n] / (n + 1))
                self.sv[id(g)].append(a / (n + 1))

    def _term(self, k: int, n: int) -> tuple[mpf, mpf]:
        """n-th coefficient of overlap and rate of gap k."""
        d = s = mpf(0)
        for cart, way in ((k - 1, 1), (k, -1)):
            if (g := self.group(cart)) is not None:
                d += way * self.sx[id(g)][n]
                s += way * self.sv[id(g)][n]
        if n == 0:
            d = self.overlap(k)[0]
        return d, s

    def _series_of(self, k: int, factors: tuple[Any, Any, Any]) -> list[mpf]:
        a, b, c = (mpf(one) for one in factors)
        length = len(self.sv[id(self.groups[0])])
        found = []
        for n in range(length):
            d, s = self._term(k, n)
            found.append(a * d + b * s + (c if n == 0 else 0))
        return found

    def watches(self) -> list[tuple[list[mpf], tuple[str, Any]]]:
        found: list[tuple[list[mpf], tuple[str, Any]]] = []
        for k, pair in self.pairs.items():
            if k in self.joined:
                continue
            if pair is None:
                found.append((self._series_of(k, (-1, 0, 0)), ("hit", k)))
                continue
            for factors, state in pair.watches():
                found.append((self._series_of(k, factors), (state, k)))
        for g in self.groups:
            if g.sliding and not g.fixed:
                found.append(([g.sliding * c for c in self.sv[id(g)]], ("halt", g)))
            elif g.held:
                found += self._slips(g)
        return found

    def _slips(self, g: Group) -> list[tuple[list[mpf], tuple[str, Any]]]:
        static = self.grip(g)[1]
        total = [mpf(0)] * len(self.sv[id(g)])
        total[0] = self.outer(g)
        for k, factors in self.acting():
            for cart, way in ((k - 1, -1), (k, 1)):
                if cart in g.carts:
                    total = [
                        a + way * b for a, b in zip(total, self._series_of(k, factors), strict=True)
                    ]
        return [
            ([(static if n == 0 else 0) - way * c for n, c in enumerate(total)], ("slip", g))
            for way in (1, -1)
        ]

    def quick(self) -> mpf:
        """s. Of one step."""
        rate = mpf(0)
        for k, (a, b, _) in self.acting():
            light = self._inverse(k - 1) + self._inverse(k)
            rate = max(rate, mp.sqrt(a * light) + b * light)
        for g in self.groups:
            rate = max(rate, sum(self.drag[k] for k in g.carts) / self.mass(g))
        end = mpf(self.scene.until)
        step = mpf("0.3") / rate if rate else end / 50
        step = min(step, end - self.t)
        for _, begin, stop, _ in self.pushes:
            for at in (begin, stop):
                if at > self.t:
                    step = min(step, at - self.t)
        return step


def value(coefficients: list[mpf], t: mpf) -> mpf:
    total = mpf(0)
    for one in reversed(coefficients):
        total = total * t + one
    return total


def first_negative(coefficients: list[mpf], step: mpf) -> mpf | None:
    """Where a polynomial that is not negative at 0 first passes through nought, up to `step`."""
    scale = max((abs(c) for c in coefficients), default=mpf(0))
    if not scale:
        return None
    if abs(coefficients[0]) <= NOTHING:
        lead = next((c for c in coefficients[1:] if abs(c) > NOTHING), mpf(0))
        if lead <= 0:
            return mpf(0) if lead < 0 else None
        coefficients = [mpf(0), *coefficients[1:]]
    elif coefficients[0] < 0:
        return mpf(0)
    before = mpf(0)
    for j in range(1, GRID + 1):
        at = step * j / GRID
        if value(coefficients, at) < 0:
            low, high = before, at
            for _ in range(190):
                middle = (low + high) / 2
                if value(coefficients, middle) < 0:
                    high = middle
                else:
                    low = middle
            return high
        before = at
    return None
