"""How the noise of two tracks scatters what least squares finds, where the noise need not be white.

Compression, smoothing and marks that creep leave residuals that are alike for many frames. Taken
one by one they look like more knowledge than they are. Least squares finds δ = A Uᵀε, with U an
orthonormal basis of the model's directions, so whatever the noise ε is,

    covariance = A (Uᵀ Ω U) Aᵀ ,   Ω the covariance of the noise                      (a sandwich)

Each track's noise is taken as a white part and a chain (AR(1)) with correlation rho from one
reading to the next, of share s, and the tracks may differ in size. In the cosine transform of a
track such noise is nearly independent (Ahmed, Natarajan & Rao 1974), with the variances

    f_k = 1 − s + s (1 − rho²) / (1 − 2 rho cos(π k/n) + rho²) .

A few frames tell the instant of the touch and the stiffness, and their noise may be of another size
than that of all others; so may that of a cart that stands (`standing`). With D of the sizes of the
readings, Ω becomes D Ω D.

No rho is picked: short tracks tell it badly, and the model has eaten part of it, so that a rho
from residuals comes out too small. Each (rho, s, sizes) is weighed by its restricted likelihood, in
which the unknowns are integrated out (Harville 1974), and Uᵀ Ω U is the mean by these weights
(Bayesian model averaging, Hoeting et al. 1999). Beforehand white noise has two thirds of them.

The usual alternative, sums of products of residuals with Bartlett weights (Newey & West 1987), held
the truth in 87 of 100 films with white noise and in 61 with rho = 0.95: tracks of 30 to 200
readings are too short for it. `python -m tests.benchmarks.intervals` has the figures of this one.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Bools = NDArray[np.bool_]

RHOS = (0.3, 0.5, 0.7, 0.85, 0.93, 0.97)
SHARES = (0.15, 0.3, 0.5, 0.75, 1.0)
SIZES = (-1.0, -0.5, 0.0, 0.5, 1.0)
"""Logarithm of the variance of the first track's noise; the second has the opposite."""

WHITE = 2.0 / 3.0
"""Weight beforehand of noise without a chain. With half of it, intervals of white noise become
15 % wider than those of somebody who knows that it is white; with two thirds, 12 %."""

EQUAL = 0.5
"""Weight beforehand of tracks with one size of noise."""

PUSHED = ((1.0, 2.0 / 3.0), (1.5, 1.0 / 3.0))
"""Times the noise of the other readings in those of the contact, and the weight beforehand. There a
coder, which takes what moved to move on, leaves more behind: of 300 made films (H.264, crf 20) a
mark was off by 0.24 mm while its cart coasted and by 0.26 to 0.30 mm while it was pushed."""

NOTHING = 1e-9
"""Of the greatest residual's square sum: what is left over below is rounding, and has no colour."""


@dataclass(frozen=True, slots=True)
class Colour:
    """Noise of one kind; `weight` beforehand."""

    rho: float
    share: float
    weight: float


def colours() -> Iterator[Colour]:
    """All kinds that are weighed; the first is white."""
    yield Colour(0.0, 0.0, WHITE)
    each = (1.0 - WHITE) / (len(RHOS) * len(SHARES))
    for rho in RHOS:
        for share in SHARES:
            yield Colour(rho, share, each)


def variances(colour: Colour, count: int) -> Floats:
    """f_k of a track of `count` readings, whose mean is about 1."""
    import numpy as np

    rho, share = colour.rho, colour.share
    cosines = np.cos(np.pi * np.arange(count) / count)
    chain = (1.0 - rho * rho) / (1.0 - 2.0 * rho * cosines + rho * rho)
    return np.asarray(1.0 - share + share * chain)


def cosine_transform(columns: Floats) -> Floats:
    """Orthonormal (DCT-II), along the first axis."""
    import numpy as np

    count = len(columns)
    basis = np.cos(np.pi / count * np.outer(np.arange(count), np.arange(count) + 0.5))
    basis *= math.sqrt(2.0 / count)
    basis[0] *= math.sqrt(0.5)
    return np.asarray(basis @ columns)


def scatter(
    directions: Floats, residuals: Sequence[Floats], freedom: int, pushed: Bools, sizes: Floats
) -> Floats:
    """Uᵀ Ω U in m², symmetric; `directions` are the columns of U, for all readings track by track,
    `residuals` in m of each of two tracks, `freedom`: readings less unknowns, `pushed`: which
    readings lie in the contact, `sizes`: of each reading's noise, relative."""
    import numpy as np

    left, first = np.concatenate(residuals), len(residuals[0])
    squares = float(left @ left)
    chances, found = [], []
    for times, before in PUSHED if pushed.any() else PUSHED[:1]:
        size = sizes * np.where(pushed, times, 1.0)
        spectra = [
            _Spectrum.of(directions[part], left[part], size[part])
            for part in (slice(None, first), slice(first, None))
        ]
        for chance, rest, outer in _kinds(spectra, NOTHING * squares):
            chances.append(math.log(before) - float(np.log(size).sum()) + chance)
            found.append(rest / freedom * outer)
    if not found:
        return np.asarray(squares / freedom * np.eye(directions.shape[1]))
    weights = np.exp(np.array(chances) - max(chances))
    return np.asarray(np.tensordot(weights / weights.sum(), np.array(found), axes=1))


def _kinds(spectra: Sequence[_Spectrum], nothing: float) -> Iterator[tuple[float, float, Floats]]:
    """Of each colour and each pair of sizes: the logarithm of its restricted likelihood and weight
    beforehand, what is left over in m² (more than `nothing`), and Uᵀ Ω U for noise of size one."""
    import numpy as np

    counts = [len(one.y) for one in spectra]
    unknowns = spectra[0].u.shape[1]
    scales = [(math.exp(-size), math.exp(size)) for size in SIZES]
    smaller, larger = np.array(scales).T[..., None]
    for colour in colours():
        track = [_Weighed.of(one, *_spread(colour, len(one.y))) for one in spectra]
        # Of all sizes at once: a hundred calls of NumPy in place of five hundred.
        along = smaller * track[0].along + larger * track[1].along
        inner = smaller[..., None] * track[0].inner + larger[..., None] * track[1].inner
        solved, determined = np.linalg.solve(inner, along[..., None]), np.linalg.slogdet(inner)[1]
        for k, (size, (a, b)) in enumerate(zip(SIZES, scales, strict=True)):
            rest = a * track[0].squares + b * track[1].squares
            rest -= float(along[k] @ solved[k, :, 0])
            if not rest > nothing:
                continue
            logs = track[0].logs + track[1].logs + size * (counts[0] - counts[1])
            logs += float(determined[k]) + (sum(counts) - unknowns) * math.log(rest)
            share = EQUAL if size == 0.0 else (1.0 - EQUAL) / (len(SIZES) - 1)
            chance = math.log(colour.weight * share) - 0.5 * logs
            yield chance, rest, track[0].outer / a + track[1].outer / b


@lru_cache(128)  # all colours of two tracks
def _spread(colour: Colour, count: int) -> tuple[Floats, float]:
    """The variances of a track and the sum of their logarithms: the same in every fit of it."""
    import numpy as np

    found = variances(colour, count)
    return found, float(np.sum(np.log(found)))


@dataclass(frozen=True, slots=True)
class _Spectrum:
    """The cosine transforms of D⁻¹U, DU and D⁻¹y of one track, D the sizes of its readings."""

    u: Floats
    enlarged: Floats
    y: Floats

    @classmethod
    def of(cls, directions: Floats, residuals: Floats, size: Floats) -> _Spectrum:
        import numpy as np

        each, count = size[:, None], directions.shape[1]
        columns = np.hstack([directions / each, directions * each, residuals[:, None] / each])
        found = cosine_transform(columns)
        return cls(found[:, :count], found[:, count:-1], found[:, -1])


@dataclass(frozen=True, slots=True)
class _Weighed:
    """Sums over one track: UᵀF⁻¹U, UᵀF⁻¹y, yᵀF⁻¹y, UᵀFU and ln|F|, with F of the variances."""

    inner: Floats
    along: Floats
    squares: float
    outer: Floats
    logs: float

    @classmethod
    def of(cls, one: _Spectrum, f: Floats, logs: float) -> _Weighed:
        light = one.u / f[:, None]
        outer = one.enlarged.T @ (one.enlarged * f[:, None])
        squares = float(one.y @ (one.y / f))
        return cls(one.u.T @ light, light.T @ one.y, squares, outer, logs)
