"""The words that most students said, with how many did; what is rare is only counted."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

MOST = 12
"""Different words of one row that are counted one by one."""


def most_said(words: Iterable[str]) -> tuple[list[tuple[str, int]], int]:
    """Words with their counts, most first, then by their letters; and how many more there are."""
    counts = Counter(words)
    order = sorted(counts.items(), key=lambda one: (-one[1], one[0]))
    return order[:MOST], max(0, len(order) - MOST)
