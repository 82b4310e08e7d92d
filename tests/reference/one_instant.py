"""Several impacts without a duration at one instant, for the oracle: the convention written out.

Of all gaps that touch and close the one furthest to the left is struck; that again and again, until
none closes. Where they shrink for ever (inelastic collapse) this is their limit, to rounding. What
is released or let go at that instant comes after them (`docs/physics/contact-laws.md`).
"""

from __future__ import annotations

from tests.reference.contact_branches import UnsupportedError
from tests.reference.row_of_carts import Group, Row

TOUCH = 1e-12
"""m. Rooms that the integration cannot tell from nought."""

CLOSES = 1e-14
"""Of the greatest speed. What is left of a collapse."""

MOST = 20_000
"""Impacts at one instant."""


def strike_all(row: Row, struck: int | None = None) -> None:
    """All impacts at this instant. `struck`: a gap found to touch, however far it went beyond."""
    for _ in range(MOST):
        k = next((k for k in row.gaps if _is_struck(row, k, struck)), None)
        if k is None:
            return
        row.hit(k)
    raise UnsupportedError("impacts without end")


def _is_struck(row: Row, k: int, struck: int | None) -> bool:
    if row.branches[k] is not None or k in row.joined:
        return False
    d, s = row.overlap(k, row.x, row.v)
    return (k == struck or d >= -TOUCH) and s > CLOSES * max(map(abs, row.v))


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
        if any(starts):
            row.join(k)
            hold_on(row)
            return True
    return False


def _starts(row: Row, group: Group) -> int:
    """Where a group at rest goes, as -1, 0, 1; 0 if friction holds it, or it has none to do so."""
    static = row.grips(group)[1]
    force = row.forces(row.x, row.v)[0]
    total = sum(force[i] for i in group.carts)
    if group.fixed or not static or abs(total) <= static:
        return 0
    return 1 if total > 0 else -1
