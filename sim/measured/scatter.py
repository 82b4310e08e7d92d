"""How far readings usually lie off, told so that a few wild ones do not count."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

OF_MEDIAN = 1.4826
"""Standard deviations of normal errors in the median of their sizes: 1/Φ⁻¹(3/4)."""


def scatter_of(errors: Floats) -> float:
    """The standard deviation of the bulk of these errors around 0."""
    import numpy as np

    return OF_MEDIAN * float(np.median(np.abs(errors)))


def noise_of(places: Floats) -> float:
    """m. Of one place on an even way, told by third differences (of white noise their variance is
    1 + 9 + 9 + 1)."""
    import numpy as np

    return scatter_of(np.diff(places, 3)) / math.sqrt(20.0)
