"""How strongly the dashpot laws are damped, for many restitutions at once.

The formulas and their edge cases are those of `sim.laws.dashpot`; here q = phi² is an
array, negative beyond critical damping, and Newton's method runs on all of it together.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from sim.laws.dashpot import SERIES_BELOW, q_cot_near_nought

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]

QUARTER_TURN_SQUARED = (math.pi / 2) ** 2
"""phi² without damping, e = 1."""

MOST_STEPS = 12
CONVERGED = 1e-9
"""Relative. Newton's method doubles the digits of every step: after one this small nothing is left
but rounding. Four or five steps do it."""


@dataclass(frozen=True, slots=True)
class Dampings:
    """zeta, sin(phi)/phi and sin(phi), with phi = i y beyond critical damping."""

    square: Values
    zeta: Values
    sinc: Values
    sine: Values


def to_zero_overlap(e: Values) -> Dampings:
    """Damping that returns e when the contact ends at overlap zero; e = 0 is critical."""
    import numpy as np

    with np.errstate(divide="ignore"):
        return _dampings(np.arctan2(math.pi, -np.log(e)) ** 2, e)


def to_zero_force(e: Values) -> Dampings:
    """Damping that returns e > 0 when the contact ends at force zero: phi cot phi = −ln(e)/2."""
    import numpy as np

    wanted = -0.5 * np.log(e)
    q = np.where(wanted < 2.0, QUARTER_TURN_SQUARED * (1.0 - wanted), -wanted * wanted)
    for _ in range(MOST_STEPS):
        value, slope = _q_cot(q)
        step = (value - wanted) / slope
        q = q - step
        if np.all(np.abs(step) <= CONVERGED * np.maximum(np.abs(q), 1e-3)):
            break
    return _dampings(q, e)


def delivered(e: Values) -> tuple[Dampings, Values]:
    """The printed formula's damping and what it delivers when the force may only push."""
    import numpy as np

    d = to_zero_overlap(e)
    return d, np.exp(-2.0 * d.zeta / d.sinc)


def _dampings(square: Values, e: Values) -> Dampings:
    """From phi²; at e = 1 exactly undamped, at phi = 0 exactly critical."""
    import numpy as np

    phi = np.sqrt(np.abs(square))
    over = square < 0.0
    y = np.where(over, phi, 0.0)  # no overflow in the branch that is not taken
    zeta = np.where(over, np.cosh(y), np.cos(phi))
    sine = np.where(over, np.sinh(y), np.sin(phi))
    sinc = np.divide(sine, phi, out=np.ones_like(phi), where=phi > 0.0)
    free = np.equal(e, 1.0)
    return Dampings(
        square,
        np.where(free, 0.0, zeta),
        np.where(free, 2.0 / math.pi, sinc),
        np.where(free, 1.0, sine),
    )


def _q_cot(q: Values) -> tuple[Values, Values]:
    """f(q) = sqrt(q) cot sqrt(q) and df/dq, for q of either sign."""
    import numpy as np

    near = np.abs(q) < SERIES_BELOW
    f, df = q_cot_near_nought(q)
    far = np.where(near, 1.0, q)
    phi, sign = np.sqrt(np.abs(far)), np.sign(far)
    cot = 1.0 / np.where(far > 0.0, np.tan(phi), np.tanh(phi))
    value = phi * cot
    slope = 0.5 * sign * (cot / phi - sign - cot * cot)
    return np.where(near, f, value), np.where(near, df, slope)


def dashpot(d: Dampings, k: Values, mu: Values, w0: Values) -> tuple[Values, Values]:
    """Greatest force [N] and overlap [m] at 1 m/s. With zeta >= 1/2 the force only falls."""
    import numpy as np

    angle = 3.0 * np.sqrt(np.maximum(d.square, 0.0)) - math.pi
    fade = np.exp(-d.zeta / np.where(d.sine > 0.0, d.sine, 1.0) * angle)
    factor = np.where(d.zeta >= 0.5, 2.0 * d.zeta, fade)
    return np.sqrt(k * mu) * factor, np.exp(-d.zeta / d.sinc) / w0
