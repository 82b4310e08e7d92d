"""A brake that the readings do not show may be there all the same: every track brakes a little.

Which effect is fitted is decided by a test. An interval that takes the decision for certain is too
narrow: a friction that just stays unseen (chance 1 in 50, say) bends the velocities at the contact
by more than the model without it allows. So the other effects count as much as they are likely,
by Akaike's weights (Burnham and Anderson 2002, “Model selection and multimodel inference”):

    weight ∝ exp(−n/2 ln(squares) − unknowns) ,   n readings, as many as are apart
    variance = own + Σ weight (what the other's is larger by + (other value − own value)²)

The values stay those of the model that was chosen.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from sim.measured.events.correlated import inflation
from sim.measured.model.effects import Compared
from sim.measured.model.fit import Fit


def averaged(made: Fit, rows: Sequence[Compared]) -> Fit:
    """The fit, no surer of its numbers than of its effect."""
    others = [row.fit for row in rows if row.effect != made.asked.effect]
    if not others or not all(one.squares > 0.0 for one in (made, *others)):
        return made  # residuals are rounding, and tell the effect
    weights = _weights((made, *others))
    wide = [list(row) for row in made.covariance]
    for other, share in zip(others, weights[1:], strict=True):
        for k, name in enumerate(made.unknowns):
            if name not in other.unknowns:
                continue
            i = other.unknowns.index(name)
            wider = max(other.covariance[i][i] - made.covariance[k][k], 0.0)
            apart = other.values[i] - made.values[k]
            # where the other one does not tell its width, its value counts all the same
            wide[k][k] += share * ((wider if math.isfinite(wider) else 0.0) + apart**2)
    return replace(made, covariance=tuple(tuple(row) for row in wide))


def _weights(fits: Sequence[Fit]) -> list[float]:
    """Of all fits, 1 together; where noise lasts in the first, fewer readings are apart."""
    import numpy as np

    _, lasting = inflation([np.array(track) for track in fits[0].residuals])
    marks = []
    for one in fits:
        readings = sum(map(len, one.residuals))
        marks.append(-0.5 * readings / lasting * math.log(one.squares) - len(one.unknowns))
    weights = [math.exp(mark - max(marks)) for mark in marks]
    return [weight / sum(weights) for weight in weights]
