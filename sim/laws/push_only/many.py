"""push-only, for many contacts at once."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sim.laws import many_dampings
from sim.laws.many import PerSpeed

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]


def figures(k: Values, e: Values, mu: Values) -> PerSpeed:
    """Until the force is zero, damping corrected."""
    return pushing(many_dampings.to_zero_force(e), k, e, mu)


def pushing(d: many_dampings.Dampings, k: Values, e: Values, mu: Values) -> PerSpeed:
    """Until the force is zero; `e` is what is delivered."""
    import numpy as np

    w0 = np.sqrt(k / mu)
    force, overlap = many_dampings.dashpot(d, k, mu, w0)
    return PerSpeed(e, 2.0 / (w0 * d.sinc), force, overlap, 2.0 * d.zeta * e / w0)
