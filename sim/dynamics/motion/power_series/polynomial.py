"""Polynomials in time: values, bounds, integrals, and first zeros that cannot be jumped over."""

from __future__ import annotations

import math
from itertools import count
from operator import truediv

from sim.dynamics.motion.safe_step import SAFE_STEPS, safe_step
from sim.effects.forces import Poly

__all__ = ["Poly"]


def value(p: Poly, t: float) -> float:
    """p(t) by Horner's rule."""
    if t == 0.0:
        return p[0] if p else 0.0
    total = 0.0
    for c in reversed(p):
        total = total * t + c
    return total


def value_and_slope(p: Poly, t: float) -> tuple[float, float]:
    """p(t) and p'(t), by Horner's rule for both."""
    total = growth = 0.0
    for c in reversed(p):
        growth = growth * t + total
        total = total * t + c
    return total, growth


def size(p: Poly, h: float) -> float:
    """Bound on |p| over [0, h]."""
    total, power = 0.0, 1.0
    for c in p:
        if c:
            total += abs(c) * power
        power *= h
    return total


def slope(p: Poly) -> Poly:
    """dp/dt."""
    return [n * c for n, c in enumerate(p)][1:] or [0.0]


def integral(p: Poly) -> Poly:
    """The primitive that is 0 at t = 0."""
    return [0.0, *map(truediv, p, count(1))]


def integral_value(p: Poly, t: float) -> float:
    """value(integral(p), t), without the list."""
    if t == 0.0:
        return 0.0
    total, n = 0.0, len(p)
    for c in reversed(p):
        total = total * t + c / n
        n -= 1
    return total * t


def _scaled(p: Poly, h: float) -> Poly:
    """Coefficients in t/h: of moderate size where p(t) is, however short the step."""
    found, power = [], 1.0
    for c in p:
        found.append(c * power)
        power *= h
    return found


def square_integral(p: Poly, h: float) -> float:
    """Integral of p² over [0, h]: sum of q_i q_j/(i + j + 1), each pair once."""
    q = _without_faint_terms(_scaled(p, h))
    squares = [a * a / (2 * i + 1) for i, a in enumerate(q)]
    mixed = [a * b / (i + j) for i, a in enumerate(q) if a for j, b in enumerate(q[i + 1 :], i + 2)]
    return h * (math.fsum(squares) + 2.0 * math.fsum(mixed))


FAINT = 1e-20
"""Of the greatest coefficient. Later ones that are smaller than that add nothing."""


def _without_faint_terms(q: Poly) -> Poly:
    """Without last coefficients that add nothing at 1."""
    faint = FAINT * max(map(abs, q), default=0.0)
    while len(q) > 1 and abs(q[-1]) <= faint:
        q.pop()
    return q


SMALL = 1e-3
"""Relative to the step: a safe step that is shorter than that gets a second look while p rises."""

CLOSE = 2e-16
"""Relative to the step: a zero nearer than this is here."""


AHEAD = 0.25
"""Of the step: a search that has come so far goes on. At a zero that is six-fold it is slow."""

CLEARLY = 1.0 + 1e-12
"""A bound that is exceeded by that is exceeded, in whatever order it was summed."""


def first_fall(p: Poly, h: float) -> float | None:
    """First t in [0, h] at which p, positive just after 0, falls to zero; None if it does not.

    0 where p is negative just after 0. A zero of p at 0 itself is divided out, however many-fold.
    Found by steps that cannot jump over a zero: |p''| is bounded by its coefficients.
    """
    q = p
    if not p or p[0] == 0.0:
        low = next((n for n, c in enumerate(p) if c != 0.0), None)
        if low is None:
            return None
        q = p[low:]
    if q[0] < 0.0:
        return 0.0
    if h <= 0.0:
        return None
    far = 0.0
    for c in q[:0:-1]:
        far = (far + abs(c)) * h
    if q[0] > CLEARLY * far:
        return None
    bound, power, reach = 0.0, 1.0, 0.0
    for n in range(1, len(q)):
        if q[n]:
            reach += abs(q[n]) * power * h
            if n >= 2:
                bound += n * (n - 1) * abs(q[n]) * power / h
        power *= h
    if q[0] > reach:
        return None
    rate = slope(q)
    t = 0.0
    for _ in range(SAFE_STEPS):
        here, falling = value(q, t), value(rate, t)
        if here <= 0.0:
            return t
        step = safe_step(here, falling, bound)
        if step <= SMALL * h and falling > 0.0 and t < h:  # it rises, and the bound does not see it
            step = max(step, clear_of_zero(shifted(q, t), h - t))
        if step <= CLOSE * h:
            return t
        t += step
        if t > h:
            return None
    if t < AHEAD * h:
        return t
    if not t <= h:
        raise OverflowError("a coefficient is no number")
    rest = first_fall(shifted(q, t), h - t)  # bounds on what is left are closer
    return None if rest is None else t + rest


HALVINGS = 80
"""Of a step, down to 1e-24 of it."""


def shifted(p: Poly, t: float) -> Poly:
    """The coefficients about t: p(t + x) as a polynomial in x."""
    q = list(p)
    if t:
        for first in range(len(q) - 1):
            for n in range(len(q) - 2, first - 1, -1):
                q[n] += t * q[n + 1]
    return q


def clear_of_zero(p: Poly, h: float) -> float:
    """A time up to h before which p, whose first terms are positive, has no zero; 0: none is known.

    For the bound on p'' over all of h does not see how small p and its slope may be at first: the
    push that runs through a chain arrives as t^(2n). With m the first negative term, p is positive
    up to x where some p_j >= sum of |p_n| x^(n − j) over the negative ones, j < m.
    """
    first = next((n for n, c in enumerate(p) if c < 0.0), None)
    if first is None:
        return h
    negative = [(n, -c) for n, c in enumerate(p) if c < 0.0]
    x = h
    for _ in range(HALVINGS):
        for j in range(first):
            if p[j] > 0.0 and p[j] >= math.fsum([c * x ** (n - j) for n, c in negative]):
                return x
        x *= 0.5
    return 0.0
