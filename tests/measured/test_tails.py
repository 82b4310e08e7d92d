"""The faint end of a contact is no hand: what springs back weakly still pushes."""

from __future__ import annotations

import pytest

from sim.measured.events.contacts import Contact
from sim.measured.events.stretch import KINDS, Kind, Segment
from sim.measured.events.tails import with_tail

CONTACT = Contact(1.0, 1.02, 1.05, 0.4)


def followed_by(kind: Kind, until: float, change: float) -> list[Segment]:
    """One cart at rest, pushed to 0.4 m/s, and what comes then."""
    return [
        Segment(0.0, 1.0, 1, "rest", (0.0, 0.0)),
        Segment(1.0, 1.05, 1, "contact", (0.0, 0.4)),
        Segment(1.05, until, 1, kind, (0.4, 0.4 + change)),
        Segment(until, 2.0, 1, "coasting", (0.4 + change, 0.4 + change)),
    ]


def test_a_short_small_push_the_same_way_belongs_to_the_contact() -> None:
    assert with_tail(CONTACT, followed_by("hand", 1.2, 0.08)).end == 1.2


def test_a_long_a_large_or_an_opposite_push_does_not() -> None:
    cases: tuple[tuple[Kind, float, float], ...] = (
        ("hand", 1.4, 0.08), ("hand", 1.2, 0.3), ("stop", 1.2, -0.08)
    )  # fmt: skip
    for kind, until, change in cases:
        assert with_tail(CONTACT, followed_by(kind, until, change)) == CONTACT


@pytest.mark.parametrize("kind", sorted(set(KINDS) - {"hand", "stop"}))
def test_what_is_no_push_of_a_hand_or_a_stop_ends_the_contact(kind: Kind) -> None:
    """However short and small: a brake and a coasting cart are told as such."""
    assert with_tail(CONTACT, followed_by(kind, 1.2, 0.08)) == CONTACT
