"""How long a contact lasts, by whatever law its bumpers push.

A film shows how wide in time a push is, hardly its shape: that of the law which is fitted (about
half a sine) is one of many. Pushes with the same impulse and the same root mean square of the time
around their middle move carts nearly alike, and last as long as half a sine times

    0.75              an even push
    1.2               one that begins and ends softly (1 − cos)
    up to e^(−1/2)    bumpers that spring back from all of their overlap, e² times as strongly:
                      weak and long (the bumper law gives back what is left, strongly and shortly)
    up to 2.5         magnets, which begin to push from afar

Counted as halves of 95 % intervals of the logarithm, the last one where carts lose so little that
they may be magnets.

A logger that gives means of its readings makes a push as wide as these means, however short it was.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from typing import TYPE_CHECKING

from sim.measured.model.effects import ALIKE
from sim.measured.model.quantity import Known

if TYPE_CHECKING:
    from sim.measured.tracks import Measured

SHAPES = 0.29
"""ln 0.75 and more than ln 1.2."""

MAGNETS = math.log(2.5)
LOSSLESS = 0.95
"""e that magnets have at least, as nothing rubs between them."""


MEANS = 7.0
"""Readings. An instant push in means over five of them looks like half a sine of so many."""

FILM = 1.0 / 23.5
"""s. Films have 24 frames a second at least; what is read more seldom is a logger."""


def smoothed(measured: Measured, alike: float) -> float:
    """s. A contact that is not surely longer may be smoothing alone; 0 for a film whose residuals
    are not `alike` (correlation of neighbours): a film may have been smoothed, too, and means of
    three white errors have 0.67."""
    frame = frame_of(measured)
    return MEANS * frame if measured.own or frame > FILM or alike > ALIKE else 0.0


def frame_of(measured: Measured) -> float:
    """s. From one reading to the next."""
    gaps = sorted(b - a for one in measured.tracks for a, b in itertools.pairwise(one.t))
    return gaps[len(gaps) // 2]


def by_any_law(lasts: Known, e: float, highest: float) -> Known:
    """The length of a contact in s with its interval by one law, no surer than the law is; `e` of
    this contact, and the `highest` that its interval allows."""
    longer = max(SHAPES, -0.5 * math.log(min(max(e, 1e-3), 1.0)))
    if highest >= LOSSLESS:
        longer = max(longer, MAGNETS)
    low = math.exp(-math.hypot(math.log(lasts.value / lasts.low), SHAPES))
    high = math.exp(math.hypot(math.log(lasts.high / lasts.value), longer))
    sd = lasts.sd * math.log(high / low) / math.log(lasts.high / lasts.low)
    return replace(lasts, low=lasts.value * low, high=lasts.value * high, sd=sd)
