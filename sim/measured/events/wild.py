"""Wild readings, set aside before anything is looked for: a mark that jumped, an echo, a dropout.

A reading is predicted by the cubic through the two readings on each side of it; without it the
same is done for these four. With d_k what the reading is missed by, in units of what noise of one
size would give (Lagrange's weights w: √(1 + Σ w²)), it is wild where

    |d_k| > FAR max(s, what the four are missed by once it is left out) ,   s = 1.48 median |d| .

A contact bends a track at several readings, so its neighbours are missed too; an error of one
reading goes with it. Up to LONGEST neighbours may be wild together, if they are farther off than
the cart goes meanwhile. Of white noise, less than one
reading in a million is set aside; what is less far off is weighed down by the fit's loss.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from sim.measured.refusal import shown
from sim.measured.scatter import scatter_of
from sim.measured.track import FEWEST, Track
from sim.measured.tracks import Measured
from sim.scene.said import counted, listed, said

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Places = NDArray[np.intp]

FAR = 5.0
LONGEST = 4
"""Readings that follow each other."""

MOST = 0.2
"""Share of a cart's readings. Of more nobody can say which are the wild ones."""

ROUNDS = 8
SIDE = 2  # readings on each side that predict
LISTED = 5  # instants in a sentence


@dataclass(frozen=True, slots=True)
class Aside:
    """A reading that is set aside: cart 0 or 1, its instant in s, its place in m."""

    cart: int
    t: float
    value: float


def without_wild(measured: Measured) -> tuple[Measured, tuple[Aside, ...]]:
    """The readings that are left, and those set aside; for positions."""
    aside: list[Aside] = []
    tracks = []
    for cart, track in enumerate(measured.tracks):
        wild = wild_of(track)
        aside += [Aside(cart, track.t[k], track.value[k]) for k in sorted(wild)]
        kept = [k for k in range(len(track.t)) if k not in wild]
        tracks.append(_only(track, kept) if wild else track)
    if not aside:
        return measured, ()
    return replace(measured, tracks=(tracks[0], tracks[1])), tuple(aside)


def _only(track: Track, kept: list[int]) -> Track:
    return replace(
        track,
        t=tuple(track.t[k] for k in kept),
        value=tuple(track.value[k] for k in kept),
        lines=tuple(track.lines[k] for k in kept),
    )


def wild_of(track: Track) -> set[int]:
    """Which readings of one cart are wild, by their place in the track."""
    import numpy as np

    t, x = np.array(track.t), np.array(track.value)
    alive = np.arange(len(t))
    for _ in range(ROUNDS):
        if len(alive) < FEWEST + LONGEST:
            break
        missed = _missed(t[alive], x[alive], np.arange(len(alive)))
        usual = max(scatter_of(missed), _finest(x[alive]))
        found: set[int] = set()
        for k in np.argsort(-missed):
            if missed[k] <= FAR * usual:
                break
            if int(k) not in found:
                found |= _together(t[alive], x[alive], int(k), usual)
        if not found:
            break
        alive = np.delete(alive, sorted(found))
    wild = set(range(len(t))) - {int(k) for k in alive}
    return wild if len(wild) <= MOST * len(t) else set()


def _finest(x: Floats) -> float:
    """m. Small differences of readings: of rounded ones, which may all agree, their step. Of others
    it need not be one (`rounding.step_of` is sure of it), and is small beside their noise."""
    import numpy as np

    steps = np.diff(np.unique(x))
    return float(np.percentile(steps, 10)) if len(steps) else 0.0


def _missed(t: Floats, x: Floats, places: Places) -> Floats:
    """|d| of the readings at `places`, each predicted by its four neighbours."""
    import numpy as np

    first = np.clip(places - SIDE, 0, len(t) - 2 * SIDE - 1)
    window = first[:, None] + np.arange(2 * SIDE + 1)
    others = window[window != places[:, None]].reshape(len(places), 2 * SIDE)
    return _by(t, x, others, places)


def _by(t: Floats, x: Floats, others: Places, places: Places) -> Floats:
    """The same, predicted by the readings `others`, a row for each place."""
    import numpy as np

    nodes, at = t[others], t[places]
    weights = np.ones_like(nodes)
    for i in range(nodes.shape[1]):
        for j in range(nodes.shape[1]):
            if i != j:
                weights[:, i] *= (at - nodes[:, j]) / (nodes[:, i] - nodes[:, j])
    off = x[places] - np.sum(weights * x[others], axis=1)
    return np.asarray(np.abs(off) / np.sqrt(1.0 + np.sum(weights**2, axis=1)))


def _together(t: Floats, x: Floats, k: int, usual: float) -> set[int]:
    """The shortest run with the reading k in it that is wild; empty: none is."""
    for length in range(1, LONGEST + 1):
        for first in range(max(0, k - length + 1), min(k, len(t) - length) + 1):
            run = range(first, first + length)
            if _wild(t, x, run, usual):
                return set(run)
    return set()


def _wild(t: Floats, x: Floats, run: range, usual: float) -> bool:
    import numpy as np

    wide = 2 * SIDE + 1
    left = np.arange(max(0, run.start - wide), run.start)
    right = np.arange(run.stop, min(len(t), run.stop + wide))
    near = np.concatenate([left, right])
    if len(near) < wide:
        return False
    middle = min(max(len(left) - SIDE, 0), len(near) - 2 * SIDE)
    four = near[middle : middle + 2 * SIDE]
    here = np.arange(run.start, run.stop)
    off = _by(t, x, np.tile(four, (len(here), 1)), here)
    way = abs(float(x[four[SIDE]] - x[four[SIDE - 1]]))
    if len(run) > 1 and float(np.min(off)) < way:
        return False  # a short contact, rather
    rest = _missed(t[near], x[near], np.arange(middle, middle + 2 * SIDE))
    return bool(np.min(off) > FAR * max(usual, float(np.max(rest))))


def of_aside(aside: tuple[Aside, ...], names: tuple[str, str]) -> list[str]:
    """A sentence for the reader, or none."""
    found = []
    for cart, name in enumerate(names):
        times = [one.t for one in aside if one.cart == cart]
        if times:
            more = " …" if len(times) > LISTED else ""
            found.append(
                counted(
                    "1 reading of {cart} (at {times} s)",
                    "{n} readings of {cart} (at {times} s)",
                    n=len(times),
                    cart=shown(name),
                    times=", ".join(f"{t:.3f}" for t in times[:LISTED]) + more,
                )
            )
    if not found:
        return []
    if len(aside) == 1:
        return [said("Set aside, far off their neighbours is {readings}.", readings=found[0])]
    return [said("Set aside, far off their neighbours are {readings}.", readings=listed(found))]
