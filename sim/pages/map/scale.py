"""The scale of a map: bands between round numbers, fixed for all positions of its sliders."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from sim.pages.map.palette import Colour, diverging, sequential
from sim.pages.widget.numbers import decimals_of
from sim.pages.widget.scales import STEP_SLACK, nice_above

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

BANDS = 12
"""At most about so many; more could not be told apart."""

FINE = 400
"""Pixels along the longer side of the picture, at least: contour lines look smooth."""

FLAT = 1e-9
"""Of the greatest value. A map that varies less is one band: rounding is not drawn."""


@dataclass(frozen=True, slots=True)
class Scale:
    """`count` bands from `low` upwards, each `step` wide, in the unit of what is shown."""

    low: float
    step: float
    count: int
    colours: tuple[Colour, ...]

    @property
    def edges(self) -> list[float]:
        """The numbers between the bands, and at both ends."""
        first = round(self.low / self.step)
        return [(first + k) * self.step for k in range(self.count + 1)]

    @property
    def zero(self) -> int:
        """Bands below zero; its upper edge is the line where nothing is left of what is shown."""
        return min(self.count, max(0, round(-self.low / self.step)))

    @property
    def decimals(self) -> int:
        """That the numbers at the edges need."""
        return max(decimals_of(edge) for edge in self.edges)


def scale_for(low: float, high: float) -> Scale:
    """Bands that cover low to high."""
    largest = max(abs(low), abs(high))
    if high - low <= FLAT * largest or largest == 0.0:
        step = nice_above(largest) if largest else 1.0
    else:
        step = nice_above((high - low) / BANDS)
    first = math.floor(low / step + STEP_SLACK)
    last = max(first + 1, math.ceil(high / step - STEP_SLACK))
    count = last - first
    centres = [(first + k + 0.5) * step for k in range(count)]
    colours = diverging(centres) if centres[0] < 0.0 < centres[-1] else sequential(count)
    return Scale(first * step, step, count, tuple(colours))


def magnified(count: int) -> int:
    """Pixels from one point of the longer axis, with so many points, to the next."""
    return max(1, math.ceil(FINE / (count - 1)))


def pixels(values: Sequence[float], columns: int, scale: Scale) -> NDArray[np.uint8]:
    """Colour numbers of the picture, the top row first; its twin is `map-paint.js`.

    0 to count − 1: bands; count: no value; from count + 1: a band's edge towards its right or lower
    neighbour, which is the contour line; 2 count + 1: the line of zero, twice as broad. Between the
    points of the grid the picture is drawn with straight lines; beside a point without a value each
    point keeps to itself.
    """
    import numpy as np

    grid = np.asarray(values, dtype=float).reshape(-1, columns)
    factor = magnified(max(grid.shape))
    fine = _between(_between(grid, factor).T, factor).T[::-1]
    place = np.floor((fine - scale.low) / scale.step + STEP_SLACK)
    bands = np.where(np.isnan(fine), scale.count, np.clip(place, 0, scale.count - 1))
    bands = bands.astype(np.uint8)
    nothing = bands == scale.count
    down, across = bands[:-1] != bands[1:], bands[:, :-1] != bands[:, 1:]
    changes = np.zeros(bands.shape, dtype=bool)
    changes[:, :-1] |= across
    changes[:-1] |= down
    found = np.where(changes & ~nothing, bands + scale.count + 1, bands)
    plus = bands >= scale.zero
    for one, other in (np.s_[:, :-1], np.s_[:, 1:]), (np.s_[:-1], np.s_[1:]):
        crossed = (plus[one] != plus[other]) & ~nothing[one] & ~nothing[other]
        found[one][crossed] = found[other][crossed] = 2 * scale.count + 1
    return found


def _between(grid: NDArray[np.float64], factor: int) -> NDArray[np.float64]:
    """Each row with `factor` − 1 more points between two."""
    import numpy as np

    steps = np.arange((grid.shape[1] - 1) * factor + 1)
    left = np.minimum(steps // factor, grid.shape[1] - 2)
    part = (steps - left * factor) / factor
    a, b = grid[:, left], grid[:, left + 1]
    alone = np.isnan(a) | np.isnan(b)
    return np.where(alone, np.where(part < 0.5, a, b), a * (1 - part) + b * part)
