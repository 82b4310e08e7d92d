"""Random numbers that are the same in every Python and in every browser (splitmix64)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

Item = TypeVar("Item")
MASK = (1 << 64) - 1


class Chance:
    """A stream of numbers from a seed. Source: Steele, Lea & Flood, OOPSLA 2014."""

    def __init__(self, seed: int) -> None:
        self.state = seed & MASK

    def number(self) -> float:
        """From 0 to below 1."""
        self.state = (self.state + 0x9E3779B97F4A7C15) & MASK
        z = self.state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
        return ((z ^ (z >> 31)) >> 11) / (1 << 53)

    def between(self, low: float, high: float) -> float:
        """Evenly."""
        return low + (high - low) * self.number()

    def scaled(self, low: float, high: float) -> float:
        """Evenly in the logarithm: as often from 0.1 to 1 as from 1 to 10."""
        return low * float((high / low) ** self.number())

    def one_of(self, items: Sequence[Item]) -> Item:
        """Each as likely."""
        return items[int(self.number() * len(items))]
