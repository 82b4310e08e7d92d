"""A first guess for the fit, from the readings alone.

Both carts are fitted by two straight lines with one kink; the kink is tried at many instants and
the best one taken. The length of the contact is tried in
steps from a fraction of a frame to half the film: the readings inside are left out, straight lines
through the others give velocities, mass ratio and e, and where they meet gives the touch.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from sim.measured.model.contact import Law
from sim.measured.model.motion import Parameters
from sim.measured.refusal import FitError, only
from sim.scene.said import said

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Times = tuple[Floats, Floats]

KINKS = 80
LENGTHS = 24
APART = 1.8
"""Two starts differ by this factor in w0 at least."""

EACH_SIDE = 3
"""Readings of each cart before the touch, and after it."""

E_LOW, E_HIGH = 0.0, 1.5
"""e above 1 is fitted, so that the interval is honest at e = 1; it is told as impossible."""

RATIO_HIGH = 1e4
CALM = said("choose the seconds around one contact in which nobody holds a cart")


def guesses(
    t: Times,
    x: Times,
    law: Law,
    distance: float | None,
    score: Callable[[Parameters], float],
) -> list[Parameters]:
    """The best first guesses, most likely first; `score`: sum of squares of one."""
    import numpy as np

    kink = _kink(t, x)
    spread = max(float(np.ptp(x[0])), float(np.ptp(x[1])), 1e-12)
    length = max(t[0][-1], t[1][-1]) - min(t[0][0], t[1][0])
    frame = min(float(np.median(np.diff(t[0]))), float(np.median(np.diff(t[1]))))
    tried = []
    for contact in np.geomspace(0.5 * frame, 0.6 * length, LENGTHS):
        lines = _lines(t, x, kink, float(contact))
        if lines is None:
            break
        if (made := _from_lines(lines, float(contact), law, distance)).approach > 0.0:
            tried.append(made)
    tried = [one for one in tried if one.approach > 1e-3 * spread / length]
    if not tried:
        reason = said("the carts do not come closer to each other, so there is no contact to fit")
        raise FitError(reason, CALM)
    tried.sort(key=score)
    others = [one for one in tried if not 1 / APART < one.w0 / tried[0].w0 < APART]
    return [tried[0], *others[:1]]


def check_sides(sides: Sequence[tuple[int, int]]) -> None:
    """Raises FitError where a cart has too few readings before the contact or after it."""
    for cart, (before, after) in enumerate(sides, 1):
        late = before >= EACH_SIDE
        count = after if late else before
        if count < EACH_SIDE:
            named = said("cart {number}", number=str(cart))
            hint = said("at least {least} are needed; {calm}", least=str(EACH_SIDE), calm=CALM)
            code = "no-fit" if count else "no-contact"
            raise FitError(only(count, named, after=late), hint, code)


Line = tuple[float, float, float]
"""A place, a slope, and the instant of the place."""


def _lines(t: Times, x: Times, kink: float, contact: float) -> list[tuple[Line, Line]] | None:
    """Straight lines before and after a contact of this length, for each cart."""
    found = []
    for times, places in zip(t, x, strict=True):
        sides = []
        for side in (times < kink - 0.6 * contact, times > kink + 0.6 * contact):
            if int(side.sum()) < EACH_SIDE:
                return None
            tau, place = times[side], places[side]
            middle = tau.mean()
            tau = tau - middle
            slope = float(tau @ place / (tau @ tau))
            sides.append((float(place.mean()), slope, float(middle)))
        found.append((sides[0], sides[1]))
    return found


def _from_lines(
    lines: list[tuple[Line, Line]], contact: float, law: Law, distance: float | None
) -> Parameters:
    """All parameters from four lines and the length of the contact."""
    (before1, after1), (before2, after2) = lines
    v, after = (before1[1], before2[1]), (after1[1], after2[1])
    u, apart = v[0] - v[1], after[1] - after[0]
    e = min(max(apart / u, 0.02), 1.2) if u > 0.0 else 0.5
    change = (after[0] - v[0], after[1] - v[1])
    ratio = -change[0] / change[1] if change[0] < 0.0 < change[1] else 1.0
    swing = 0.5 * math.pi * (1.0 + e) if law == "bumper" else math.hypot(math.pi, math.log(e))
    w0 = swing / contact
    # Where the lines of the distance meet, and how long after the touch that is.
    gap = [_at(b, 0.0) - _at(a, 0.0) for a, b in ((before1, before2), (after1, after2))]
    meet = (gap[0] - gap[1]) / (u + apart) if u + apart > 0.0 else before1[2]
    late = ((1.0 - e) + 0.5 * math.pi * e) / w0 if law == "bumper" else e * contact / (1.0 + e)
    touch = meet - late
    x1, x2 = _at(before1, touch), _at(before2, touch)
    return Parameters(
        touch=touch,
        x=x1,
        distance=x2 - x1 if distance is None else distance,
        v=v,
        ratio=min(max(ratio, 1e-3), 1e3),
        e=e,
        w0=w0,
    )


def _at(line: Line, t: float) -> float:
    return line[0] + line[1] * (t - line[2])


def _kink(t: Times, x: Times) -> float:
    """The instant at which two straight lines with one kink fit both carts best."""
    import numpy as np

    low = max(times[EACH_SIDE - 1] for times in t)
    high = min(times[-EACH_SIDE] for times in t)
    if not low < high:
        reason = said("the two carts were not filmed at the same time")
        raise FitError(reason, said("one film, both tracks"))
    best = (math.inf, float(low))
    for instant in np.linspace(low, high, KINKS):
        total = 0.0
        for times, places in zip(t, x, strict=True):
            tau = times - instant
            basis = np.column_stack([np.ones_like(tau), np.minimum(tau, 0), np.maximum(tau, 0)])
            solved = np.linalg.lstsq(basis, places, rcond=None)[0]
            total += float(np.sum((basis @ solved - places) ** 2))
        best = min(best, (total, float(instant)))
    return best[1]
