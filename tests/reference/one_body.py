"""Carts that move as one body."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass
class Group:
    """Carts that move as one."""

    carts: list[int]
    fixed: bool = False  # stuck to a wall
    sliding: int = 0
    held: bool = False
