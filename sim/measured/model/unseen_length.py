"""A contact that is shorter than a frame: what its length leaves open, and what it does not.

Where no reading lies inside a contact, none moves with its length. The derivatives at the best fit
then say that it may be anything, hours too, and with it the instant of the touch, the velocities
there (a cart that rubs was faster hours before) and all that comes of them: nothing is told of a
film that tells e and the masses well. But a contact of three frames does have readings inside, and
they say no. So the length is laid at some values, all else is fitted beside each, and they count
as much as they leave residuals small:

    weight ∝ exp(−n/2 ln(squares)) ,   n readings, as many as are apart
    covariance = Σ weight (its own + what its values differ by, squared)

The values stay those of the best fit; the length stays untold.
"""

from __future__ import annotations

import math
from dataclasses import replace

from sim.measured.events.correlated import inflation
from sim.measured.model.effects import Compared
from sim.measured.model.fit import Fit, fit
from sim.measured.model.known import WIDEST_LOG
from sim.measured.model.lasting import frame_of
from sim.measured.refusal import FitError
from sim.measured.tracks import Measured

LENGTHS = (0.25, 0.75, 1.25, 1.75, 2.5, 3.5)
"""Frames that the contact may last."""

AS_MUCH = 0.02
"""Of the weight of the best length: below, longer ones are not tried."""

NEAR = 1.5
"""Times the smallest squares: effects that leave more count for nothing."""


def of_any_length(rows: list[Compared], measured: Measured) -> list[Compared]:
    """The fits, each no surer, and no less sure, than every length that the readings allow lets it
    be; `measured`: the readings that were fitted."""
    least = min(row.fit.squares for row in rows)
    return [
        replace(row, fit=_spread(row.fit, measured)) if row.fit.squares <= NEAR * least else row
        for row in rows
    ]


def _spread(made: Fit, measured: Measured) -> Fit:
    """One fit, whose length the readings do not tell, over the lengths that they allow."""
    import numpy as np

    frame = frame_of(measured)
    bumped = 0.0 < made.duration <= LENGTHS[-1] * frame and made.squares > 0.0
    if made.sd("ln_w0") <= WIDEST_LOG or not bumped:
        return made
    tried = _by_length(made, measured, frame)
    if not tried:
        return made
    total = sum(weight for weight, _ in tried)
    values, wide = np.array(made.values), np.zeros((len(made.unknowns),) * 2)
    for weight, one in tried:
        at = [made.unknowns.index(name) for name in one.unknowns]
        apart = np.array(one.values) - values[at]
        wide[np.ix_(at, at)] += weight / total * (one.covariance + np.outer(apart, apart))
    length = made.unknowns.index("ln_w0")
    wide[length, length] = math.inf
    return replace(made, covariance=tuple(tuple(map(float, row)) for row in wide))


def _by_length(made: Fit, measured: Measured, frame: float) -> list[tuple[float, Fit]]:
    """The fits with a contact of each length, and how much each counts, from the shortest on."""
    import numpy as np

    _, lasting = inflation([np.array(track) for track in made.residuals])
    half = 0.5 * sum(map(len, made.residuals)) / lasting
    p, found, start = made.parameters, list[tuple[float, Fit]](), made.duration
    for length in LENGTHS:
        at = replace(p, w0=p.w0 * start / (length * frame),
                     touch=p.touch + 0.5 * (start - length * frame))  # fmt: skip
        try:
            one = fit(measured, replace(made.asked, lasts=True), at)
        except FitError:
            continue
        if not set(one.unknowns) <= set(made.unknowns):
            continue  # beside another length a cart that stood moves: another model
        weight = math.exp(min(half * math.log(made.squares / one.squares), 50.0))
        found.append((weight, one))
        if weight < AS_MUCH * max(other for other, _ in found):
            break
    return found
