"""Do both carts change their velocity in step?

If nothing but the other cart pushes, m_A a_A = −m_B a_B at every instant: each velocity's share of
its whole change, n = (v − v before)/(v after − v before), is the same curve for both. That needs no
mass, no sign and no zero. A hand, an end stop or a sensor that loses its cart shows as a lag.
"""

from __future__ import annotations

from dataclasses import dataclass

from sim.measured.events.grid import Grid


@dataclass(frozen=True, slots=True)
class Step:
    """`lag`: s, how much later the first cart changes; `apart`: root mean square of n_A − n_B;
    `cells`: how many cells of the grid tell it."""

    lag: float
    apart: float
    cells: int


def in_step(grid: Grid, begin: float, end: float) -> Step:
    """Both curves compared between two times."""
    import numpy as np

    last = len(grid.t) - 1
    low = max(int(np.searchsorted(grid.t, begin - 1e-9)) - 1, 0)
    high = min(int(np.searchsorted(grid.t, end - 1e-9)) + 1, last)
    shares = []
    for v in grid.v:
        change = float(v[high] - v[low])
        shares.append((v[low : high + 1] - v[low]) / (change if change else 1e-12))
    left = shares[0] - shares[1]
    lag = -float(np.sum(left)) * grid.step
    return Step(lag, float(np.sqrt(np.mean(left**2))), high - low + 1)
