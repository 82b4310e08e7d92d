"""One body under constant forces and drag with a square: Riccati's equation, in closed form.

    w' = A − gamma w − kappa w²      w >= 0: velocity in the direction in which it goes

With w = u'/(kappa u) it is linear: u'' + gamma u' − kappa A u = 0, u(0) = 1, u'(0) = kappa w0. Let
D = gamma²/4 + kappa A and Omega = sqrt |D|. Written so that nothing cancels:

    D > 0   W = A/(gamma/2 + Omega) ,  d = (W − w0)/(2 Omega) ,  E = e^(−2 Omega t) − 1
            w = (w0 − (gamma/2 + Omega) d E)/(1 + kappa d E) ,  x = W t + ln(1 + kappa d E)/kappa
    D <= 0  u = e^(−gamma t/2) (cos Omega t + (kappa w0 + gamma/2) sin(Omega t)/Omega)
            x = ln(u)/kappa: it is slowed and turned back, never longer than half a swing

For times so short that drag has hardly acted the power series is summed instead. A body that is
turned back goes on from rest in the other direction. Source: Riccati's substitution, any textbook.
Errors: some ten units in the last place.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import count
from operator import mul, truediv

SHORT = 0.25
"""Of (gamma + 2 kappa w0 + 2 Omega) t. Below it the series is summed."""

TERMS = 24
"""0.25^24 is 4e-15, and the terms fall faster than that."""

FAINT = 1e-20
"""Of the first terms. Two in a row that are smaller add nothing, nor do later ones; one alone may
be nought where others are not, as every second one from rest."""

KEPT = 8
"""Times of which place, speed and acceleration are kept."""

MOST_MARKS = 60
"""Stretches drawn: each twice as long as the one before."""


@dataclass(frozen=True, slots=True)
class OneWay:
    """Motion from w0 >= 0 in one direction."""

    w0: float
    push: float  # A, m/s²
    gamma: float  # 1/s
    kappa: float  # 1/m
    square: float = field(init=False)
    omega: float = field(init=False)

    def __post_init__(self) -> None:
        square = 0.25 * self.gamma * self.gamma + self.kappa * self.push
        object.__setattr__(self, "square", square)
        object.__setattr__(self, "omega", math.sqrt(abs(square)))

    def at(self, t: float) -> tuple[float, float]:
        """Displacement [m] and w [m/s]."""
        if t == 0.0:
            return 0.0, self.w0
        if self._haste() * t < SHORT:
            return self._summed(t)
        half, kappa, omega = 0.5 * self.gamma, self.kappa, self.omega
        if self.square > 0.0:
            end = self.push / (half + omega)
            d = (end - self.w0) / (2.0 * omega)
            grown = math.expm1(-2.0 * omega * t)
            below = kappa * d * grown
            w = (self.w0 - (half + omega) * d * grown) / (1.0 + below)
            return end * t + math.log1p(below) / kappa, w
        sine = math.sin(omega * t) / omega if omega > 0.0 else t
        lost = -2.0 * math.sin(0.5 * omega * t) ** 2  # cos − 1
        own = lost + (kappa * self.w0 + half) * sine
        w = (self.w0 * (1.0 + lost) + (self.push - half * self.w0) * sine) / (1.0 + own)
        return (math.log1p(own) - half * t) / kappa, w

    def _haste(self) -> float:
        return self.gamma + 2.0 * (self.kappa * self.w0 + self.omega)

    def _summed(self, t: float) -> tuple[float, float]:
        """The power series, in powers of t."""
        slower, bent = -self.gamma * t, -self.kappa * t
        terms = [self.w0, slower * self.w0 + bent * self.w0 * self.w0 + self.push * t]
        faint = FAINT * max(self.w0, abs(terms[1]))
        for n in range(1, TERMS - 1):
            square = sum(map(mul, terms, reversed(terms)))
            terms.append((slower * terms[n] + bent * square) / (n + 1))
            if abs(terms[n]) <= faint and abs(terms[n + 1]) <= faint:
                break
        displacement = math.fsum(map(truediv, terms, count(1)))
        return displacement * t, math.fsum(terms)

    def halt(self) -> float:
        """s to w = 0; inf if never."""
        if self.push >= 0.0 or self.w0 == 0.0:
            return math.inf
        half, omega = 0.5 * self.gamma, self.omega
        if self.square > 0.0:
            steep = (
                half + omega
            ) * self.w0 - self.push  # 2 Omega (half + Omega) (w0 − W)/(2 Omega)
            return -math.log1p(-2.0 * omega * self.w0 / steep) / (2.0 * omega)
        ratio = self.w0 / (half * self.w0 - self.push)
        return math.atan(omega * ratio) / omega if omega > 0.0 else ratio


@dataclass(slots=True)
class Driven:
    """The course of a body (`flight.Course`): one way, and back from where it is turned."""

    first: OneWay
    direction: int  # of the first
    turn: float = field(init=False)  # s
    back: OneWay = field(init=False)
    sparse: bool = False
    seen: dict[float, tuple[float, float, float]] = field(default_factory=dict)
    """The last times asked for: a search asks for place, speed and acceleration one by one, and
    for those at the end of the stretch that it looks at."""

    def __post_init__(self) -> None:
        first = self.first
        self.turn = first.halt()
        self.back = OneWay(0.0, -first.push, first.gamma, first.kappa)

    @property
    def law(self) -> tuple[float, float, float]:
        """Of v'."""
        return self.direction * self.first.push, self.first.gamma, self.first.kappa

    def at(self, t: float) -> tuple[float, float, float]:
        """x, v, a."""
        if (known := self.seen.get(t)) is not None:
            return known
        if len(self.seen) >= KEPT:
            self.seen.clear()
        self.seen[t] = found = self._at(t)
        return found

    def _at(self, t: float) -> tuple[float, float, float]:
        if t <= self.turn:
            x, w = self.first.at(t)
            return self.direction * x, self.direction * w, self.direction * _slowed(self.first, w)
        there, _ = self.first.at(self.turn)
        x, w = self.back.at(t - self.turn)
        return (
            self.direction * (there - x),
            -self.direction * w,
            -self.direction * _slowed(self.back, w),
        )

    def halt(self) -> float:
        """s to v = 0; inf if never."""
        return self.turn

    def marks(self, end: float) -> list[float]:
        """Ever longer stretches from the start, and from where it turns."""
        found: list[float] = []
        for begin, one in ((0.0, self.first), (self.turn, self.back)):
            quick = one.gamma + 2.0 * (one.kappa * one.w0 + one.omega)
            if begin >= end or quick == 0.0:
                continue
            found += [begin] if begin else []
            found += [begin + 0.5 * 2.0**n / quick for n in range(MOST_MARKS)]
        return sorted(t for t in found if 0.0 < t < end)


def _slowed(one: OneWay, w: float) -> float:
    return one.push - one.gamma * w - one.kappa * w * w


def driven(v: float, a: float, gamma: float, kappa: float) -> Driven:
    """From v [m/s] under a [m/s²] and drag, kappa > 0."""
    direction = 1 if v > 0.0 or (v == 0.0 and a > 0.0) else -1
    return Driven(OneWay(abs(v), direction * a, gamma, kappa), direction)
