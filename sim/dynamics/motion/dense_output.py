"""scipy's DOP853, imported where a scene calls for it, and its dense output as polynomials.

Source: Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations I, II.6.
"""

from __future__ import annotations

from typing import Any

from sim.dynamics.motion.polynomial import Poly
from sim.dynamics.result.outcome import UnsolvedError


def scipy_method() -> tuple[Any, Any]:
    """numpy, and the method; refused in words where a page does not carry them."""
    try:
        import numpy
        from scipy.integrate import DOP853
    except ImportError as missing:
        raise UnsolvedError(
            "the contact law hertz needs the packages numpy and scipy, which this page does not "
            "carry",
            "write packages: [scipy] into the scene block",
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
    total = numpy.zeros((len(dense.y_old), 1))
    for place, term in enumerate(reversed(dense.F)):
        total[:, 0] += term
        longer = numpy.zeros((len(total), total.shape[1] + 1))
        longer[:, 1:] = total if place % 2 == 0 else -total
        if place % 2:
            longer[:, :-1] += total
        total = longer
    total[:, 0] += dense.y_old
    scale = dense.h ** -numpy.arange(total.shape[1], dtype=float)
    return [[float(c) for c in row] for row in total * scale]
