"""Three bodies that touch, hit in turn in the two gaps between them: does that ever end?

With u the approach in gap a, x u the speed at which gap b opens, y = alpha − x, and alpha, beta
what an impact in the one gap takes from the other's rate per approach speed, one round makes

    u → (beta y − e_a) u ,     y → alpha − e_b y/(beta y − e_a)

a Möbius map. They hit infinitely often if and only if it has fixed points and y is above the lower,
repelling one; then they end at their common velocity whatever is between. Equal masses and e:
(1 + e)² >= 16 e, McNamara and Young's limit (Phys. Fluids A 4 (1992) 496).
"""

from __future__ import annotations

import math
from collections.abc import Sequence

CLEARLY = 1.0 + 1e-6
"""Above the repelling fixed point by so much: near it the number of rounds is rounding's choice."""


def for_ever(
    inverse: Sequence[float], closing: Sequence[float], restitution: Sequence[float]
) -> bool:
    """Are they hit infinitely often, once the first of the two gaps has been?

    `inverse`: 1/kg of the bodies, the one in both gaps in the middle; 0 for a wall. `closing`: m/s
    in the first gap, above 0, and in the second.
    """
    here, there = restitution
    middle = inverse[1]
    if middle == 0.0 or closing[0] <= 0.0:
        return False
    alpha = middle / (inverse[0] + middle) * (1.0 + here)
    beta = middle / (middle + inverse[2]) * (1.0 + there)
    half = 0.5 * (here + alpha * beta - there)
    root = half * half - alpha * beta * here
    if root <= 0.0 or half <= 0.0:
        return False
    repelling = (half - math.sqrt(root)) / beta
    y = alpha + closing[1] / closing[0]
    return y > CLEARLY * repelling and beta * y > CLEARLY * here


def at_once_for_ever(
    inverse: Sequence[float], closing: Sequence[float], restitution: Sequence[float]
) -> bool:
    """Whether the two gaps are hit infinitely often, whichever is hit first.

    Inverse masses [1/kg], closing speeds [m/s], restitutions.
    """
    back = inverse[::-1], closing[::-1], restitution[::-1]
    return for_ever(inverse, closing, restitution) and for_ever(*back)
