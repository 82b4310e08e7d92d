"""Velocities of both carts just before and just after a contact, from readings outside of it.

Four sides (two carts, before and after), each with its own place and velocity at the middle of the
contact, and what brakes the carts, in steps of a ladder:

    nothing     x = x0 + v τ
    friction    − g_k sign(v) τ²/2   one g for each cart
    tilt        + a τ²/2             one a for all
    drag        − c_k v τ²/2         one c for each cart (to first order in τ)

A step is judged by readings it has not seen: the third of each side that is next to the contact is
left out, predicted, and compared. Least squares with Huber's loss, linear in all numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from sim.measured.events.contacts import Contact
from sim.measured.events.correlated import inflation
from sim.measured.events.segments import Segment
from sim.measured.refusal import FitError
from sim.measured.track import Track

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

Step = Literal["nothing", "friction", "tilt", "drag"]
STEPS: tuple[Step, ...] = ("nothing", "friction", "tilt", "drag")
LONGEST = 0.9
"""s. Farther from the contact the model of a constant brake costs more than readings give."""

FEWEST = 4
"""Readings of one side."""

JUMP = 0.25
"""Of the greatest speed. Two segments whose velocities differ by more have a push between them."""

SHARES = (1.0, 0.75, 0.5)
"""Of each side's window: how far the velocities depend on it is part of their uncertainty."""

AS_GOOD = 1.08
"""A step that predicts nearly as well might be the true one: its velocities count too. Of few
readings the errors themselves are uncertain, see `_chance`."""

UNSEEN = 0.7
"""Of what brakes a cart from the edge of a contact to its middle: taken as a standard deviation,
for a brake that is seen outside of the contact need not be the same inside of it."""

NEAREST = 0.3
"""Share of each side that is left out and predicted."""

BETTER = 0.95
"""A step is taken if what it predicts is nearer by this factor than what simpler ones do."""

HUBER = 1.5
"""Robust standard deviations beyond which a reading counts less."""

Side = tuple[Any, Any]
"""Seconds after the middle of the contact, and metres: arrays."""


@dataclass(frozen=True, slots=True)
class Speeds:
    """v = (A before, B before, A after, B after) in m/s at the middle of the contact."""

    v: tuple[float, float, float, float]
    covariance: tuple[tuple[float, ...], ...]
    places: tuple[float, float, float, float]  # m, at the same instant
    step: Step
    held_out: tuple[tuple[Step, float], ...]  # m, root mean square
    alike: float  # correlation of neighbouring residuals


def sides_of(
    tracks: tuple[Track, Track], contact: Contact, named: Sequence[Segment]
) -> tuple[Side, Side, Side, Side]:
    """Readings of each side, up to where a hand or a stop begins; raises FitError."""
    import numpy as np

    listed = []
    for after in (False, True):
        for cart, track in enumerate(tracks):
            low, high = window(contact, [s for s in named if s.cart == cart], after)
            t, x = np.array(track.t), np.array(track.value)
            kept = (t >= low) & (t <= high)
            if int(kept.sum()) < FEWEST:
                when = "after" if after else "before"
                raise FitError(
                    f"only {int(kept.sum())} readings of {track.name} lie {when} the contact and "
                    "free of hands and stops",
                    "let the carts run on for half a second, or choose another contact",
                    "after-too-short" if after else "before-too-short",
                )
            listed.append((t[kept] - contact.middle, x[kept]))
    return listed[0], listed[1], listed[2], listed[3]


def window(
    contact: Contact, named: Sequence[Segment], after: bool, longest: float = LONGEST
) -> tuple[float, float]:
    """s. The stretch beside the contact in which the cart is left alone; `named`: of this cart."""
    free = ("rest", "coasting", "friction")
    greatest = max((abs(v) for one in named for v in one.speeds if one.kind in free), default=0.0)
    low = high = contact.end if after else contact.begin
    speed = None
    for one in named if after else reversed(named):
        near, far = (one.begin, one.end) if after else (one.end, one.begin)
        if (near < contact.end - 1e-9) if after else (near > contact.begin + 1e-9):
            continue
        first, last = one.speeds if after else one.speeds[::-1]
        jumps = speed is not None and abs(first - speed) > JUMP * greatest
        if one.kind not in free or jumps:
            break
        low, high, speed = min(low, far), max(high, far), last
    return max(low, contact.begin - longest), min(high, contact.end + longest)


def speeds_of(sides: Sequence[Side]) -> Speeds:
    """The velocities by the step of the ladder that predicts best; raises FitError."""
    import numpy as np

    errors = [(step, _held_out(sides, step)) for step in STEPS]
    best, chance = STEPS[0], _chance(sides)
    for step, error in errors:
        if error < min(BETTER, 1.0 - chance) * dict(errors)[best]:
            best = step
    least = dict(errors)[best]
    found = [_solved([_nearest(side, share) for side in sides], best) for share in SHARES]
    whole, covariance, alike = found[0]
    v = np.array([one[0][1:8:2] for one in found])
    spread = v - v.mean(axis=0)
    mean = v.mean(axis=0)
    others = [
        step
        for step, error in errors
        if step != best and error < max(AS_GOOD, 1.0 + chance) * least
    ]
    apart = np.array([_solved(sides, step)[0][1:8:2] - whole[1:8:2] for step in others])
    total = covariance[1:8:2, 1:8:2] + spread.T @ spread / (len(SHARES) - 1)
    total += 0.25 * apart.T @ apart / len(others) if others else 0.0  # as likely as the best
    total[np.diag_indices(4)] += (UNSEEN * _braked(sides, best, whole)) ** 2
    return Speeds(
        v=tuple(map(float, mean)),  # type: ignore[arg-type]
        covariance=tuple(tuple(map(float, row)) for row in total),
        places=tuple(map(float, whole[0:8:2])),  # type: ignore[arg-type]
        step=best,
        held_out=tuple(errors),
        alike=alike,
    )


def _braked(sides: Sequence[Side], step: Step, numbers: Floats) -> Floats:
    """m/s. What each velocity changes by from the edge of the contact to its middle."""
    import numpy as np

    slopes = numbers[1:8:2]
    brakes = {
        "nothing": np.zeros(4),
        "friction": -np.sign(slopes) * np.tile(numbers[8:10], 2) if step == "friction" else 0.0,
        "tilt": np.full(4, numbers[8]) if step == "tilt" else 0.0,
        "drag": -slopes * np.tile(numbers[8:10], 2) if step == "drag" else 0.0,
    }[step]
    return np.asarray(brakes * np.array([np.min(np.abs(tau)) for tau, _ in sides]))


def _nearest(side: Side, share: float) -> Side:
    """The part of a side that is nearest to the contact; at least FEWEST readings."""
    import numpy as np

    tau, x = side
    order = np.argsort(np.abs(tau))
    kept = np.sort(order[: max(min(FEWEST, len(tau)), round(share * len(tau)))])
    return tau[kept], x[kept]


def _chance(sides: Sequence[Side]) -> float:
    """Relative standard deviation of a root mean square of the readings that are predicted."""
    return float((2.0 * NEAREST * sum(len(tau) for tau, _ in sides)) ** -0.5)


def _held_out(sides: Sequence[Side], step: Step) -> float:
    """m. Root mean square of what the third next to the contact is missed by."""
    import numpy as np

    far, near = [], []
    for tau, x in sides:
        order = np.argsort(np.abs(tau))
        count = max(1, round(NEAREST * len(tau)))
        count = min(count, len(tau) - 3)
        far.append((tau[np.sort(order[count:])], x[np.sort(order[count:])]))
        near.append((tau[order[:count]], x[order[:count]]))
    numbers = _solved(far, step)[0]
    missed = _design(near, step, _slopes(far)) @ numbers - np.concatenate([x for _, x in near])
    return float(np.sqrt(np.mean(missed**2)))


def _slopes(sides: Sequence[Side]) -> list[float]:
    import numpy as np

    return [float(np.polyfit(tau, x, 1)[0]) for tau, x in sides]


def _design(sides: Sequence[Side], step: Step, slopes: Sequence[float]) -> Floats:
    import numpy as np

    extra = {"nothing": 0, "friction": 2, "tilt": 1, "drag": 2}[step]
    total = sum(len(tau) for tau, _ in sides)
    matrix, row = np.zeros((total, 8 + extra)), 0
    for k, (tau, _) in enumerate(sides):
        rows, cart = slice(row, row + len(tau)), k % 2
        matrix[rows, 2 * k], matrix[rows, 2 * k + 1] = 1.0, tau
        bend = 0.5 * tau * tau
        if step == "tilt":
            matrix[rows, 8] = bend
        elif step == "friction":
            matrix[rows, 8 + cart] = -np.sign(slopes[k]) * bend
        elif step == "drag":
            matrix[rows, 8 + cart] = -slopes[k] * bend
        row += len(tau)
    return matrix


def _solved(sides: Sequence[Side], step: Step) -> tuple[Floats, Floats, float]:
    """Numbers, covariance and correlation of neighbours; Huber's loss by weights."""
    import numpy as np

    matrix = _design(sides, step, _slopes(sides))
    x = np.concatenate([side[1] for side in sides])
    weight, numbers = np.ones(len(x)), np.zeros(matrix.shape[1])
    for _ in range(8):
        root = np.sqrt(weight)
        numbers = np.linalg.lstsq(matrix * root[:, None], x * root, rcond=None)[0]
        left = x - matrix @ numbers
        scale = max(1.4826 * float(np.median(np.abs(left))), 1e-12)
        weight = np.minimum(1.0, HUBER * scale / np.maximum(np.abs(left), 1e-300))
    freedom = max(len(x) - matrix.shape[1], 1)
    noise = float(np.sum(weight * left**2)) / freedom
    covariance = noise * np.linalg.pinv((matrix * weight[:, None]).T @ matrix)
    cuts = np.cumsum([len(tau) for tau, _ in sides])[:-1]
    alike, more = inflation(np.split(left, cuts))
    return numbers, covariance * more, alike
