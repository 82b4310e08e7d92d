"""scipy's DOP853, imported where a scene calls for it, and its dense output as polynomials.

Source: Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations I, II.6.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from sim.dynamics.motion.power_series.polynomial import Poly
from sim.dynamics.result.outcome import UnsolvedError
from sim.scene.said import said


def scipy_method() -> tuple[Any, Any]:
    """numpy, and the method; refused in words where a page does not carry them."""
    try:
        import numpy
        from scipy.integrate import DOP853
    except ImportError as missing:
        raise UnsolvedError(
            said(
                "a contact law without a formula needs the packages numpy and scipy, which this "
                "page does not carry"
            ),
            said("write packages: [scipy] into the scene block"),
            0.0,
            (),
        ) from missing
    return numpy, DOP853


def polynomials(solver: Any) -> list[Poly]:
    """Dense output of the last step as coefficients of 1, t, t² …, one list per component.

    scipy keeps y = y0 + x (F0 + (1 − x)(F1 + x (F2 + …))), x = t/h.
    """
    import numpy

    dense = solver.dense_output()
    total = dense.F.T @ numpy.array(_basis(len(dense.F)))
    total[:, 0] += dense.y_old
    scaled = total * dense.h ** -numpy.arange(total.shape[1], dtype=float)
    return [list(row) for row in scaled.tolist()]


@lru_cache(maxsize=4)
def _basis(count: int) -> tuple[tuple[float, ...], ...]:
    """x, x (1 − x), x² (1 − x) … by their coefficients: whole numbers."""
    found = []
    product = [0.0, 1.0]
    for place in range(count):
        found.append((*product, *(0.0 for _ in range(count + 1 - len(product)))))
        longer = [0.0, *product]
        if place % 2 == 0:  # times 1 − x
            longer = [a - b for a, b in zip([*product, 0.0], longer, strict=True)]
        product = longer
    return tuple(found)
