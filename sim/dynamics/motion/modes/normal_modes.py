"""Modes of a row of bodies between linear springs and dampers, damped ones too.

    m_i u_i'' + b_i u_i' = N_i − N_(i+1) ,   N_i = kappa_i e_i + gamma_i e_i' ,  e_i = u_(i−1) − u_i

has solutions u = phi e^(lambda t), of which the motion about the place of rest is a sum. For a
given lambda the row is passed through from one end (u, then the force behind it, then the next u):
what is left over at the other end is a polynomial p(lambda), and its zeros are the rates, each with
the shape found on the way. Zeros come all at once by Aberth's method, from the rates of the single
springs; then each is refined by Rayleigh's quotient, whose error is the square of that of its
shape. Shapes are put together from both ends where they meet best (twisted), so that a mode that
lives at one end keeps its figures there. No matrix is formed, and no eigen-solver needed.

The pencil is symmetric, so that shapes are their own left vectors: with the norm
phi (2 lambda M + C) phi the share of a mode in a state is a product with its shape. Where two rates
meet (critical damping) the norm is 0 and shares grow without limit: no modes then, but a series.

Sources: Aberth, Math. Comp. 27 (1973) 339; Tisseur & Meerbergen, The quadratic eigenvalue problem,
SIAM Review 43 (2001) 235; Dhillon & Parlett, Lin. Alg. Appl. 387 (2004) 1, on twisted shapes.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from functools import lru_cache

MOST_ROUNDS = 100
"""Of Aberth's method. Ten do, unless zeros lie close together."""

ROOT_ROUNDING = 1e-13
"""Relative. Zeros that still move by more after the last round are not found."""

REAL = 1e-11
"""Relative. A zero whose imaginary part is no more than that is real."""


@dataclass(frozen=True, slots=True)
class Segment:
    """Bodies between two that do not move, or open ends.

    kg and N s/m of each; N/m and N s/m of each spring, from the left end to the right one: an open
    end has a spring of nought.
    """

    masses: tuple[float, ...]
    drags: tuple[float, ...]
    kappa: tuple[float, ...]
    gamma: tuple[float, ...]

    @property
    def anchored(self) -> bool:
        """Does anything hold the row in its place?"""
        return self.kappa[0] > 0.0 or self.kappa[-1] > 0.0


@dataclass(frozen=True, slots=True)
class Mode:
    """One solution, standing for its conjugate too: rate in 1/s, motion of bodies and springs.

    `push` is kappa e + gamma lambda e, N per m of the shape.
    """

    rate: complex
    shape: tuple[complex, ...]
    strain: tuple[complex, ...]
    push: tuple[complex, ...]
    norm: complex


@lru_cache(maxsize=256)
def modes(segment: Segment) -> tuple[Mode, ...] | None:
    """All modes but those of the row as a whole; None where they are not told apart."""
    m0 = 2.0 ** math.frexp(max(segment.masses))[1]
    stiffest = max(k / min(segment.masses) for k in segment.kappa)
    w0 = 2.0 ** (math.frexp(stiffest)[1] // 2)
    unit = Segment(
        tuple(m / m0 for m in segment.masses),
        tuple(b / (m0 * w0) for b in segment.drags),
        tuple(k / (m0 * w0 * w0) for k in segment.kappa),
        tuple(c / (m0 * w0) for c in segment.gamma),
    )
    found = _rates(unit)
    if found is None:
        return None
    modes = []
    for z in found:
        mode = _refined(unit, z)
        if mode is None:
            return None
        modes.append(_in_units(mode, m0, w0))
    return tuple(modes)


def _in_units(mode: Mode, m0: float, w0: float) -> Mode:
    push = tuple(n * (m0 * w0 * w0) for n in mode.push)
    return Mode(mode.rate * w0, mode.shape, mode.strain, push, mode.norm * (m0 * w0))


def _rates(row: Segment) -> list[complex] | None:
    """Zeros of p with positive imaginary part, and real ones."""
    damped = any(row.drags) or any(row.gamma)
    at_zero = 0 if row.anchored else (1 if any(row.drags) else 2)
    roots = _begin(row, 2 * len(row.masses) - at_zero)
    moving = set(range(len(roots)))
    for _ in range(MOST_ROUNDS):
        for i in list(moving):
            z = roots[i]
            value, growth = _left_over(row, z)
            if value == 0.0:
                moving.discard(i)
                continue
            whole = growth / value - at_zero / z
            others = sum(1.0 / (z - other) for j, other in enumerate(roots) if j != i)
            if whole == others:
                return None
            step = 1.0 / (whole - others)
            roots[i] = z - step
            if abs(step) <= ROOT_ROUNDING * abs(roots[i]):
                moving.discard(i)
        if not moving:
            break
    if moving:
        return None
    if not damped:
        up = sorted(abs(z.imag) for z in roots)[::2]
        return [complex(0.0, w) for w in up]
    real = [complex(z.real, 0.0) for z in roots if abs(z.imag) <= REAL * abs(z)]
    upper = [z for z in roots if z.imag > REAL * abs(z)]
    return [*real, *upper] if len(real) + 2 * len(upper) == len(roots) else None


def _begin(row: Segment, count: int) -> list[complex]:
    """Zeros of every spring with its two bodies alone, turned a little so that none coincide."""
    n, alone = len(row.masses), []
    for k, (kappa, gamma) in enumerate(zip(row.kappa, row.gamma, strict=True)):
        if kappa > 0.0:
            inverse = (1.0 / row.masses[k - 1] if k else 0.0) + (
                1.0 / row.masses[k] if k < n else 0.0
            )
            half, square = 0.5 * gamma * inverse, kappa * inverse
            root = cmath.sqrt(half * half - square)
            alone.append((-half - root, square / (-half - root)))
    alone.sort(key=lambda pair: -abs(pair[0]))
    guess = [z for pair in alone for z in pair][:count]
    if len(guess) < count:
        guess.append(complex(-sum(row.drags) / sum(row.masses)))
    return [z * cmath.exp(complex(0.01 * j, 0.1 + 0.07 * j)) for j, z in enumerate(guess)]


def _left_over(row: Segment, z: complex) -> tuple[complex, complex]:
    """p(z) and p'(z): u and N at every body, both times all the springs passed so far."""
    first = row.kappa[0] + row.gamma[0] * z
    u, du = complex(1.0), complex(0.0)
    push, dpush = -first, complex(-row.gamma[0])
    last = len(row.masses) - 1
    for i, (m, b) in enumerate(zip(row.masses, row.drags, strict=True)):
        inert = (m * z + b) * z
        push, dpush = push - inert * u, dpush - (2.0 * m * z + b) * u - inert * du
        gamma = row.gamma[i + 1]
        s = row.kappa[i + 1] + gamma * z
        if i == last:
            return push - s * u, dpush - s * du - gamma * u
        u, du = s * u - push, s * du + gamma * u - dpush
        push, dpush = s * push, s * dpush + gamma * push
    raise AssertionError


REFINED = 3
"""Rayleigh's quotients for each rate."""


def _refined(row: Segment, z: complex) -> Mode | None:
    """The mode near z."""
    real, still = z.imag == 0.0, z.real == 0.0
    for _ in range(REFINED):
        shape, push, rest = _twisted(row, z)
        norm = _norm(row, z, shape, push)
        if norm == 0.0:
            return None
        z -= rest / norm
        if real or still:  # it stays on its axis
            z = complex(z.real, 0.0) if real else complex(0.0, z.imag)
        else:
            z = complex(min(z.real, 0.0), z.imag)
    if z.real > 0.0:
        return None
    shape, push, _ = _twisted(row, z)
    strain = _strain(row, z, push)
    return Mode(z, shape, strain, push, _norm(row, z, shape, push))


def _strain(row: Segment, z: complex, push: tuple[complex, ...]) -> tuple[complex, ...]:
    return tuple(
        n / (k + c * z) if k > 0.0 else 0j
        for n, k, c in zip(push, row.kappa, row.gamma, strict=True)
    )


def _norm(
    row: Segment, z: complex, shape: tuple[complex, ...], push: tuple[complex, ...]
) -> complex:
    """phi (2 lambda M + C) phi."""
    inert = sum(
        (2.0 * z * m + b) * u * u for m, b, u in zip(row.masses, row.drags, shape, strict=True)
    )
    strain = _strain(row, z, push)
    return inert + sum(c * e * e for c, e in zip(row.gamma, strain, strict=True))


def _twisted(row: Segment, z: complex) -> tuple[tuple[complex, ...], tuple[complex, ...], complex]:
    """Shape, pushes, and phi Q(z) phi: what is left over where the two ends meet.

    From the left ratios N/u, from the right the same: they meet at the body that is left with
    least. The greatest |u| is 1.
    """
    n = len(row.masses)
    s = [k + c * z for k, c in zip(row.kappa, row.gamma, strict=True)]
    inert = [(m * z + b) * z for m, b in zip(row.masses, row.drags, strict=True)]
    left, to_left = [-s[0]] * n, [0j] * n  # N from the left on body i, and u_(i−1), for u_i = 1
    for i in range(1, n):
        behind = left[i - 1] - inert[i - 1]  # N_i for u_(i−1) = 1
        to_left[i] = s[i] / _not_nought(s[i] - behind)
        left[i] = to_left[i] * behind
    right, to_right = [-s[n]] * n, [0j] * n  # −N from the right on body i, and u_(i+1)
    for i in range(n - 2, -1, -1):
        behind = right[i + 1] - inert[i + 1]
        to_right[i] = s[i + 1] / _not_nought(s[i + 1] - behind)
        right[i] = to_right[i] * behind
    rests = [left[i] + right[i] - inert[i] for i in range(n)]
    sizes = [abs(left[i]) + abs(right[i]) + abs(inert[i]) for i in range(n)]
    # where nothing acts at all (a row that drag slows as one) nothing is left over
    at = min(range(n), key=lambda i: abs(rests[i]) / sizes[i] if sizes[i] else 0.0)
    u, push = [0j] * n, [0j] * (n + 1)
    u[at] = 1.0 + 0j
    for i in range(at, -1, -1):
        push[i] = left[i] * u[i]
        if i > 0:
            u[i - 1] = to_left[i] * u[i]
    for i in range(at, n):
        push[i + 1] = -right[i] * u[i]
        if i + 1 < n:
            u[i + 1] = to_right[i] * u[i]
    top = max(u, key=abs)
    rest = rests[at] / (top * top)
    return tuple(one / top for one in u), tuple(one / top for one in push), -rest


def _not_nought(z: complex) -> complex:
    return z if z != 0.0 else complex(1e-300)
