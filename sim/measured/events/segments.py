"""A film in words: rest, hand, coasting, friction, contact, stop, for each cart.

Change points split each cart's motion; a segment is named by its velocities and by what the other
cart does at the time. Speeds are compared with the cart's greatest one.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from sim.measured.events.change_points import SHORTEST, change_points
from sim.measured.events.grid import Grid, coarse
from sim.measured.events.stops import rolled_out
from sim.measured.events.stretch import STILL, Kind, Segment

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from sim.measured.events.contacts import Contact

    Floats = NDArray[np.float64]

STEADY = 0.04
"""Share of the greatest speed by which a coasting cart's velocity changes at most."""

SUDDEN = 0.35
"""Of the greatest speed, per s: a change slower than this is friction or a tilt."""


PUSHED = 0.15
"""Of the greatest speed: what a hand adds at least."""

ROLLED = 15.0
"""Times the noise of a cell: the way of a piece that is no rest."""

SURELY, BENT = 4.0, 180.0**0.5
"""Standard deviations from which a velocity is said to change, for of a film many pieces are
looked at; and that of the bend of n places with unit noise, times n½ and the square of the time
that they take (Legendre's second polynomial): a short noisy piece looks like a hand and a stop."""


def segments(grid: Grid, found: Sequence[Contact]) -> list[Segment]:
    """Both carts' segments in order of time, cart after cart; neighbours of one kind are joined."""
    import numpy as np

    x, wide = coarse(grid)
    every: list[Segment] = []
    for cart in (0, 1):
        greatest = float(np.percentile(np.abs(grid.v[cart]), 98))
        found_at = change_points(x[cart], grid.rounded[cart])
        edges = [k * wide for k in found_at[:-1]]  # the last is the film's own end
        cuts = _cut(grid, edges, found, max(grid.half, SHORTEST * wide - 1))
        listed: list[Segment] = []
        for low, high in cuts:
            one = _named(grid, cart, low, high, greatest, found)
            if listed and (push := _sudden(listed[-1], one, greatest, 1.5 * grid.step * wide)):
                last = listed.pop()
                listed += [replace(last, end=push.begin), push]
                one = replace(one, begin=push.end)
            listed = joined([*listed, one])
        every += joined(rolled_out(listed, greatest, grid.step * wide))
    return every


def joined(listed: Sequence[Segment]) -> list[Segment]:
    """Neighbours of one kind as one."""
    found: list[Segment] = []
    for one in listed:
        if found and found[-1].kind == one.kind:
            last = found.pop()
            found.append(replace(one, begin=last.begin, speeds=(last.speeds[0], one.speeds[1])))
        else:
            found.append(one)
    return found


def _cut(
    grid: Grid, edges: list[int], found: Sequence[Contact], near: int
) -> list[tuple[int, int]]:
    """Change points with those inside of contacts, and `near` cells beside them (the search finds
    no shorter piece), replaced by where these begin and end."""
    import numpy as np

    spans = [
        (int(np.searchsorted(grid.t, one.begin)), int(np.searchsorted(grid.t, one.end)))
        for one in found
    ]
    kept = {k for k in edges if not any(low - near <= k <= high + near for low, high in spans)}
    kept |= {k for span in spans for k in span} | {0, len(grid.t) - 1}
    ordered = sorted(kept)
    return list(itertools.pairwise(ordered))


def _sudden(last: Segment, one: Segment, greatest: float, near: float) -> Segment | None:
    """A push too short for a segment of its own: a jump of the velocity, widened by `near` s."""
    change = one.speeds[0] - last.speeds[1]
    if "contact" in (last.kind, one.kind) or abs(change) < PUSHED * greatest:
        return None
    near = min(near, 0.4 * (last.end - last.begin), 0.4 * (one.end - one.begin))
    kind: Kind = "hand" if abs(one.speeds[0]) > abs(last.speeds[1]) else "stop"
    speeds = last.speeds[1], one.speeds[0]
    return Segment(one.begin - near, one.begin + near, one.cart, kind, speeds)


def _named(
    grid: Grid, cart: int, low: int, high: int, greatest: float, found: Sequence[Contact]
) -> Segment:
    import numpy as np

    t = grid.t
    middle, last = 0.5 * (t[low] + t[high]), high if high < len(t) - 1 else high + 1
    inside = slice(low, max(last, low + 1))
    tau, x = t[inside] - middle, grid.x[cart][inside]
    bend, slope = 0.0, float(np.median(grid.v[cart][inside]))
    reach = t[high] - t[low]
    if len(tau) > 1:
        slope = float(np.polyfit(tau, x, 1)[0])
    if len(tau) >= SHORTEST:
        bent = np.polyfit(tau, x, 2)
        if abs(bent[0]) * reach**2 * len(tau) ** 0.5 > SURELY * BENT * grid.noise[cart]:
            bend, slope = float(bent[0]), float(bent[1])
    speeds = slope - bend * reach, slope + bend * reach
    kind = _kind(speeds, 2.0 * bend, greatest)
    if kind == "rest" and _rolls_out(speeds, bend, reach, grid.noise[cart]):
        kind = "friction"
    if any(one.begin <= middle <= one.end for one in found):
        kind = "contact"
    return Segment(float(t[low]), float(t[high]), cart, kind, speeds)


def _rolls_out(speeds: tuple[float, float], bend: float, reach: float, noise: float) -> bool:
    """Whether a slow piece (m/s, m/s², s) is surely braked, and over a way that no `noise` [m] of a
    resting cart has: a bounce may leave a cart a tenth of its speed, which a track then takes."""
    way = 0.5 * abs(speeds[0] + speeds[1]) * reach
    return bend != 0.0 and abs(speeds[1]) < abs(speeds[0]) and way > ROLLED * noise


def segment(
    grid: Grid, cart: int, begin: float, end: float, kind: Kind, found: Sequence[Contact]
) -> Segment:
    """A segment whose span and kind are given; its velocities from the readings."""
    import numpy as np

    last = len(grid.t) - 1
    low = min(int(np.searchsorted(grid.t, begin)), last - 1)
    high = max(low + 1, min(int(np.searchsorted(grid.t, end)), last))
    made = _named(grid, cart, low, high, 1.0, found)
    return replace(made, begin=begin, end=end, kind=kind)


def _kind(speeds: tuple[float, float], slope: float, greatest: float) -> Kind:
    first, last = abs(speeds[0]), abs(speeds[1])
    middle = abs(speeds[0] + speeds[1]) / 2
    if greatest <= 0.0 or (middle < STILL * greatest and max(first, last) < 4 * STILL * greatest):
        return "rest"
    if abs(speeds[1] - speeds[0]) < STEADY * greatest:
        return "coasting"
    if abs(slope) < SUDDEN * greatest:
        return "friction" if last < first else "coasting"
    if last > first:
        return "hand" if last - first > PUSHED * greatest else "coasting"
    return "stop" if last < 0.5 * first else "friction"
