"""Tracker calls its point masses “mass A” and “mass B”: the carts are A and B, or a report would
tell of the mass of mass B."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from sim.measured.track import Track

POINT_MASS = re.compile(r"(?:mass|masse|masa|massa|质点|质量|質點)[ _]+(?=\S)", re.IGNORECASE)
"""At the beginning of a name, in languages of Tracker."""


def cart_of(name: str) -> str:
    """A name without that word."""
    found = POINT_MASS.match(name)
    return name[found.end() :] if found else name


def called_as_carts(found: Sequence[Track]) -> list[Track]:
    """The tracks without that word, where both have it and still differ."""
    carts = [replace(one, name=cart_of(one.name)) for one in found]
    both = all(cart != one for cart, one in zip(carts, found, strict=True))
    return carts if both and len({cart.name for cart in carts}) == len(carts) else list(found)
