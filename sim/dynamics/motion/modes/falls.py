"""When does a quantity of a row that swings (`started`) fall to a level?

Most never do: a bound on its second derivative, or on what swings in it, says so at once. Else the
search goes by steps that cannot jump over a zero, on slow modes as a polynomial of few terms.
"""

from __future__ import annotations

import cmath
import math
from operator import mul

from sim.dynamics.motion.modes.started import FAR, Shape, Started, Swinging, damped, swung
from sim.dynamics.motion.safe_step import SAFE_STEPS, SLACK, safe_step

SLOW = 0.1
"""|z| h of modes that the search for a zero takes as a polynomial."""

SLOW_TERMS = tuple(1.0 / math.factorial(n) for n in range(2, 12))
ENOUGH = ((1e-4, 4), (1e-3, 5), (1e-2, 7), (SLOW, len(SLOW_TERMS)))
"""So many terms up to that |z| h: what is left out is |z h|^n 2/(n + 2)! of the first, 4e-19."""


def slow(
    q: Started, swings: Swinging, h: float, sign: float, level: float
) -> tuple[list[float], list[tuple[complex, complex]]]:
    """sign (q − level) as a polynomial of its slow modes up to h s, the last coefficient first.

    And b and z of the others.
    """
    poly, fast = [sign * (q.first - level), sign * q.slope], []
    powers: list[complex] = []
    slow: list[complex] = []
    fastest = 0.0
    for one, b, z in zip(swings.amplitudes, q.shape.of, swings.rates, strict=True):
        if not b:
            continue
        pace, share = abs(z) * h, sign * (one * b)
        if pace > SLOW:
            fast.append((share, z))
        else:
            powers.append(share)
            slow.append(z)
            fastest = max(fastest, pace)
    if slow:
        terms = next(n for most, n in ENOUGH if fastest <= most)
        for c in SLOW_TERMS[:terms]:
            poly.append(c * sum(powers).real)
            powers = list(map(mul, powers, slow))
    poly.reverse()
    return poly, fast


def look(poly: list[float], fast: list[tuple[complex, complex]], t: float) -> tuple[float, float]:
    """q and q' at t: what the search for a zero asks for, again and again."""
    value = rate = 0.0
    for c in poly:
        rate = rate * t + value
        value = value * t + c
    for b, z in fast:
        if z.real == 0.0:
            once, growth = swung(b, z.imag, t)
            value += once
            rate += growth
            continue
        x = z * t
        if abs(x) > FAR:
            one = (cmath.exp(x) - 1.0) / z
            two = (one - t) / z
        else:
            one, two, _ = damped(z, t)
        value += (b * two).real
        rate += (b * one).real
    return value, rate


class UndecidedError(ArithmeticError):
    """Three coefficients of a quantity are nought, or it comes too near to nought for too long."""


CLOSE = 2e-16
"""Relative to the span: a zero nearer than this is here."""


def first_fall(
    q: Started, swings: Swinging, h: float, sign: float = 1.0, level: float = 0.0
) -> float | None:
    """First t in [0, h] at which sign (q − level), positive just after 0, falls to zero; else None.

    0 where it is negative just after 0; a zero at 0 itself does not count. Steps cannot jump over a
    zero: |q''| <= sum of |b| e^(Re z t) from t on.
    """
    here, rate, shape = sign * (q.first - level), sign * q.slope, q.shape
    if here < 0.0 or (here == 0.0 and rate < 0.0):
        return 0.0
    bound = sum(map(mul, swings.sizes, shape.size))
    if here == 0.0 and rate == 0.0:
        if q.bend == 0.0:
            raise UndecidedError
        if sign * q.bend < 0.0:
            return 0.0
        quicker = sum(map(mul, swings.sizes, shape.size_of_third))
        t = 3.0 * abs(q.bend) / quicker if quicker > 0.0 else math.inf
    else:
        t = safe_step(here, rate, bound)
    if t > h or _stays_clear(here, rate, shape, swings, sign, h):
        return None
    if rate >= 0.0 and _only_rises(sign * q.bend, shape, swings, h):
        return None
    return searched(q, swings, h, sign, level, t, bound)


def searched(
    q: Started, swings: Swinging, h: float, sign: float, level: float, t: float, bound: float
) -> float | None:
    """The same from t on, before which there is no zero."""
    poly, fast = slow(q, swings, h, sign, level)
    fading = [
        (size * own, z.real)
        for size, own, z in zip(swings.sizes, q.shape.size, swings.rates, strict=True)
        if z.real
    ]
    lasts = bound - sum([size for size, _ in fading])
    for _ in range(SAFE_STEPS):
        if t > h:
            return None
        here, rate = look(poly, fast, t)
        if here <= 0.0:
            return t
        if fading:
            bound = lasts + sum([size * math.exp(decay * t) for size, decay in fading])
        step = safe_step(here, rate, bound)
        if step <= CLOSE * h:
            return t
        t += step
    raise UndecidedError


def _only_rises(bend: float, shape: Shape, swings: Swinging, h: float) -> bool:
    """Does what begins to rise come back no sooner than h s, as a bumper that springs back does?

    From q >= 0 and q' >= 0 on q is at least (q''(0) − |third derivative| t/3) t²/2.
    """
    thirds = sum(map(mul, swings.sizes, shape.size_of_third)) if bend > 0.0 else math.inf
    return 3.0 * bend > SLACK * h * thirds


def _stays_clear(
    here: float, rate: float, shape: Shape, swings: Swinging, sign: float, h: float
) -> bool:
    """Is the quantity so great that what swings never brings it to nought up to h s?"""
    amplitudes = swings.amplitudes
    here -= sign * sum(map(mul, amplitudes, shape.in_value)).real
    here -= sum(map(mul, swings.sizes, shape.size_in_value))
    if here <= 0.0:
        return False
    rate -= sign * sum(map(mul, amplitudes, shape.in_rate)).real
    return here > abs(rate) * h
