"""The readings of a standing cart are tidier than those of a moving one, and tell nothing of these.

A compressed film repeats the picture of what stands still: on made films (H.264, crf 20) its mark
is off by 0.07 mm, a moving one by 0.25 mm. One size of noise for all readings then comes out too
small for the few frames of the contact, and the stiffness and the instant of the touch are told too
surely; for the velocity of the standing cart it is too large. So where a cart that stands before
the touch is clearly tidier, its readings have a size of noise of their own.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from sim.measured.model.motion import Parameters

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Both = tuple[Floats, Floats]

STANDS = 0.02
"""Share of the approach below which a cart stands."""

TIDIER = 0.5
"""Times the noise of the moving ones. Of eight readings with one noise 2 in 100 are so tidy."""

TIDIEST = 1e-3
"""Times that. One number again and again, as a device of whole steps or somebody who types writes
it, has no noise at all: what counts still less makes the sums of all others rounding."""

FEWEST = 8


def sizes_of(residuals: Both, t: Both, p: Parameters) -> Both:
    """Of each reading's noise, as a share of that of the moving ones: below 1 where a standing cart
    is clearly tidier, else 1. `residuals` in m."""
    import numpy as np

    stands = tuple(
        (times < p.touch) & (abs(v) < STANDS * p.approach) for times, v in zip(t, p.v, strict=True)
    )
    still = np.concatenate([r[k] for r, k in zip(residuals, stands, strict=True)])
    moving = np.concatenate([r[~k] for r, k in zip(residuals, stands, strict=True)])
    share = 1.0
    if len(still) >= FEWEST and len(moving) >= FEWEST:
        tidy, usual = (math.sqrt(float(np.mean(part**2))) for part in (still, moving))
        share = max(TIDIEST, tidy / usual) if tidy < TIDIER * usual else 1.0
    first, second = (np.where(k, share, 1.0) for k in stands)
    return first, second
