"""Which points of a grid are one contact before the run ends, or none; and their outcomes.

The judgement is on the safe side. A point counts as proven only if

* nothing overlaps at the start, and no two gaps could close first;
* the one contact has ended before the run does, or nothing touches before then;
* no other gap can close in the meantime, even if each cart had its greatest speed towards it all
  through the contact: |d'| never exceeds the approach speed u.

Whatever is closer than MARGIN to one of these bounds is left to a run of its own.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from sim.dynamics.batch.impacts import Impacts, impacts, reduced_mass
from sim.dynamics.batch.parameters import Parameters
from sim.dynamics.loop.contacts import STILL
from sim.scene.laws import laws

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]
    Truths = NDArray[np.bool_]

MARGIN = 1e-9
"""Relative. Far above rounding; a point this close to a bound costs one run, no more."""


@dataclass(frozen=True, slots=True)
class Outcomes:
    """Arrays of the grid's shape; where `proven` is false the numbers mean nothing."""

    proven: Truths
    v: list[Values]  # m/s, of each cart at the end
    force: dict[int, Values]  # N, the greatest in each gap; 0 where it never closes
    warmed: Values  # J


@dataclass(frozen=True, slots=True)
class _Contact:
    """The contact in gap `gap`: who takes part, when, and with what outcome."""

    gap: int
    carts: list[int]  # indices; one of them where the other body is a wall
    begin: Values  # s
    out: Impacts
    after: dict[int, Values]  # m/s, by cart
    span: dict[int, tuple[Values, Values]]  # m/s, least and greatest velocity during it


def outcomes(p: Parameters, shape: tuple[int, ...]) -> Outcomes:
    """Judge and solve all points of a grid of this shape."""
    import numpy as np

    gaps = [k for k, room in enumerate(p.room) if room is not None]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        touch = {k: _touch(p, k) for k in gaps}
        sound = np.ones(shape, dtype=bool)
        for k in gaps:
            sound &= np.asarray(p.room[k]) >= 0.0
        first = np.full(shape, math.inf)
        for k in gaps:
            first = np.minimum(first, touch[k])
        nothing = sound & (first > p.until * (1.0 + MARGIN))
        proven = nothing
        v = [np.broadcast_to(speed, shape) for speed in p.velocity]
        force = {k: np.zeros(shape) for k in gaps}
        warmed = np.zeros(shape)
        for k in gaps:
            contact = _contact(p, k, touch[k])
            alone = sound & _alone(p, contact, touch, [other for other in gaps if other != k])
            proven = proven | alone
            for n in contact.carts:
                v[n] = np.where(alone, contact.after[n], v[n])
            force[k] = np.where(alone, contact.out.force, 0.0)
            warmed = np.where(alone, contact.out.warmed, warmed)
    return Outcomes(proven, v, force, warmed)


def _touch(p: Parameters, k: int) -> Values:
    """s. When gap k closes in free flight; inf: never."""
    import numpy as np

    closing, room = p.closing[k], np.asarray(p.room[k])
    return np.where(closing > 0.0, room / np.where(closing > 0.0, closing, 1.0), math.inf)


def _contact(p: Parameters, k: int, begin: Values) -> _Contact:
    """The contact in gap k, as if it happened."""
    import numpy as np

    count = len(p.mass)
    left = k - 1 if k > 0 else None
    right = k if k < count else None
    m1 = None if left is None else p.mass[left]
    m2 = None if right is None else p.mass[right]
    nought = np.zeros(())
    v1 = nought if left is None else p.velocity[left]
    v2 = nought if right is None else p.velocity[right]
    u = p.closing[k]
    out = impacts(p.law[k], m1, m2, v1, v2, p.restitution[k], p.stiffness[k], u)
    centre = nought if m1 is None or m2 is None else (m1 * v1 + m2 * v2) / (m1 + m2)
    mu = reduced_mass(m1, m2)
    after: dict[int, Values] = {}
    span: dict[int, tuple[Values, Values]] = {}
    for n, mass, speed in ((left, m1, out.v1), (right, m2, out.v2)):
        if n is not None and mass is not None:
            reach = mu / mass * u
            after[n], span[n] = speed, (centre - reach, centre + reach)
    return _Contact(k, list(after), begin, out, after, span)


def _alone(p: Parameters, contact: _Contact, touch: dict[int, Values], others: list[int]) -> Truths:
    """Where this contact happens, ends, and stays the only one."""
    import numpy as np

    end = contact.begin + contact.out.duration
    fastest = np.abs(p.velocity[0])
    for speed in p.velocity[1:]:
        fastest = np.maximum(fastest, np.abs(speed))
    fine = (contact.begin < math.inf) & (end < p.until * (1.0 - MARGIN))
    fine = fine & (p.closing[contact.gap] > STILL * (1.0 + MARGIN) * fastest)
    e = p.restitution[contact.gap]
    if e is not None and laws()[p.law[contact.gap]].no_zero:
        fine = fine & (e > 0.0)
    for k in others:
        fine = fine & (touch[k] > contact.begin * (1.0 + MARGIN))
        fine = fine & _stays_open(p, contact, k, end)
    return fine


def _stays_open(p: Parameters, contact: _Contact, k: int, end: Values) -> Truths:
    """Where gap k has room for the fastest that its carts could be until the run ends."""
    import numpy as np

    count = len(p.mass)
    during, after = np.zeros(()), np.zeros(())
    for n, sign in ((k - 1, 1.0), (k, -1.0)):  # the cart on its left closes it going right
        if not 0 <= n < count:
            continue
        if n in contact.after:
            least, most = contact.span[n]
            during = during + (most if sign > 0.0 else -least)
            after = after + sign * contact.after[n]
        else:
            during, after = during + sign * p.velocity[n], after + sign * p.velocity[n]
    room = np.asarray(p.room[k])
    used = p.closing[k] * contact.begin + np.maximum(during, 0.0) * contact.out.duration
    used = used + np.maximum(after, 0.0) * (p.until - end)
    return used < room - MARGIN * (room + np.abs(used))
