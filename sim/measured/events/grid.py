"""Both carts on one uniform grid of time, with smoothed velocities and accelerations.

Devices read at their own instants and leave frames out. Each cart is averaged over cells of one
width (straight lines bridge empty cells); a quadratic sliding over the cells (Savitzky–Golay) gives
v and a. Used to find *when* something happens; velocities are told by `sides` from all readings.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from sim.measured.refusal import FitError
from sim.measured.rounding import EVEN, step_of
from sim.measured.scatter import noise_of
from sim.measured.track import Track
from sim.scene.said import said

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

MOST_CELLS = 500
FEWEST_CELLS = 16
HALF = 3
"""Cells on each side that the sliding quadratic takes, in a log of few readings."""

SMOOTHED, WIDEST = 0.016, 0.1
"""s. The same half-width in time, for devices that read hundreds of times a second; and up to
which it is widened where noise hides the contact."""

CLEAR = 20.0
"""Times the lower quartile of √|a_A a_B|: what a contact's peak should reach."""

QUARTILE = 0.5
"""Of what rounding alone makes of √|a_A a_B|, root mean square: the least quartile. Of two normal
numbers √|n m| has 0.35; but errors of rounding come back in step, and four times this is passed in
one cell of a hundred."""


@dataclass(frozen=True, slots=True)
class Grid:
    """Rows: cart, columns: cells of width `step` [s]. SI."""

    t: Floats
    x: Floats
    v: Floats
    a: Floats
    step: float
    half: int  # cells
    noise: tuple[float, float]  # m, of one cell of each cart
    rounded: tuple[float, float]  # m, part of the noise; a resting cart does not show it

    def usual(self, trace: Floats) -> float:
        """m/s². The lower quartile of a √|a_A a_B|, and no less than rounding gives it: where a
        cart rests, its rounded readings are all alike and its trace is none."""
        import numpy as np

        through = float(np.linalg.norm(_through(self.half, self.step)[2]))
        errors = 2.0 * through * math.sqrt(self.rounded[0] * self.rounded[1])
        return max(float(np.percentile(trace, 25)), QUARTILE * errors)


def grid_of(tracks: tuple[Track, Track]) -> Grid:
    """The span in which both carts were seen; raises FitError where there is none."""
    import numpy as np

    begin, end = max(one.t[0] for one in tracks), min(one.t[-1] for one in tracks)
    frame = max(float(np.median(np.diff(one.t))) for one in tracks)
    if end - begin < FEWEST_CELLS * frame:
        reason = said("the two carts were hardly read at the same time")
        raise FitError(reason, said("one log with both, or a longer span of time"))
    cells = int(min(MOST_CELLS, (end - begin) / frame + 1.0 + 1e-6))
    # Of devices with one clock a reading lies in the middle of its cell: from an edge it would be
    # shared by two, and their noise be told as a third of what it is.
    edges = np.linspace(begin - 0.5 * frame, end + 0.5 * frame, cells + 1)
    t, step = 0.5 * (edges[1:] + edges[:-1]), (end - begin + frame) / cells
    x = np.array([_averaged(one, edges, t) for one in tracks])
    rounded = _rounded(tracks[0]), _rounded(tracks[1])
    noise = max(noise_of(x[0]), rounded[0]), max(noise_of(x[1]), rounded[1])
    half, most = max(HALF, round(SMOOTHED / step)), min(round(WIDEST / step), (cells - 2) // 2)
    tried: list[tuple[float, Grid]] = []
    while True:
        half = min(half, (cells - 2) // 2)
        grid = Grid(t, x, *_slid(x, half, step), step, half, noise, rounded)
        tried.append((_contrast(grid), grid))
        if tried[-1][0] >= CLEAR or half >= most:
            return max(tried, key=lambda one: one[0])[1] if tried[-1][0] < CLEAR else grid
        half += max(1, half // 3)


def _contrast(grid: Grid) -> float:
    """The greatest push on both, over the usual noise."""
    import numpy as np

    trace = np.sqrt(np.abs(grid.a[0] * grid.a[1]))
    usual = grid.usual(trace)
    return float(trace.max()) / usual if usual > 0.0 else CLEAR


def _rounded(track: Track) -> float:
    """m. Standard deviation of a reading by rounding."""
    import numpy as np

    return EVEN * step_of(np.array(track.value))


def _through(half: int, step: float) -> Floats:
    """What gives place, slope and bend of a quadratic from 2 half + 1 cells."""
    import numpy as np

    tau = np.arange(-half, half + 1) * step
    return np.linalg.pinv(np.vander(tau, 3, increasing=True))


def _averaged(track: Track, edges: Floats, t: Floats) -> Floats:
    import numpy as np

    times, places = np.array(track.t), np.array(track.value)
    cell = np.clip(np.searchsorted(edges, times, side="right") - 1, -1, len(t))
    cell[times < edges[0]] = -1
    cell[times == edges[-1]] = len(t) - 1
    inside = (cell >= 0) & (cell < len(t))
    count = np.bincount(cell[inside], minlength=len(t))
    # The mean of a cell belongs to the mean of its instants, not to its middle.
    mean = [np.bincount(cell[inside], weights=w[inside], minlength=len(t)) for w in (times, places)]
    full = count > 0
    return np.interp(t, mean[0][full] / count[full], mean[1][full] / count[full])


def _slid(x: Floats, half: int, step: float) -> tuple[Floats, Floats]:
    """v and a of a quadratic through 2 half + 1 cells; at the ends the first and last one's."""
    import numpy as np

    through = _through(half, step)
    windows = np.lib.stride_tricks.sliding_window_view(x, 2 * half + 1, axis=1)
    v, a = windows @ through[1], 2.0 * (windows @ through[2])
    pad = ((0, 0), (half, half))
    return np.pad(v, pad, mode="edge"), np.pad(a, pad, mode="edge")


MOST_JUDGED = 170
"""Cells of a search for change points: its cost grows with their square."""


def coarse(grid: Grid) -> tuple[Floats, int]:
    """Places in cells so wide that there are at most MOST_JUDGED, and how many of the grid's each
    holds."""
    wide = -(-len(grid.t) // MOST_JUDGED)
    count = len(grid.t) // wide
    return grid.x[:, : count * wide].reshape(2, count, wide).mean(axis=2), wide
