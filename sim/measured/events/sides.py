"""Velocities of both carts just before and just after a contact, from readings outside of it.

Four sides (two carts, before and after), each with its own place and velocity at the middle of the
contact, and what brakes the carts, in steps of a ladder:

    nothing     x = x0 + v τ
    friction    − g_k sign(v) τ²/2   one g for each cart
    tilt        + a τ²/2             one a for all
    drag        − c_k v τ²/2         one c for each cart (to first order in τ)
    both        friction and a tilt, which pushes no cart that rests

Where a cart rests before the contact no tilt alone is told (`steps_of`). A step is judged by
readings it has not seen (`rungs`). Least squares with Huber's loss, linear in all numbers
(`brakes`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from sim.measured.events.brakes import (
    STEPS,
    Side,
    Step,
    braked_alike,
    braked_unseen,
    solved,
    steps_of,
    stood_unseen,
)
from sim.measured.events.contacts import Contact
from sim.measured.events.nearer import nearer
from sim.measured.events.rungs import (
    BETTER,
    Rung,
    chance_of,
    held_back,
    missed,
    predictions,
    rungs_of,
    scatter_of,
)
from sim.measured.events.stops import comes_to_rest
from sim.measured.events.stretch import Segment
from sim.measured.refusal import FitError, only
from sim.measured.track import Track
from sim.scene.said import said

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

LONGEST = 0.9
"""s. Farther from the contact the model of a constant brake costs more than readings give."""

FEWEST = 4
"""Readings of one side."""

INSTANT = 1e-9
"""s. Two instants that are one but for rounding."""

JUMP = 0.25
"""Of the greatest speed. Two segments whose velocities differ by more have a push between them."""

MOVED = 0.16
"""Of the greatest speed: a cart that was faster has moved, and its rest is another motion. Of a
slower one a noisy piece of rest may be taken for motion."""

SHARES = (1.0, 0.75, 0.5)
"""Of each side's window: how far the velocities depend on it is part of their uncertainty."""

AS_GOOD = 1.08
"""A step that predicts nearly as well might be the true one: its velocities count too. Of few
readings the errors themselves are uncertain, see `chance_of`."""

HALVED = 0.5
"""Both take three numbers; of less than half of what a single step misses, drag or a track that is
not even may be the cause. Else they only widen what is told."""

FAINT = 0.03
"""m/s². What a track brakes by when nobody sees it: an air track 0.003 to 0.02, bearings 0.05."""


@dataclass(frozen=True, slots=True)
class Speeds:
    """v = (A before, B before, A after, B after) in m/s at the middle of the contact."""

    v: tuple[float, float, float, float]
    covariance: tuple[tuple[float, ...], ...]
    places: tuple[float, float, float, float]  # m, at the same instant
    step: Step
    held_out: tuple[tuple[Step, float], ...]  # m, root mean square
    rungs: tuple[Rung, ...]  # what each step changes, largest first
    scatter: float  # m, root mean square of the readings beside the step that is taken
    alike: float  # correlation of neighbouring residuals
    even: bool = True  # each cart is braked alike before and after, as friction does

    @property
    def approach(self) -> float:
        """m/s. How fast A came nearer to B."""
        return self.v[0] - self.v[1]


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
            kept = (t >= low - INSTANT) & (t <= high + INSTANT)
            # A contact ends in the middle of a cell, which may be a reading: it is pushed still.
            kept &= t > contact.end + INSTANT if after else t < contact.begin - INSTANT
            if after and (rest := comes_to_rest(t[kept], x[kept])) is not None:
                kept &= t <= rest + INSTANT
            if int(kept.sum()) < FEWEST:
                kept = nearer(t, x, kept, (contact.begin, contact.end), after=after)
            if int(kept.sum()) < FEWEST:
                few = only(int(kept.sum()), track.name, after=after)
                raise FitError(
                    said("{reason} and free of hands and stops", reason=few),
                    said("let the carts run on for half a second, or choose another contact"),
                    "after-too-short" if after else "before-too-short",
                )
            listed.append((t[kept] - contact.middle, x[kept]))
    return listed[0], listed[1], listed[2], listed[3]


def window(
    contact: Contact,
    named: Sequence[Segment],
    after: bool,
    longest: float = LONGEST,
    rested: bool = False,
) -> tuple[float, float]:
    """s. The stretch beside the contact in which the cart is left alone; `named`: of this cart.
    `rested`: with the rest that it has come to, or that it began to move from."""
    free = ("rest", "coasting", "friction")
    greatest = max((abs(v) for one in named for v in one.speeds if one.kind in free), default=0.0)
    low = high = contact.end if after else contact.begin
    speed, fastest, braked = None, 0.0, False
    for one in named if after else reversed(named):
        near, far = (one.begin, one.end) if after else (one.end, one.begin)
        if (near < contact.end - 1e-9) if after else (near > contact.begin + 1e-9):
            continue
        first, last = one.speeds if after else one.speeds[::-1]
        jumps = speed is not None and abs(first - speed) > JUMP * greatest
        # Friction acts while a cart moves: what it has come to rest from ends there.
        rests = one.kind == "rest" and (braked or fastest > MOVED * greatest) and not rested
        if one.kind not in free or jumps or rests:
            break
        far = _still_moving(one, near, far)
        fastest = max(fastest, abs(first), abs(last))
        low, high, speed = min(low, far), max(high, far), last
        braked = one.kind == "friction"
    return max(low, contact.begin - longest), min(high, contact.end + longest)


def _still_moving(one: Segment, near: float, far: float) -> float:
    """s. The end of a segment away from the contact; of a parabola, where its velocity is 0: the
    boundary of a rest is found to a few cells only."""
    first, last = one.speeds if far > near else one.speeds[::-1]
    if one.kind != "friction" or first * last >= 0.0:
        return far
    return near + (far - near) * abs(first) / (abs(first) + abs(last))


def speeds_of(sides: Sequence[Side]) -> Speeds:
    """The velocities by the step of the ladder that predicts best; raises FitError."""
    import numpy as np

    far, near = held_back(sides)
    predicted = {step: predictions(far, near, step) for step in STEPS}
    errors = {step: missed(near, places) for step, places in predicted.items()}
    could = steps_of(sides)
    best, chance = STEPS[0], chance_of(sides)
    for step in could:
        clearly = HALVED if step == "both" else min(BETTER, 1.0 - chance)
        if errors[step] < clearly * errors[best]:
            best = step
    within = max(AS_GOOD, 1.0 + chance) * errors[best]
    found = [solved([_nearest(side, share) for side in sides], best) for share in SHARES]
    whole, covariance, alike = found[0]
    v = np.array([one[0][1:8:2] for one in found])
    spread = v - v.mean(axis=0)
    mean = v.mean(axis=0)
    # What brakes in a way that no step has may look like a tilt, also where none can be.
    others = [step for step in STEPS if step != best and errors[step] < within]
    apart = np.array([solved(sides, step)[0][1:8:2] - whole[1:8:2] for step in others])
    total = covariance[1:8:2, 1:8:2] + spread.T @ spread / (len(SHARES) - 1)
    # As likely as the best; both hold friction and a tilt, and are no further chance beside these.
    likely = 0.25 / max(1, len({*others} - {"both"}))
    total += likely * apart.T @ apart if others else 0.0
    told = {step: predicted[step] for step in could}
    braked, wider, _ = solved(sides, "friction", FAINT)
    if best == "nothing":
        total += _faint(whole, covariance, braked, wider)
    total[np.diag_indices(4)] += braked_unseen(sides, best, whole) ** 2
    total[np.diag_indices(4)] += stood_unseen(sides, braked, wider) ** 2
    return Speeds(
        v=tuple(map(float, mean)),  # type: ignore[arg-type]
        covariance=tuple(tuple(map(float, row)) for row in total),
        places=tuple(map(float, whole[0:8:2])),  # type: ignore[arg-type]
        step=best,
        held_out=tuple(errors.items()),
        rungs=rungs_of(told, near, scatter := scatter_of(sides, best), chance),
        scatter=scatter,
        alike=alike,
        even=braked_alike(sides),
    )


def _faint(numbers: Floats, covariance: Floats, braked: Floats, wider: Floats) -> Floats:
    """m²/s². What a friction that the readings do not call for may do to the four velocities: it
    always slows the carts, and a straight line tells how fast they are half a second later.
    `braked`, `wider`: numbers and covariance with a friction that is FAINT."""
    import numpy as np

    apart = braked[1:8:2] - numbers[1:8:2]
    more = np.maximum(np.diag(wider)[1:8:2] - np.diag(covariance)[1:8:2], 0.0)
    return np.asarray(np.diag(more) + 0.25 * np.outer(apart, apart))


def _nearest(side: Side, share: float) -> Side:
    """The part of a side that is nearest to the contact; at least FEWEST readings."""
    import numpy as np

    tau, x = side
    order = np.argsort(np.abs(tau))
    kept = np.sort(order[: max(min(FEWEST, len(tau)), round(share * len(tau)))])
    return tau[kept], x[kept]
