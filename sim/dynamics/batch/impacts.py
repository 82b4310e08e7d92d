"""Isolated contacts of two carts, or of a cart and a wall, any number of them in one call.

    v' = V + e (V − v)      impulse J = mu (u + u')      warmed = mu u² (1 − e²)/2

The same formulas, in the same order of operations, as `impact.outgoing` and the laws'
`IsolatedContact`: velocities agree with a single run to the last bit, everything else within a few
units in the last place (numpy's logarithm and its friends differ there from Python's). Masses in
kg, velocities in m/s, + to the right, k in N/m. Arguments may be numbers or arrays of shapes that
broadcast: a grid over mass and restitution works on a row and a column as long as it can. Columns
of some thousand contacts are fastest (25 ns each): the forty intermediate ones then stay in the
cache.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from sim.laws.many import PerSpeed, figures_of_many
from sim.scene.laws import laws

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Impacts:
    """What each contact comes to, from first touch at approach speed u > 0.

    A contact without duration has no greatest force: inf. One that never separates lasts inf.
    """

    v1: Values  # m/s, of the left body afterwards; 0 for a wall
    v2: Values  # m/s, of the right body
    impulse: Values  # N s, −J on the left body and +J on the right one
    duration: Values  # s
    force: Values  # N, the greatest
    overlap: Values  # m, the greatest
    residual_overlap: Values  # m, overlap at separation
    warmed: Values  # J, into the bumpers


def impacts(
    law: str,
    m1: Values | float | None,
    m2: Values | float | None,
    v1: Values | float,
    v2: Values | float,
    e: Values | float | None,
    k: Values | float | None,
    u: Values | float | None = None,
) -> Impacts:
    """The outcome of every contact; a mass None is a wall.

    `law`: one that has a closed form for many, or none in time. `u` [m/s]: approach
    speeds, where they are known better than v1 − v2 in floating point.
    """
    import numpy as np

    first, second = np.asarray(v1, dtype=float), np.asarray(v2, dtype=float)
    u = np.asarray(first - second if u is None else u, dtype=float)
    mu = reduced_mass(m1, m2)
    kind = laws()[law]
    joins, sudden = kind.restitution is None, kind.stiffness is None
    asked = np.zeros(()) if joins else np.asarray(e, dtype=float)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        if sudden:
            none = np.zeros(())
            per = PerSpeed(asked, none, np.asarray(math.inf), none, none)
            impulse = mu * (1.0 + asked) * u
        else:
            per = figures_of_many(law)(np.asarray(k, dtype=float), asked, mu)
            impulse = mu * (u + per.e * u)
        if joins and m1 is not None and m2 is not None:
            common = (m1 * first + m2 * second) / (np.asarray(m1) + m2)
            after = common, common
        else:
            after = velocities_after(m1, m2, first, second, per.e)
        return Impacts(
            *after,
            impulse=impulse,
            duration=per.duration,
            force=per.force * u,
            overlap=per.overlap * u,
            residual_overlap=per.residual_overlap * u,
            warmed=0.5 * mu * u * u * (1.0 - per.e) * (1.0 + per.e),
        )


def reduced_mass(m1: Values | float | None, m2: Values | float | None) -> Values:
    """kg; at a wall the cart's own mass."""
    import numpy as np

    if m1 is None or m2 is None:
        return np.asarray(m2 if m1 is None else m1, dtype=float)
    a: Values = np.asarray(m1, dtype=float)
    b: Values = np.asarray(m2, dtype=float)
    return a * b / (a + b)


def velocities_after(
    m1: Values | float | None, m2: Values | float | None, v1: Values, v2: Values, e: Values
) -> tuple[Values, Values]:
    """m/s. `pair_laws.velocities_after` for arrays."""
    import numpy as np

    if m1 is None:
        return np.zeros(()), 0.0 - e * v2
    if m2 is None:
        return 0.0 - e * v1, np.zeros(())
    return outgoing(np.asarray(m1, dtype=float), np.asarray(m2, dtype=float), v1, v2, e)


def outgoing(m1: Values, m2: Values, v1: Values, v2: Values, e: Values) -> tuple[Values, Values]:
    """m/s. `impact.outgoing` for arrays, bit for bit: seen from the heavier of the two."""
    import numpy as np

    u = v1 - v2
    part = v1 - u
    lost = (v1 - (u + part)) + (part - v2)  # what rounding took from u (two-sum)
    left_heavier = m1 > m2
    total = m1 + m2
    light = np.minimum(m1, m2)
    change, more = light * u / total, light * lost / total
    heavy = np.where(left_heavier, v1, v2)
    signed = np.where(left_heavier, -change, change)
    centre = heavy + signed
    part = centre - heavy
    rest = (heavy - (centre - part)) + (signed - part) + np.where(left_heavier, -more, more)
    near, far = e * (change + more), e * (u - change + lost)
    return (
        centre + (rest - np.where(left_heavier, near, far)),
        centre + (rest + np.where(left_heavier, far, near)),
    )
