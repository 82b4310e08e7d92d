"""Segments as a reader sets them: a boundary that was dragged, a span that was named.

What is given counts; the rest is found as before and makes room. A contact is one of both carts:
it takes the place of the found one that it overlaps most, or stands as a new one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from sim.measured.events.contacts import Contact, middle_of
from sim.measured.events.grid import Grid
from sim.measured.events.segments import segment
from sim.measured.events.stretch import Kind, Segment
from sim.measured.refusal import FitError
from sim.scene.said import said

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

LEAST = 1e-6
"""s. What is left of a segment below this is nothing."""


@dataclass(frozen=True, slots=True)
class Given:
    """From and until in s; `cart` 0 or 1, None: both, as a contact is."""

    kind: Kind
    begin: float
    end: float
    cart: int | None = None


def with_contacts(grid: Grid, found: list[Contact], given: Sequence[Given]) -> list[Contact]:
    """The contacts with those that are given; raises FitError where one lies outside."""
    import numpy as np

    listed = list(found)
    for one in given:
        if one.kind != "contact":
            continue
        if not (grid.t[0] <= one.begin < one.end <= grid.t[-1]):
            raise FitError(
                said(
                    "the contact from {first} to {last} s does not lie within the readings of both "
                    "carts",
                    first=f"{one.begin:.2f}",
                    last=f"{one.end:.2f}",
                ),
                said(
                    "between {first} and {last} s",
                    first=f"{grid.t[0]:.2f}",
                    last=f"{grid.t[-1]:.2f}",
                ),
                "outside",
            )
        near = max(listed, key=lambda other: _common(one, other), default=None)
        strength = max((other.strength for other in listed), default=1.0)
        if near is not None and _common(one, near) > 0.0:
            listed.remove(near)
        # Found contacts begin and end with cells of the grid, and so do segments beside them.
        low = min(int(np.argmin(np.abs(grid.t - one.begin))), len(grid.t) - 2)
        high = max(low + 1, int(np.argmin(np.abs(grid.t - one.end))))
        begin, end = float(grid.t[low]), float(grid.t[high])
        listed.append(Contact(begin, middle_of(grid, begin, end), end, strength))
    return sorted(listed, key=lambda other: other.begin)


def _common(one: Given, other: Contact) -> float:
    return min(one.end, other.end) - max(one.begin, other.begin)


def with_segments(
    grid: Grid, found: Sequence[Segment], given: Sequence[Given], contacts: Sequence[Contact]
) -> list[Segment]:
    """Both carts' segments with those that are given laid over them."""
    every: list[Segment] = []
    for cart in (0, 1):
        spans = [(one.begin, one.end, one.kind) for one in found if one.cart == cart]
        own = [one for one in given if one.cart in (None, cart) and one.kind != "contact"]
        for one in own:
            spans = _over(spans, one)
        every += [
            segment(grid, cart, begin, end, kind, contacts) for begin, end, kind in spans
        ] if own else [one for one in found if one.cart == cart]  # fmt: skip
    return every


def _over(spans: list[tuple[float, float, Kind]], one: Given) -> list[tuple[float, float, Kind]]:
    """Spans in order of time, one laid over the others; a contact gives way to nothing."""
    begin, end = one.begin, one.end
    for low, high, kind in spans:
        if kind == "contact" and low < end and begin < high:  # up to it, on the longer side
            if low - begin >= end - high:
                end = low
            else:
                begin = high
    if not spans or end - begin <= LEAST:
        return spans
    begin, end = max(begin, spans[0][0]), min(end, spans[-1][1])
    left = [(low, min(high, begin), kind) for low, high, kind in spans]
    right = [(max(low, end), high, kind) for low, high, kind in spans]
    parts = [*left, (begin, end, one.kind), *right]
    return [(low, high, kind) for low, high, kind in parts if high - low > LEAST]
