"""What readings that a device or a table has rounded can tell.

Rounded to steps q, a reading errs by up to q/2. Where noise lies over it, or where a cart crosses
steps unevenly, these errors are as good as chance, with the standard deviation q/√12. A cart that
rests, or covers a whole number of steps in every m readings, errs alike again and again: its
readings may lie on a line that is not its own, off by up to q/(2 m), and no mean tells. Their m
errors lie q/m apart, so their standard deviation s shows it:

    s² = (q²/12) (1 − 1/m²) ,   1/m = √(1 − 12 s²/q²) ;   for chance 1/m = 0, at rest 1/m = 1.

An estimate that is linear in the readings, with the weights p_k, is wrong by up to (q/2m) Σ |p_k|.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

EVEN = 12**-0.5
"""Steps. Standard deviation of an error of which all values up to half a step are as likely."""

BOUND = 3**-0.5
"""Of the largest error. Standard deviation where all values up to that are as likely."""

SAME = 1e-9
"""Of the reach of all readings. Closer ones differ by the rounding of a conversion."""

WHOLE = 0.02
"""Steps. So near to a whole number of steps lies whatever is rounded to them."""

SHARES = 5
"""The least difference of two readings is looked at as so many steps, and fewer."""


EVENLY = 0.1
"""Share of the steps that may differ from the one before, of a cart that goes evenly."""

DECIMALS = 7
"""Of readings as they are written, in m; more are those of a program, and no rounding."""


def step_of(values: Floats) -> float:
    """m. The step to which all these readings, in the order of time, are rounded; 0 where there is
    none. The way of a cart from frame to frame is no such step, where more decimals tell it."""
    step = common_step(values.tolist())
    return min(step, _decimal(values)) if _goes_evenly(values, step) else step


def _goes_evenly(values: Floats, step: float) -> bool:
    """Whether a cart goes as many steps in each frame, as one does whose readings are exact."""
    import numpy as np

    if step == 0.0:
        return False
    counts = np.round(np.diff(values) / step)
    moving = (counts[1:] != 0) & (counts[:-1] != 0)
    changes = counts[1:][moving] != counts[:-1][moving]
    return bool(len(changes)) and float(np.mean(changes)) <= EVENLY


def _decimal(values: Floats) -> float:
    """m. Of the last decimal that is written; 0 where there are too many."""
    import numpy as np

    for places in range(DECIMALS):
        shown = values * 10.0**places
        if np.all(np.abs(shown - np.round(shown)) < WHOLE):
            return float(10.0**-places)
    return 0.0


def common_step(values: Sequence[float]) -> float:
    """What all differences are whole numbers of; 0 where there is nothing. Without numpy, for
    pages that compare forces."""
    told = sorted(set(values))
    near = SAME * (told[-1] - told[0]) if told else 0.0
    gaps = [b - a for a, b in itertools.pairwise(told) if b - a > near]
    least = min(gaps, default=0.0)
    for share in range(1, SHARES + 1 if gaps else 1):
        counts = [gap * share / least for gap in gaps]
        whole = [round(count) for count in counts]
        if all(abs(c - w) < WHOLE * share for c, w in zip(counts, whole, strict=True)):
            return math.fsum(gaps) / sum(whole)
    return 0.0


def unseen(weights: Floats, left: Floats, step: float) -> Floats:
    """Standard deviations that rounding adds to estimates, a row of `weights` for each of them.

    `left`: the residuals of the readings that `weights` are for, in m.
    """
    import numpy as np

    if not len(left) or step == 0.0:
        return np.zeros(len(weights))
    alike = math.sqrt(max(0.0, 1.0 - float(np.mean(left**2)) / (EVEN * step) ** 2))
    return np.asarray(BOUND * 0.5 * step * alike * np.sum(np.abs(weights), axis=1))
