"""Four sides of a contact and what brakes the carts there: a linear least-squares problem.

See `sides` for the four formulas.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal

from sim.measured.events.correlated import inflation
from sim.measured.events.stretch import STILL
from sim.measured.rounding import EVEN, step_of, unseen
from sim.measured.scatter import scatter_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

Step = Literal["nothing", "friction", "tilt", "drag", "both"]
STEPS: tuple[Step, ...] = ("nothing", "friction", "tilt", "drag", "both")
ROLLS = 4.0
"""Standard deviations of what bends its line: a cart that turns round is slow and does not rest."""

FEWEST = 6
"""Readings of a side that tell how it is braked: twice what a parabola has numbers."""

ALIKE = 3.0
"""Standard deviations up to which a cart is braked alike before and after: friction does so, and
what goes with the speed does not."""

HUBER = 1.5
"""Robust standard deviations beyond which a reading counts less."""

UNSEEN = 0.7
"""Of what brakes a cart from the edge of a contact to its middle: taken as a standard deviation,
for a brake that is seen outside of the contact need not be the same inside of it."""

Side = tuple[Any, Any]
"""Seconds after the middle of the contact, and metres: arrays."""


def slopes_of(sides: Sequence[Side]) -> list[float]:
    """m/s. Of straight lines, for the sign of friction and the size of drag."""
    import numpy as np

    return [float(np.polyfit(tau, x, 1)[0]) for tau, x in sides]


def steps_of(sides: Sequence[Side]) -> tuple[Step, ...]:
    """The steps that may be true: a tilt that moves one cart leaves no other at rest before the
    contact, unless friction holds it (`both`)."""
    import numpy as np

    slopes = slopes_of(sides)
    for slope, side in zip(slopes[:2], sides, strict=False):
        if abs(slope) >= STILL * max(map(abs, slopes)):
            continue
        (bend, *_), covariance = np.polyfit(*side, 2, cov=True)
        if not bend**2 > ROLLS**2 * covariance[0, 0]:
            return tuple(step for step in STEPS if step != "tilt")
    return STEPS


def braked_alike(sides: Sequence[Side]) -> bool:
    """Whether no cart is braked otherwise before the contact than after it, for all that readings
    tell: a parabola through each side."""
    import numpy as np

    slopes, brakes = slopes_of(sides), list[tuple[float, float]]()
    for slope, (tau, x) in zip(slopes, sides, strict=True):
        rests = abs(slope) < STILL * max(map(abs, slopes))
        if rests or len(tau) < FEWEST:
            brakes.append((0.0, math.inf))
            continue
        numbers = np.polyfit(tau, x, 2)
        left = x - np.polyval(numbers, tau)
        basis = np.linalg.inv(np.vander(tau, 3).T @ np.vander(tau, 3))
        noise = float(left @ left) / (len(tau) - 3) * inflation([left])[1]
        brakes.append((-2.0 * float(numbers[0]) * math.copysign(1.0, slope),
                       4.0 * noise * float(basis[0, 0])))  # fmt: skip
    return all(
        (brakes[k][0] - brakes[k + 2][0]) ** 2 <= ALIKE**2 * (brakes[k][1] + brakes[k + 2][1])
        for k in range(2)
    )


def design(sides: Sequence[Side], step: Step, slopes: Sequence[float]) -> Floats:
    """A row for each reading: place and velocity of its side, and what brakes."""
    import numpy as np

    extra = {"nothing": 0, "friction": 2, "tilt": 1, "drag": 2, "both": 3}[step]
    total = sum(len(tau) for tau, _ in sides)
    fastest = max(map(abs, slopes))
    # Friction does not brake what stands, and the sign of a velocity that is noise is chance.
    ways = [0.0 if abs(v) < STILL * fastest else math.copysign(1.0, v) for v in slopes]
    matrix, row = np.zeros((total, 8 + extra)), 0
    for k, (tau, _) in enumerate(sides):
        rows, cart = slice(row, row + len(tau)), k % 2
        matrix[rows, 2 * k], matrix[rows, 2 * k + 1] = 1.0, tau
        bend = 0.5 * tau * tau
        if step == "tilt":
            matrix[rows, 8] = bend
        elif step in ("friction", "both"):
            matrix[rows, 8 + cart] = -ways[k] * bend
        elif step == "drag":
            matrix[rows, 8 + cart] = -slopes[k] * bend
        if step == "both":  # friction holds what rests
            matrix[rows, 10] = abs(ways[k]) * bend
        row += len(tau)
    return matrix


def braked_unseen(sides: Sequence[Side], step: Step, numbers: Floats) -> Floats:
    """m/s, standard deviations. Of what each velocity changes by from the edge of the contact to
    its middle."""
    import numpy as np

    if step == "nothing":
        return np.zeros(4)
    bends = [(np.array([1.0]), np.zeros(1))] * 4  # of the design: what brakes times τ²/2, at 1 s
    brakes = 2.0 * design(bends, step, list(numbers[1:8:2]))[:, 8:] @ numbers[8:]
    return np.asarray(UNSEEN * brakes * np.array([np.min(np.abs(tau)) for tau, _ in sides]))


def stood_unseen(sides: Sequence[Side], numbers: Floats, covariance: Floats) -> Floats:
    """m/s, standard deviations. Of what a cart that came may have had after the contact though it
    stands in every reading: its friction takes that before the first one. `numbers` and
    `covariance` of the step "friction"."""
    import numpy as np

    slopes, found = slopes_of(sides), np.zeros(4)
    for k in (2, 3):
        if abs(slopes[k]) < STILL * max(map(abs, slopes)) <= abs(slopes[k - 2]):
            brake = math.hypot(numbers[6 + k], covariance[6 + k, 6 + k] ** 0.5)
            found[k] = UNSEEN * brake * float(np.min(np.abs(sides[k][0])))
    return found


def solved(
    sides: Sequence[Side], step: Step, likely: float = math.inf
) -> tuple[Floats, Floats, float]:
    """Numbers, covariance and correlation of neighbours; Huber's loss by weights. No reading counts
    less, and no interval is narrower, than its rounding allows. `likely`: m/s², standard deviation
    of what brakes, known beforehand."""
    import numpy as np

    matrix = design(sides, step, slopes_of(sides))
    x = np.concatenate([side[1] for side in sides])
    lengths = [len(tau) for tau, _ in sides]
    of_cart = [step_of(np.concatenate([side[1] for side in sides[cart::2]])) for cart in range(2)]
    steps = [of_cart[k % 2] for k in range(len(sides))]
    even = EVEN * np.repeat(steps, lengths)
    weight, numbers = np.ones(len(x)), np.zeros(matrix.shape[1])
    known = np.diag(np.repeat([0.0, 1.0 / likely], [8, matrix.shape[1] - 8]))
    held, nought = np.zeros_like(known), np.zeros(len(known))
    for _ in range(8):
        root = np.sqrt(weight)
        rows, right = np.vstack([matrix * root[:, None], held]), np.concatenate([x * root, nought])
        numbers = np.linalg.lstsq(rows, right, rcond=None)[0]
        left = x - matrix @ numbers
        scale = np.maximum(max(scatter_of(left), 1e-12), even)
        weight = np.minimum(1.0, HUBER * scale / np.maximum(np.abs(left), 1e-300))
        held = float(np.sqrt(np.mean(scale**2))) * known
    freedom = max(len(x) - matrix.shape[1], 1)
    noise = max(float(np.sum(weight * left**2)) / freedom, float(np.mean(even**2)))
    inverse = np.linalg.pinv((matrix * weight[:, None]).T @ matrix + held.T @ held)
    cuts = np.cumsum(lengths)[:-1]
    each = np.split(left, cuts)
    alike, more = inflation(each)
    by_reading = np.split(inverse @ (matrix * weight[:, None]).T, cuts, axis=1)
    rounded = list(map(unseen, by_reading, each, steps))
    covariance = noise * more * inverse + np.diag(np.sum(np.square(rounded), axis=0))
    return numbers, covariance, alike
