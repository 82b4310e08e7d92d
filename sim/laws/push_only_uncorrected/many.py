"""push-only-uncorrected, for many contacts at once."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sim.laws import many_dampings
from sim.laws.many import PerSpeed
from sim.laws.push_only.many import pushing

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]


def figures(k: Values, e: Values, mu: Values) -> PerSpeed:
    """Until the force is zero, damping of the printed formula."""
    d, more = many_dampings.delivered(e)
    return pushing(d, k, more, mu)
