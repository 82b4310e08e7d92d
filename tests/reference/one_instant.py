"""Several impacts without a duration at one instant, for the oracle: the convention written out.

Of all gaps that touch and close those that close fastest are struck, equally fast ones at once;
that again and again, until none closes. Two as fast that would go on for ever whichever came first
end in one velocity. Where they shrink for ever (inelastic collapse) this is their
limit, to rounding. What is released or let go at that instant comes after them
(`docs/physics/contact-laws.md`).
"""

from __future__ import annotations

import numpy as np

from tests.reference.contact_branches import UnsupportedError
from tests.reference.one_body import Group
from tests.reference.row_of_carts import Row

TOUCH = 1e-12
"""m. Rooms that the integration cannot tell from nought."""

CLOSES = 1e-14
"""Of the greatest speed before. What is left of a collapse."""

AS_FAST = 1e-11
"""Relative. Closing speeds that the integration cannot tell apart."""

MOST = 20_000
"""Impacts at one instant."""


def strike_all(row: Row, struck: int | None = None) -> None:
    """All impacts at this instant. `struck`: a gap found to touch, however far it went beyond."""
    least = CLOSES * max(map(abs, row.v))
    for _ in range(MOST):
        touching = [k for k in row.gaps if _touches(row, k, struck)]
        rates = {k: row.overlap(k, row.x, row.v)[1] for k in touching}
        closing = {k: s for k, s in rates.items() if s > least}
        if not closing:
            return
        fastest = max(closing.values())
        first = [k for k, s in closing.items() if s >= fastest * (1 - AS_FAST)]
        if len(first) == 1:
            row.hit(first[0])
        elif set(first) == set(touching) and _collapse(row, first, least):
            _hit_at_once(row, first, closing, 0)
        else:
            _hit_at_once(row, first, closing)
    raise UnsupportedError("impacts without end")


def _collapse(row: Row, gaps: list[int], least: float) -> bool:
    """Do impacts in two gaps in turn shrink for ever, whichever comes first?"""
    contacts = [row.scene.contacts[k] for k in gaps]
    if len(gaps) != 2 or any(contact.joins for contact in contacts):
        return False
    passed_on = [row.inverse_mass(gaps[0]) * row.mu(k) for k in gaps]
    for first in (0, 1):
        k = first
        closing = [row.overlap(gap, row.x, row.v)[1] for gap in gaps]
        while closing[k] > least:
            closing[1 - k] += (1 + contacts[k].restitution) * closing[k] * passed_on[k]
            closing[k] *= -contacts[k].restitution
            k = 1 - k
        if max(map(abs, closing)) > least:
            return False
    return True


def _hit_at_once(
    row: Row, gaps: list[int], closing: dict[int, float], e: float | None = None
) -> None:
    """Impulses p with W p = (1 + e) s: W_jk is what an impulse of 1 N s in gap k parts gap j by."""
    parts = np.zeros((len(gaps), len(gaps)))
    for column, k in enumerate(gaps):
        change = [0.0] * row.n
        for cart, way in ((k - 1, -1.0), (k, 1.0)):
            for i in row.body(cart):
                change[i] = way * row.inverse_mass(i)
        for line, j in enumerate(gaps):
            right = change[j] if j < row.n else 0.0
            parts[line, column] = right - (change[j - 1] if j > 0 else 0.0)
    given = [row.scene.contacts[k].restitution or 0 if e is None else e for k in gaps]
    wanted = [(1 + one) * closing[k] for one, k in zip(given, gaps, strict=True)]
    for k, impulse in zip(gaps, np.linalg.solve(parts, wanted), strict=True):
        row.part(k, float(impulse))
    for k in gaps:
        if row.scene.contacts[k].joins:
            row.join(k)


def _touches(row: Row, k: int, struck: int | None) -> bool:
    """By a law without a duration?"""
    if row.branches[k] is not None or k in row.joined:
        return False
    return k == struck or row.overlap(k, row.x, row.v)[0] >= -TOUCH


def hold_on(row: Row) -> bool:
    """Velcro between two at rest that touch, where the one would start into the other, holds.

    Neither can move without the other: static friction of both resists, not that of one alone.
    True if any does.
    """
    for k in row.gaps:
        contact = row.scene.contacts[k]
        if not contact.joins or k in row.joined or abs(row.overlap(k, row.x, row.v)[0]) > TOUCH:
            continue
        sides = [row.group(k - 1), row.group(k)]
        if any(row.v[one.carts[0]] != 0.0 for one in sides if one):
            continue
        ways = zip(sides, (1, -1), strict=True)
        starts = [one is not None and _starts(row, one) * way > 0 for one, way in ways]
        into = [_acceleration(row, one) * way for one, way in zip(sides, (1, -1), strict=True)]
        if any(starts) and sum(into) > 0:  # the other does not start away from it, and faster
            row.join(k)
            hold_on(row)
            return True
    return False


def _acceleration(row: Row, group: Group | None) -> float:
    """m/s² with which a group at rest begins to move by itself."""
    if group is None or group.fixed:
        return 0.0
    kinetic, static = row.grips(group)
    force = row.forces(row.x, row.v)[0]
    total = sum(force[i] for i in group.carts)
    if static and abs(total) <= static:
        return 0.0
    rubs = kinetic if total > 0 else -kinetic
    return (total - rubs) / sum(row.m[i] for i in group.carts)


def _starts(row: Row, group: Group) -> int:
    """Where a group at rest goes, as -1, 0, 1; 0 if friction holds it, or it has none to do so."""
    static = row.grips(group)[1]
    force = row.forces(row.x, row.v)[0]
    total = sum(force[i] for i in group.carts)
    if group.fixed or not static or abs(total) <= static:
        return 0
    return 1 if total > 0 else -1
