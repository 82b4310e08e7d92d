"""bumper, for many contacts at once."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from sim.laws.many import PerSpeed

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]


def figures(k: Values, e: Values, mu: Values) -> PerSpeed:
    """Two quarter swings."""
    import numpy as np

    w = np.sqrt(k / mu)
    quarter = 0.5 * math.pi / w
    return PerSpeed(e, quarter * (1.0 + e), np.sqrt(k * mu), 1.0 / w, (1.0 - e * e) / w)
