"""A quantity of a row that swings, told from its beginning: exact at first, and far on.

    q(t) = q0 + q1 t + Re sum of b_j (e^(z_j t) − 1 − z_j t)/z_j² ,     Re z_j <= 0

q0 and q1 are those of the power series; only what follows is a sum of modes, b_j being the shares
of q''. So the first figures of q after an event are those of the state, however short the time, and
no place of rest, which may be far away, is subtracted. With x = z t,

    h_n(x) = x^-n (e^x − 1 − x − … − x^(n−1)/(n−1)!) = 1/n! + x h_(n+1)(x)

are computed without cancellation: upwards where |x| is great, downwards from the series of h_3 else
(the phi functions of exponential integrators: Hochbruck & Ostermann, Acta Numerica 19 (2010) 209).
"""

from __future__ import annotations

import cmath
import math
from typing import NamedTuple

from sim.dynamics.motion.safe_step import SAFE_STEPS, safe_step

FAR = 1.0
"""|x| from which on h_3 by division loses no more than two bits."""

NEAR = 0.06
"""|x| up to which half of the terms are enough."""

THIRD = tuple(1.0 / math.factorial(n + 3) for n in range(17, -1, -1))
THIRD_NEAR = THIRD[9:]
"""Of the series of h_3, the last first: 3!/21! and 0.06^9 3!/12! are 1e-19."""

EVEN, ODD = (tuple((-1) ** n / math.factorial(2 * n + k) for n in range(8, -1, -1)) for k in (3, 4))
EVEN_NEAR, ODD_NEAR = EVEN[5:], ODD[5:]
"""The same of h_3(i y), its real part and the imaginary one over y, in powers of y²."""

Grown = list[tuple[complex, complex, complex]]
"""Of each mode h_1 t, h_2 t², h_3 t³: what 1 grows to by one, two and three integrations."""


def grown(rates: tuple[complex, ...], t: float) -> Grown:
    """For all modes at t s."""
    return [_undamped(z.imag, t) if z.real == 0.0 else _damped(z, t) for z in rates]


def _damped(z: complex, t: float) -> tuple[complex, complex, complex]:
    x = z * t
    size = abs(x)
    if size > FAR:
        one = (cmath.exp(x) - 1.0) / z
        two = (one - t) / z
        return one, two, (two - 0.5 * t * t) / z
    h = 0j
    for c in THIRD if size > NEAR else THIRD_NEAR:
        h = h * x + c
    two = 0.5 + x * h
    return (1.0 + x * two) * t, two * t * t, h * t * t * t


def _undamped(w: float, t: float) -> tuple[complex, complex, complex]:
    """The same of z = i w, with real numbers alone."""
    y = w * t
    if y > FAR:
        half = math.sin(0.5 * y)
        real, imag = math.sin(y) / w, 2.0 * half * half / w
        left = (t - real) / w
        return (
            complex(real, imag),
            complex(imag / w, left),
            complex(left / w, (0.5 * t * t - imag / w) / w),
        )
    square, a, b = y * y, 0.0, 0.0
    if y > NEAR:
        even, odd = EVEN, ODD
    else:
        even, odd = EVEN_NEAR, ODD_NEAR
    for c, d in zip(even, odd, strict=True):
        a = a * square + c
        b = b * square + d
    # h_3 = a + i y b, h_2 = 1/2 + i y h_3, h_1 = 1 + i y h_2
    real, imag = 0.5 - square * b, y * a
    all_of = t * t
    return (
        complex((1.0 - y * imag) * t, y * real * t),
        complex(real * all_of, imag * all_of),
        complex(a * all_of * t, y * b * all_of * t),
    )


class Started(NamedTuple):
    """q0, q1, q''(0) and the b_j; `at` needs `grown` of the same modes."""

    first: float
    slope: float
    bend: float
    shares: tuple[complex, ...]

    def value(self, t: float, at: Grown) -> float:
        """q."""
        total = self.first + self.slope * t
        for b, (_, two, _) in zip(self.shares, at, strict=True):
            total += b.real * two.real - b.imag * two.imag
        return total

    def rate(self, at: Grown) -> float:
        """q'."""
        total = self.slope
        for b, (one, _, _) in zip(self.shares, at, strict=True):
            total += b.real * one.real - b.imag * one.imag
        return total

    def integral(self, t: float, at: Grown) -> float:
        """Of q from 0 to t."""
        total = (self.first + 0.5 * self.slope * t) * t
        for b, (_, _, three) in zip(self.shares, at, strict=True):
            total += b.real * three.real - b.imag * three.imag
        return total

    def size(self, rates: tuple[complex, ...], t: float) -> float:
        """Bound on |q| up to t: by its beginning, or by what swings."""
        bent, far, swing = 0.0, complex(self.first), 0.0
        level = complex(self.slope)
        for b, z in zip(self.shares, rates, strict=True):
            bent += abs(b)
            level -= b / z
            part = b / (z * z)
            far -= part
            swing += abs(part)
        near = abs(self.first) + (abs(self.slope) + 0.5 * bent * t) * t
        return min(near, abs(far.real) + abs(level.real) * t + swing)


SLOW = 0.1
"""|z| h of modes that the search for a zero takes as a polynomial."""

SLOW_TERMS = tuple(1.0 / math.factorial(n) for n in range(2, 12))
"""0.1^10 2!/12! is 4e-19."""


def _slow(
    q: Started, rates: tuple[complex, ...], h: float, sign: float, level: float
) -> tuple[list[float], list[tuple[complex, complex]]]:
    """sign (q − level) as a polynomial of its slow modes up to h s, and b and z of the others."""
    poly, fast = [sign * (q.first - level), sign * q.slope], []
    powers: list[complex] = []
    slow: list[complex] = []
    for b, z in zip(q.shares, rates, strict=True):
        if not b:
            continue
        if abs(z) * h > SLOW:
            fast.append((sign * b, z))
        else:
            powers.append(sign * b)
            slow.append(z)
    if slow:
        for c in SLOW_TERMS:
            poly.append(c * sum([one.real for one in powers]))
            powers = [one * z for one, z in zip(powers, slow, strict=True)]
    return poly, fast


def _look(poly: list[float], fast: list[tuple[complex, complex]], t: float) -> tuple[float, float]:
    """q and q' at t: what the search for a zero asks for, again and again."""
    value = rate = 0.0
    for c in reversed(poly):
        rate = rate * t + value
        value = value * t + c
    for b, z in fast:
        x = z * t
        if abs(x) > FAR:
            one = (cmath.exp(x) - 1.0) / z
            two = (one - t) / z
        else:
            one, two, _ = _undamped(z.imag, t) if z.real == 0.0 else _damped(z, t)
        value += b.real * two.real - b.imag * two.imag
        rate += b.real * one.real - b.imag * one.imag
    return value, rate


class UndecidedError(ArithmeticError):
    """Three coefficients of a quantity are nought, or it comes too near to nought for too long."""


CLOSE = 2e-16
"""Relative to the span: a zero nearer than this is here."""


def first_fall(
    q: Started, rates: tuple[complex, ...], h: float, sign: float = 1.0, level: float = 0.0
) -> float | None:
    """First t in [0, h] at which sign (q − level), positive just after 0, falls to zero; else None.

    0 where it is negative just after 0; a zero at 0 itself does not count. Steps cannot jump over a
    zero: |q''| <= sum of |b| e^(Re z t) from t on.
    """
    here, rate = sign * (q.first - level), sign * q.slope
    if here < 0.0 or (here == 0.0 and rate < 0.0):
        return 0.0
    bound = sum(map(abs, q.shares))
    if here == 0.0 and rate == 0.0:
        if q.bend == 0.0:
            raise UndecidedError
        if sign * q.bend < 0.0:
            return 0.0
        quicker = sum(abs(b * z) for b, z in zip(q.shares, rates, strict=True))
        t = 3.0 * abs(q.bend) / quicker if quicker > 0.0 else math.inf
    else:
        t = safe_step(here, rate, bound)
    if t > h or _stays_clear(here, rate, q.shares, rates, sign, h):
        return None
    poly, fast = _slow(q, rates, h, sign, level)
    fading = [(abs(b), z.real) for b, z in zip(q.shares, rates, strict=True) if z.real]
    lasts = bound - sum([size for size, _ in fading])
    for _ in range(SAFE_STEPS):
        if t > h:
            return None
        here, rate = _look(poly, fast, t)
        if here <= 0.0:
            return t
        if fading:
            bound = lasts + sum([size * math.exp(decay * t) for size, decay in fading])
        step = safe_step(here, rate, bound)
        if step <= CLOSE * h:
            return t
        t += step
    raise UndecidedError


def _stays_clear(
    here: float,
    rate: float,
    shares: tuple[complex, ...],
    rates: tuple[complex, ...],
    sign: float,
    h: float,
) -> bool:
    """Is the quantity so great that what swings never brings it to nought up to h s?"""
    for b, z in zip(shares, rates, strict=True):
        if b:
            part = b / z
            rate -= sign * part.real
            part /= z
            here -= sign * part.real + abs(part)
    return here > abs(rate) * h
