"""How well the readings tell each unknown."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from sim.measured.model.coloured import scatter
from sim.measured.rounding import unseen

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Bools = NDArray[np.bool_]


UNTOLD_CHANGE = 1.0
"""An unknown that may change by so much (in ln w0: 2.7-fold) without a trace is not told."""

TRACE = 1e-3
"""Of the noise of one reading, all readings taken together: less of a change leaves no trace."""


NEARLY_ZERO = 1e-5
"""Singular value of the Jacobian with columns of size one: below is rounding of its differences."""


ALONG = 1e-2
"""Share of an unknown in a direction that no reading sees, above which it is not told: the shares
of all others are rounding."""


def covariance_of(
    jacobian: Floats,
    residuals: Sequence[Floats],
    freedom: int,
    pushed: Bools,
    sizes: Floats,
    steps: Sequence[float] = (0.0, 0.0),
) -> tuple[tuple[float, ...], ...]:
    """Of the unknowns; the variance of what the readings do not tell is infinite.

    `residuals` in m, track by track, need not be white; `freedom`: readings less unknowns,
    `pushed`: which readings lie in the contact, `sizes`: of each reading's noise, relative;
    `steps`: in m, to which the readings of a track are rounded, 0: they are not.

    An unknown that hardly moves any reading is not told. Of the others, columns are scaled to one
    size, and a direction in which no reading moves leaves all unknowns untold that lie along it.
    """
    import numpy as np

    count = jacobian.shape[1]
    each = np.concatenate(residuals) / sizes
    noise = math.sqrt(float(each @ each) / freedom)
    norms = np.linalg.norm(jacobian, axis=0)
    deaf = norms * UNTOLD_CHANGE < TRACE * noise
    told = np.flatnonzero(~deaf & (norms > 0.0))
    directions, singular, axes = np.linalg.svd(jacobian[:, told] / norms[told], full_matrices=False)
    seen = singular > NEARLY_ZERO
    inverse = axes[seen].T / singular[seen]
    meat = scatter(directions[:, seen], residuals, freedom, pushed, sizes)
    part = inverse @ meat @ inverse.T / np.outer(norms[told], norms[told])
    cuts = np.cumsum([len(track) for track in residuals])[:-1]
    by_reading = np.split(inverse @ directions[:, seen].T / norms[told][:, None], cuts, axis=1)
    for weights, left, step in zip(by_reading, residuals, steps, strict=True):
        part[np.diag_indices(len(told))] += unseen(weights, left, step) ** 2
    blind = np.any(np.abs(axes[~seen]) > ALONG, axis=0)
    part[np.diag_indices(len(told))] += np.where(blind, np.inf, 0.0)
    whole = np.zeros((count, count))
    whole[np.ix_(told, told)] = part
    for k in set(range(count)) - set(told.tolist()):
        whole[k, k] = math.inf
    return tuple(tuple(map(float, row)) for row in whole)
