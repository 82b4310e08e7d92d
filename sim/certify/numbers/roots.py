"""The first zero of a function that is not negative where it begins, proved.

Intervals are cut in two until each is decided by one of three facts about the function f and its
slope f′ over the whole interval (their balls):

    f > 0                 no zero in it
    f′ > 0                it rises from what is not negative: no zero but at the beginning
    f′ < 0                it falls: none if f > 0 at the end; exactly one if f < 0 there

The zero is then enclosed by moving the left end up while f > 0 and the right end down while f < 0.
With balls as coefficients the result holds the first zero of every choice. A zero where f′ is zero
too (they graze) is never decided: that raises.
"""

from __future__ import annotations

from collections.abc import Callable

from sim.certify.numbers.arithmetic import arb
from sim.certify.numbers.balls import Ball, NotProvableError, is_zero

Function = Callable[[Ball], Ball]

MOST_CUTS = 4000
"""Intervals looked at for one zero; some dozen are usual for one swing."""

DEEPEST = 60
"""Halvings of one interval. What is not decided then touches nought and turns round."""


def first_root(
    f: Function, slope: Function, end: Ball, what: str, *, curve: Function | None = None
) -> Ball | None:
    """The first zero in (0, end], a ball; None where there is none. f(0) must not be negative.

    `curve` is f″, given only where f′(0) is known not to be negative either: f″ > 0 is then a
    fourth reason for no zero, in the interval at the beginning.
    """
    left = arb(0)
    waiting = [(left, end, 0)]
    for _ in range(MOST_CUTS):
        if not waiting:
            return None
        a, b, depth = waiting.pop()
        over = a.union(b)
        if f(over) > 0:
            continue
        rate = slope(over)
        if rate > 0 or (curve is not None and is_zero(a) and curve(over) > 0):
            continue
        if rate < 0:
            last = f(b)
            if last > 0:
                continue
            if last < 0 or is_zero(last):
                return _enclosed(f, slope, a, b)
            beyond = (b + (b - a) / 4).mid()  # the zero may be at this very end
            if slope(a.union(beyond)) < 0 and f(beyond) < 0:
                return _enclosed(f, slope, a, beyond)
        if depth == DEEPEST:
            break
        middle = ((a + b) / 2).mid()
        waiting += [(middle, b, depth + 1), (a, middle, depth + 1)]
    raise NotProvableError(what)


def _enclosed(f: Function, slope: Function, a: Ball, b: Ball) -> Ball:
    """The one zero in [a, b] of a falling function."""
    a, b = a.mid(), b.mid()
    for _ in range(12):  # Newton's interval step: squares the width once it is small
        middle = ((a + b) / 2).mid()
        rate = slope(a.union(b))
        if not rate < 0:
            break
        better = middle - f(middle) / rate
        low, high = better.lower().mid(), better.upper().mid()
        low, high = max(a, low), min(b, high)
        if not low < high or (high - low) > (b - a) * 0.75:
            break
        a, b = low, high
    return _bisected(f, a, b)


def _bisected(f: Function, a: Ball, b: Ball) -> Ball:
    """What Newton's step left, as far as signs decide."""
    for _ in range(12):
        middle = ((a + b) / 2).mid()
        value = f(middle)
        if value > 0:
            a = middle
        elif value < 0:
            b = middle
        else:
            break
    return a.union(b)


def falls_to_zero(c: Ball, u: Ball, a: Ball, end: Ball, what: str) -> Ball | None:
    """First τ ≥ 0 with c + u τ + a τ²/2 = 0, for c ≥ 0; None where it stays above up to `end`.

    At c = 0 it counts only if it goes on to fall: what parts does not touch.
    """
    if c > 0:
        over = arb(0).union(end)
        if c + over * (u + a * over / 2) > 0:
            return None
    if is_zero(a):
        if is_zero(u):
            return None
        return _at_constant_rate(c, u, what)
    falls = a < 0
    if not falls and not a > 0:  # nearly no acceleration: of which sign does not matter
        return first_root(lambda t: c + t * (u + a * t / 2), lambda t: u + a * t, end, what)
    if is_zero(c) and (u < 0 or (is_zero(u) and falls)):
        return arb(0)
    if not falls and u >= 0:
        return None
    inside = u * u - 2 * a * c
    if not falls:
        if inside < 0:
            return None
        if not (u < 0 and inside > 0):
            raise NotProvableError(what)
    root = inside.sqrt()
    if falls and u > 0:
        return (u + root) / -a
    return 2 * c / (root - u)


def _at_constant_rate(c: Ball, u: Ball, what: str) -> Ball | None:
    if u < 0:
        return arb(0) if is_zero(c) else -c / u
    if u >= 0:
        return None
    raise NotProvableError(what)
