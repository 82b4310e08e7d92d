"""One contact of two spheres that are alone: its whole course in closed form, up to one integral.

    mu d'' + C d^(1/4) d' + K d^(3/2) = 0

is linear in y = d^(5/4) and in the time s that runs as ds = d^(1/4) dt: with ' for d/dt still,

    dy/ds = (5/4) d'        y_ss + 2 beta y_s + W² y = 0        W² = 5 K/(4 mu)

So overlap, rate, force, impulse and losses are elementary functions of the phase x of a damped
swing, y = R e^(−c x) sin x with c = beta/w, and x runs from 0 at touch to pi at the end. Time is

    t = w^-1 R^(−1/5) G(x),   G(x) = integral from 0 to x of e^(c x/5) sin^(−1/5) x dx

an incomplete Beta function where c = 0. The integrand is x^(−1/5) times a series with radius pi;
it is summed from the nearer of the two ends, up to pi/2: 56 terms leave 1e-17. G is inverted by
Newton's method in x^(4/5), in which it is smooth. With e = 0 the swing is critical,
y = b s e^(−W s), and t = b^(−1/5) times an incomplete gamma function: such a contact never ends.
Errors: a few units in the last place. Source of the mapping: Antypov & Elliott, EPL 94 (2011)
50004; the integral is ours.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

from sim.laws.rounding import LAST_BIT

TERMS = 60
"""Of a series in x/pi up to x = pi/2: the next one is 1e-18 of the sum."""

MOST_DAMPED = 10.0
"""c. Beyond (e < 2e-14) the series from the end loses digits; such a contact is integrated."""

NEWTON = 20
"""Steps at most; three to five are usual."""


@lru_cache(maxsize=256)
def _series(c: float) -> tuple[float, ...]:
    """a_n/(n + 4/5) of e^(c x/5) (sin x/x)^(−1/5) = sum of a_n x^n."""
    sine, factorial = [1.0], 1.0
    for k in range(1, TERMS // 2):
        factorial *= -2.0 * k * (2.0 * k + 1.0)
        sine.append(1.0 / factorial)
    power = [1.0]  # of x²: sinc^a by n p_n = sum of (k a − (n − k)) s_k p_(n − k)
    for n in range(1, TERMS // 2):
        total = math.fsum([(-0.2 * k - (n - k)) * sine[k] * power[n - k] for k in range(1, n + 1)])
        power.append(total / n)
    grows = [1.0]
    for n in range(1, TERMS):
        grows.append(grows[-1] * 0.2 * c / n)
    return tuple(
        math.fsum([power[j] * grows[n - 2 * j] for j in range(n // 2 + 1)]) / (n + 0.8)
        for n in range(TERMS)
    )


def _sum(series: tuple[float, ...], x: float) -> float:
    """The series over x^(4/5)."""
    total = 0.0
    for a in reversed(series):
        total = total * x + a
    return total


def _power(x: float) -> float:
    return float(x**0.8)


def _inverse(series: tuple[float, ...], c: float, wanted: float) -> float:
    """x up to about pi/2 with x^(4/5) times the series = `wanted`; c is signed."""
    q = wanted / series[0]
    for _ in range(NEWTON):
        x = min(q**1.25, 0.5 * math.pi * MARGIN)
        q = x**0.8
        growth = 1.25 * (x / math.sin(x)) ** 0.2 * math.exp(0.2 * c * x) if x else series[0]
        step = (q * _sum(series, x) - wanted) / growth
        q = max(q - step, 0.0)
        if abs(step) <= LAST_BIT * q:
            break
    return float(q**1.25)


MARGIN = 1.05
"""How far beyond the middle Newton's method may look."""


@dataclass(frozen=True, slots=True)
class Swinging:
    """0 < e <= 1. From phase `begin` at t = 0; y = `high` e^(−c (x − begin)) sin x, dx = w ds."""

    w: float
    c: float
    begin: float
    high: float
    scale: float  # s, of G
    began: float  # G at the beginning
    middle: float  # G(pi/2)
    late: float  # the integral from the end to the middle, without its factor

    @property
    def duration(self) -> float:
        """s."""
        return self.scale * (self.middle - self.began + self._factor * self.late)

    @property
    def _factor(self) -> float:
        return math.exp(0.2 * math.pi * self.c)

    def phase(self, t: float) -> tuple[float, float]:
        """x and pi − x at t, each with all its figures where it is small."""
        if t <= 0.0:
            return self.begin, math.pi - self.begin
        g = self.began + t / self.scale
        if g <= self.middle:
            x = _inverse(_series(self.c), self.c, g)
            return x, math.pi - x
        left = max((self.middle - g) / self._factor + self.late, 0.0)
        z = _inverse(_series(-self.c), -self.c, left)
        return math.pi - z, z

    def time(self, x: float) -> float:
        """s at which the phase is x."""
        if x <= 0.5 * math.pi:
            return self.scale * (_power(x) * _sum(_series(self.c), x) - self.began)
        z = math.pi - x
        back = _power(z) * _sum(_series(-self.c), z)
        return self.scale * (self.middle - self.began + self._factor * (self.late - back))

    def at(self, phase: tuple[float, float]) -> tuple[float, float]:
        """y and dy/ds."""
        x, z = phase
        fades = self.high * math.exp(-self.c * (x - self.begin))
        sine = math.sin(x) if x < z else math.sin(z)
        return fades * sine, self.w * fades * (math.cos(x) - self.c * sine)

    def turn(self, ratio: float) -> float:
        """The phase at which dy/ds = ratio W y."""
        return math.atan2(1.0, ratio * math.sqrt(1.0 + self.c * self.c) + self.c)


def swinging(y: float, rate: float, w: float, c: float) -> Swinging | None:
    """The course from y and dy/ds; None where it is too strongly damped."""
    if c > MOST_DAMPED:
        return None
    up = rate / w + c * y
    begin = math.atan2(y, up)
    high = math.hypot(y, up)
    front, back = _series(c), _series(-c)
    half = 0.5 * math.pi
    middle, late = half**0.8 * _sum(front, half), half**0.8 * _sum(back, half)
    if begin <= half:
        began = begin**0.8 * _sum(front, begin)
    else:
        z = math.atan2(y, -up)
        began = middle + math.exp(0.2 * math.pi * c) * (late - z**0.8 * _sum(back, z))
    scale = (high * math.exp(c * begin)) ** -0.2 / w
    return Swinging(w, c, begin, high, scale, began, middle, late)


@dataclass(frozen=True, slots=True)
class Creeping:
    """e = 0: y = b s e^(−W s), W s = 5 x; x grows without an end."""

    w: float
    begin: float  # x at t = 0
    slope: float  # b
    began: float
    scale: float  # s
    duration: float = math.inf

    def phase(self, t: float) -> tuple[float, float]:
        """x, and how long there is still to go in it."""
        if t <= 0.0:
            return self.begin, math.inf
        wanted = self.began + t / self.scale
        guess = (0.8 * wanted) ** 1.25
        x = (
            guess
            if guess < 1.0
            else max(1.0, math.log(wanted) + 0.2 * math.log1p(math.log(wanted)))
        )
        for _ in range(NEWTON):
            here = _gamma(x)
            step = math.log(here / wanted) * here / (x**0.8 * math.exp(x))  # in ln x
            x *= math.exp(-step)
            if abs(step) <= LAST_BIT:
                break
        return x, math.inf

    def time(self, x: float) -> float:
        """s at which it gets to x."""
        return self.scale * (_gamma(x) - self.began)

    def at(self, phase: tuple[float, float]) -> tuple[float, float]:
        """y and dy/ds."""
        s = 5.0 * phase[0]  # W s
        fades = self.slope * math.exp(-s)
        return fades * s / self.w, fades * (1.0 - s)

    def turn(self, ratio: float) -> float:
        """The phase at which dy/ds = ratio W y: 1/(W s) − 1 = ratio."""
        return 0.2 / (1.0 + ratio) if ratio > -1.0 else math.inf


def _gamma(x: float) -> float:
    """Integral of x^(−1/5) e^x from 0 to x, all of whose terms are positive."""
    total, term, n = 0.0, 1.0, 0
    while n < 3.0 * x or term > 1e-18 * total:
        total += term / (n + 0.8)
        n += 1
        term *= x / n
    return float(x**0.8 * total)


def creeping(y: float, rate: float, w: float) -> Creeping | None:
    """The critical course; None where it is not one that began at a touch."""
    slope = rate + w * y  # y = (y0 + b s) e^(−W s)
    if slope <= 0.0:
        return None
    begin = 0.2 * w * y / slope
    if begin > LATE:
        return None
    b = slope * math.exp(5.0 * begin)
    return Creeping(w, begin, b, _gamma(begin) if begin else 0.0, (5.0 / w) ** 0.8 * b**-0.2)


LATE = 60.0
"""x. A contact with e = 0 that has crept for 1e26 times its first second is at its end."""
