"""paper, for many contacts at once."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from sim.laws import many_dampings
from sim.laws.many import PerSpeed
from sim.laws.many_dampings import dashpot

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]


def figures(k: Values, e: Values, mu: Values) -> PerSpeed:
    """Until the overlap is zero."""
    import numpy as np

    d, w0 = many_dampings.to_zero_overlap(e), np.sqrt(k / mu)
    force, overlap = dashpot(d, k, mu, w0)
    return PerSpeed(e, math.pi / (w0 * d.sine), force, overlap, np.zeros(()))
