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
from dataclasses import dataclass
from operator import mul

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

Mode = tuple[complex, complex, complex]
"""h_1 t, h_2 t², h_3 t³ of one mode: what 1 grows to by one, two and three integrations."""

Grown = tuple[tuple[complex, ...], ...]
"""Three times as many as there are modes: h_1 t of all of them, then h_2 t², then h_3 t³."""

NO_MODES: Grown = ((), (), ())


def grown(rates: tuple[complex, ...], t: float) -> Grown:
    """For all modes at t s."""
    found = [undamped(z.imag, t) if z.real == 0.0 else damped(z, t) for z in rates]
    return tuple(zip(*found, strict=True)) or NO_MODES


def damped(z: complex, t: float) -> Mode:
    """Of one mode."""
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


def undamped(w: float, t: float) -> Mode:
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


def swung(b: complex, w: float, t: float) -> tuple[float, float]:
    """The real parts of b h_2 t² and b h_1 t of z = i w: what a search asks for, and no more."""
    y = w * t
    if y > FAR:
        low, real = math.cos(y) - 1.0, math.sin(y) / w
        imag = -low / w
        return b.real * (imag / w) - b.imag * ((t - real) / w), b.real * real - b.imag * imag
    square, even, odd = y * y, 0.0, 0.0
    terms = zip(EVEN, ODD) if y > NEAR else zip(EVEN_NEAR, ODD_NEAR)  # noqa: B905
    for c, d in terms:
        even = even * square + c
        odd = odd * square + d
    real, imag = 0.5 - square * odd, y * even
    return (
        b.real * (real * (t * t)) - b.imag * (imag * (t * t)),
        b.real * ((1.0 - y * imag) * t) - b.imag * (y * real * t),
    )


@dataclass(frozen=True, slots=True)
class Shape:
    """What a quantity has of each mode, for a mode of amplitude 1: the b_j of its q''.

    Kept for all phases between the same springs, and with them what the search for a zero asks for:
    those of what swings in q' and in q, b/z and b/z², and sizes.
    """

    of: tuple[complex, ...]
    in_rate: tuple[complex, ...]
    in_value: tuple[complex, ...]
    size: tuple[float, ...]
    size_in_value: tuple[float, ...]
    size_of_third: tuple[float, ...]  # |b z|


def shape_of(shares: tuple[complex, ...], rates: tuple[complex, ...]) -> Shape:
    """From the b_j."""
    once = tuple([b / z for b, z in zip(shares, rates, strict=True)])
    twice = tuple([b / z for b, z in zip(once, rates, strict=True)])
    third = tuple([abs(b * z) for b, z in zip(shares, rates, strict=True)])
    return Shape(shares, once, twice, tuple(map(abs, shares)), tuple(map(abs, twice)), third)


@dataclass(slots=True)
class Swinging:
    """How much of each mode there is, and its size; the rates are those of the modes."""

    rates: tuple[complex, ...]
    amplitudes: tuple[complex, ...]
    sizes: tuple[float, ...]

    def at(self, t: float) -> Grown:
        """What the modes have grown to at t s."""
        amplitudes = self.amplitudes
        return tuple([tuple(map(mul, amplitudes, one)) for one in grown(self.rates, t)])


def swinging(rates: tuple[complex, ...], amplitudes: tuple[complex, ...]) -> Swinging:
    """Modes with these amplitudes."""
    return Swinging(rates, amplitudes, tuple(map(abs, amplitudes)))


@dataclass(slots=True)
class Started:
    """q0, q1, q''(0), and what q'' has of each mode; `at` is what these have grown to.

    No named tuple: to look into one takes several times as long, and a phase does so hundreds of
    times.
    """

    first: float
    slope: float
    bend: float
    shape: Shape

    def value(self, t: float, at: Grown) -> float:
        """q."""
        return sum(map(mul, self.shape.of, at[1]), self.first + self.slope * t).real

    def rate(self, at: Grown) -> float:
        """q'."""
        return sum(map(mul, self.shape.of, at[0]), self.slope).real

    def integral(self, t: float, at: Grown) -> float:
        """Of q from 0 to t."""
        begun = (self.first + 0.5 * self.slope * t) * t
        return sum(map(mul, self.shape.of, at[2]), begun).real

    def size(self, swings: Swinging, t: float) -> float:
        """Bound on |q| up to t: by its beginning, or by what swings."""
        shape, sizes, amplitudes = self.shape, swings.sizes, swings.amplitudes
        bent: float = sum(map(mul, sizes, shape.size))
        near = abs(self.first) + (abs(self.slope) + 0.5 * bent * t) * t
        far: float = abs(self.first - sum(map(mul, amplitudes, shape.in_value)).real)
        level: float = abs(self.slope - sum(map(mul, amplitudes, shape.in_rate)).real)
        swing: float = sum(map(mul, sizes, shape.size_in_value))
        return min(near, far + level * t + swing)
