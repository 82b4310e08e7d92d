"""The faint end of a contact belongs to it.

Bumpers that have lost much spring back weakly and long. What pushes a cart on, right after the
contact, the same way, shortly and by a small part of what the contact gave, is no hand.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sim.measured.events.contacts import Contact
from sim.measured.events.stretch import Segment

SHORT = 0.25
"""s. Hands push for longer, and do not come so soon."""

SMALL = 0.3
"""Of what the contact changes the cart's velocity by."""


def with_tail(contact: Contact, named: Sequence[Segment]) -> Contact:
    """The contact up to the end of what still pushes one of the carts."""
    end = contact.end
    for cart in (0, 1):
        own = [one for one in named if one.cart == cart]
        for before, push, tail in zip(own, own[1:], own[2:], strict=False):
            if push.kind == "contact" and push.begin <= contact.middle <= push.end:
                end = max(end, tail.end) if _faint(before, tail) else end
    return replace(contact, end=end)


def _faint(before: Segment, tail: Segment) -> bool:
    given = tail.speeds[0] - before.speeds[1]
    more = tail.speeds[1] - tail.speeds[0]
    short = tail.end - tail.begin <= SHORT and tail.kind in ("hand", "stop")
    return short and 0.0 < more * given < SMALL * given * given
