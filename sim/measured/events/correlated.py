"""How much wider an interval is where neighbouring residuals are alike.

Residuals as a chain with correlation rho from one to the next (AR(1)): the variance of what a
smooth model makes of them is that of white residuals times (1 + rho)/(1 − rho). A block bootstrap
gives the same within its own scatter, for longer blocks than a side of a film often has.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

MOST = 0.97
"""rho. Above it a side holds hardly one independent residual: then the window tells more."""


def inflation(parts: Sequence[Floats]) -> tuple[float, float]:
    """rho of all parts together, and by what a variance grows (at least 1)."""
    above = sum(float(part[1:] @ part[:-1]) for part in parts)
    below = sum(float(part @ part) for part in parts)
    rho = above / below if below > 0.0 else 0.0
    kept = min(max(rho, 0.0), MOST)
    return rho, (1.0 + kept) / (1.0 - kept)
