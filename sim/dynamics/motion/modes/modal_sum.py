"""A quantity of a row that moves as a sum of modes: values, bounds, zeros, maxima, integrals.

    q(t) = c + d t + Re sum of a_j e^(lambda_j t) ,     Re lambda_j <= 0

|q''| from t on is at most sum |a_j| |lambda_j|² e^(Re lambda_j t), so that steps that cannot jump
over a zero (`safe_step`) are as long as what still swings allows: a stiff contact that has come to
rest costs nothing beside a soft spring, however long the run.

One that rings on without end would make them as short as its own swings. But as long as all slower
terms together exceed its amplitude, it cannot bring q to nought by itself: any number of the
fastest terms may be taken at their worst, −|a| e^(Re lambda t), and the steps be those of the rest.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass

from sim.dynamics.motion.safe_step import safe_step

Term = tuple[complex, complex]
"""lambda [1/s] and a. Of a pair of conjugate ones one stands for both, a being twice its share."""


@dataclass(frozen=True, slots=True)
class ModalSum:
    """c, d and the terms; `at` in s from where the terms begin."""

    constant: float
    terms: tuple[Term, ...]
    growth: float = 0.0

    def value(self, t: float) -> float:
        """q."""
        swings = [(a * cmath.exp(z * t)).real for z, a in self.terms]
        return math.fsum([self.constant, self.growth * t, *swings])

    def both(self, t: float) -> tuple[float, float]:
        """q and q'."""
        here = [(z, a * cmath.exp(z * t)) for z, a in self.terms]
        value = math.fsum([self.constant, self.growth * t, *(s.real for _, s in here)])
        return value, math.fsum([self.growth, *((z * s).real for z, s in here)])

    def bound(self, t: float, order: int) -> float:
        """Of the absolute value of a derivative from t on; of order 0 without the constant."""
        return math.fsum([abs(a) * abs(z) ** order * math.exp(z.real * t) for z, a in self.terms])

    @property
    def slope(self) -> ModalSum:
        """q'."""
        return ModalSum(self.growth, tuple((z, z * a) for z, a in self.terms))

    @property
    def size(self) -> float:
        """Of all that adds up to q at the start."""
        return abs(self.constant) + sum(abs(a) for _, a in self.terms)

    def integral(self, t: float) -> float:
        """Of q from 0 to t."""
        swings = [(a * _grown(z, t)).real for z, a in self.terms]
        return math.fsum([self.constant * t, 0.5 * self.growth * t * t, *swings])

    def square_integral(self, t: float) -> float:
        """Of q² from 0 to t; without growth."""
        whole: list[Term] = [(0j, complex(self.constant))] if self.constant else []
        for z, a in self.terms:
            whole += [(z, a)] if z.imag == 0.0 else [(z, 0.5 * a), _conjugate(z, 0.5 * a)]
        mixed = [
            (1.0 if i == j else 2.0) * (a * b * _grown(z + w, t)).real
            for i, (z, a) in enumerate(whole)
            for j, (w, b) in enumerate(whole[: i + 1])
        ]
        return math.fsum(mixed)


def _conjugate(z: complex, a: complex) -> Term:
    return z.conjugate(), a.conjugate()


def plus(*parts: tuple[float, ModalSum]) -> ModalSum:
    """A sum with factors."""
    shares: dict[complex, complex] = {}
    for factor, one in parts:
        if factor:
            for z, a in one.terms:
                shares[z] = shares.get(z, 0j) + factor * a
    return ModalSum(
        math.fsum([factor * one.constant for factor, one in parts]),
        tuple(shares.items()),
        math.fsum([factor * one.growth for factor, one in parts]),
    )


def _grown(z: complex, t: float) -> complex:
    """Integral of e^(z t): (e^(z t) − 1)/z, without cancellation."""
    if z == 0.0:
        return complex(t)
    x, y = z.real * t, z.imag * t
    half = math.sin(0.5 * y)
    real = math.expm1(x) * math.cos(y) - 2.0 * half * half
    return complex(real, math.exp(x) * math.sin(y)) / z


def clear_until(q: ModalSum, horizon: float, least: float, most: int) -> float:
    """s. A time up to the horizon before which q, positive now, has no zero.

    It stops where the next safe step is shorter than `least` [s], or after `most` of them.
    """
    t = 0.0
    for _ in range(most):
        if q.growth >= 0.0 and q.constant > q.bound(t, 0):
            return horizon  # what swings cannot reach so far, ever
        here, rate = q.both(t)
        if here <= 0.0:
            return 0.0
        step = safe_step(here, rate, q.bound(t, 2))
        if step < least or step * most < horizon - t:
            step = max(step, _beyond_swings(q, t, 0.0, 1.0))
        if step < least:
            return t
        t += step
        if t >= horizon:
            return horizon
    return t


def _beyond_swings(q: ModalSum, t: float, level: float, sign: float) -> float:
    """s. A time from t on in which level + sign q stays positive, whatever its fastest terms do."""
    longest, swings = 0.0, 0.0
    slower = sorted(q.terms, key=lambda term: abs(term[0]))
    while slower:
        z, a = slower.pop()
        swings += abs(a) * math.exp(z.real * t)
        rest = ModalSum(q.constant, tuple(slower), q.growth)
        here, rate = rest.both(t)
        if (least := level + sign * here - swings) > 0.0:
            longest = max(longest, safe_step(least, sign * rate, rest.bound(t, 2)))
    return longest


AS_GREAT = 1e-13
"""Relative to all that adds up. A later maximum that exceeds the first by no more is the same."""


def maximum(q: ModalSum, t: float, least: float, most: int) -> float:
    """When q is greatest in [0, t]; the first of equal ones.

    `least` [s] is a step so short that nothing happens within it, `most` the looks at q.
    """
    slope = q.slope
    best, when = q.value(0.0), 0.0
    end = q.value(t)
    if end > best:
        best, when = end, t
    same = AS_GREAT * q.size
    if t > most * least and len(q.terms) > 1:
        near = _near_crest(q, t, least, most)
        if (found := q.value(near)) > best + same:
            best, when = found, near
    now = 0.0
    for _ in range(most):
        if now >= t:
            break
        here, rate = q.both(now)
        step = safe_step(max(best - here, 0.0) + same, -rate, q.bound(now, 2))
        if step < least or step * most < t - now:
            step = max(step, _beyond_swings(q, now, best + same, -1.0))
        if step >= least or rate <= 0.0:
            now += max(step, least)
            continue
        top = _top(slope, now, t, least)
        now = top + least
        if (found := q.value(top)) > best + same:
            best, when = found, top
    return when


SAMPLES = 16
"""Of a swing, to find its greatest value."""


def _near_crest(q: ModalSum, t: float, least: float, most: int) -> float:
    """Where the fastest swing is highest beside the greatest value of all the slower ones.

    Few other places can be higher: `maximum` passes over the rest of a long time at once.
    """
    *slower, (z, _) = sorted(q.terms, key=lambda term: abs(term[0]))
    crest = maximum(ModalSum(q.constant, tuple(slower), q.growth), t, least, most)
    part = 2.0 * math.pi / (SAMPLES * abs(z))
    around = [crest + k * part for k in range(-SAMPLES, SAMPLES + 1)]
    places = [one for one in around if 0.0 <= one <= t]
    best = max(places, key=q.value)
    begin = max(best - part, 0.0)
    slope = q.slope
    return _top(slope, begin, min(best + part, t), least) if slope.value(begin) > 0.0 else best


FOUND = 1e-9
"""Of the step within which nothing happens. A maximum that is known so well is found."""


def _top(slope: ModalSum, begin: float, end: float, least: float) -> float:
    """s. The next zero of q', which is positive at `begin`: safe steps, near it Newton's.

    A step that no longer moves t has found it: `least` may be below the rounding of a late t.
    """
    t = begin
    while t < end:
        here, rate = slope.both(t)
        if here <= 0.0:
            break
        step = safe_step(here, rate, slope.bound(t, 2))
        if step < FOUND * least or t + step == t:
            break
        t += step
    return min(t, end)
