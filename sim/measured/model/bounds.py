"""How far each unknown of a fit may go: wide enough that only nonsense lies outside."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from sim.measured.model.guess import E_HIGH, E_LOW, RATIO_HIGH

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


def bounds_of(names: Sequence[str], t: Any, x: Any) -> tuple[Floats, Floats]:
    """Wide enough that only nonsense lies outside."""
    import numpy as np

    begin, end = min(t[0][0], t[1][0]), max(t[0][-1], t[1][-1])
    length = end - begin
    frame = float(np.median(np.diff(t[0])))
    reach = max(float(np.ptp(np.concatenate(x))), 1e-9)
    fastest = 50.0 * reach / length
    middle = float(np.mean(np.concatenate(x)))
    limits = {
        "touch": (begin, end),
        "x": (middle - 10.0 * reach, middle + 10.0 * reach),
        "distance": (-10.0 * reach, 10.0 * reach),
        "v1": (-fastest, fastest),
        "v2": (-fastest, fastest),
        "ln_ratio": (-math.log(RATIO_HIGH), math.log(RATIO_HIGH)),
        "e": (E_LOW, E_HIGH),
        "ln_w0": (math.log(1.0 / length), math.log(60.0 / frame)),
        "friction1": (0.0, fastest / length),
        "friction2": (0.0, fastest / length),
        "tilt": (-fastest / length, fastest / length),
    }
    pairs = np.array([limits[name] for name in names])
    return pairs[:, 0], pairs[:, 1]
