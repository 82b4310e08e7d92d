"""Where one cart's motion changes: the best split of its places into quadratics.

Optimal partitioning (Jackson et al. 2005; the search that PELT prunes): for each cell j

    best(j) = min over i of  best(i) + RSS(i, j)/s² + penalty ,

RSS(i, j) what the best quadratic leaves of the cells i … j−1, s the noise of a cell (the median of
what short quadratics leave), penalty PRICE · ln n for each further segment. The libraries that have
this are compiled and do not run in a page; on 160 cells it is a few matrix products.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

SHORTEST = 4
"""Cells of a segment: one more than a quadratic has numbers."""

JUDGED = 8
"""Cells of the short quadratics whose leavings give the noise."""

PRICE = 12.0
"""Of a segment, times ln n. Three numbers and an instant cost 4 ln n by Schwarz's criterion if
noise is white; devices smooth, and their noise is alike over several cells."""

FLOOR = 2e-4
"""Noise of a cell is at least this share of the whole range: wobble is no change."""


def change_points(x: Floats, rounded: float = 0.0) -> list[int]:
    """Cells at which segments begin, and len(x): [0, …, n]. `x` on a uniform grid, m; `rounded`: of
    a cell by rounding, m, which rest does not show."""
    import numpy as np

    n = len(x)
    rss = _leavings(x)
    short = rss[np.arange(n - JUDGED + 1), np.arange(JUDGED, n + 1)] if n > JUDGED else np.zeros(1)
    least = max(FLOOR * float(np.ptp(x)), rounded, 1e-9)
    noise = max(float(np.median(short)) / (JUDGED - 3), least**2)
    penalty = PRICE * np.log(n)
    best = np.full(n + 1, np.inf)
    best[0] = -penalty
    come = np.zeros(n + 1, dtype=int)
    for j in range(SHORTEST, n + 1):
        total = best[: j - SHORTEST + 1] + rss[: j - SHORTEST + 1, j] / noise + penalty
        come[j] = int(np.argmin(total))
        best[j] = total[come[j]]
    edges = [n]
    while edges[-1] > 0:
        edges.append(int(come[edges[-1]]))
    return edges[::-1]


def _leavings(x: Floats) -> Floats:
    """RSS(i, j) of the best quadratic through the cells i … j−1; infinite if they are too few."""
    import numpy as np

    n = len(x)
    rss = np.full((n + 1, n + 1), np.inf)
    for length in range(SHORTEST, n + 1):
        basis = _quadratics(length)
        windows = np.lib.stride_tricks.sliding_window_view(x, length)
        windows = windows - windows.mean(axis=1, keepdims=True)
        left = np.sum(windows**2, axis=1) - np.sum((windows @ basis) ** 2, axis=1)
        starts = np.arange(n - length + 1)
        rss[starts, starts + length] = np.maximum(left, 0.0)
    return rss


@cache
def _quadratics(length: int) -> Floats:
    """An orthonormal basis of the quadratics on so many cells: of each of a few hundred lengths,
    asked for by every cart."""
    import numpy as np

    return np.linalg.qr(np.vander(np.linspace(-1.0, 1.0, length), 3))[0]
