"""Where an effect acts: indices of carts and of the gap between two neighbours."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.scene.effects import Effect
from sim.scene.model import Scene


def carts_of(effect: Effect, scene: Scene) -> list[int]:
    """Indices of the carts that an effect acts on, from left to right."""
    return [k for k, cart in enumerate(scene.carts) if cart.name in effect.carts]


def gap_of(effect: Effect, scene: Scene) -> int:
    """Index of the gap between the two neighbours that an effect names."""
    assert effect.between is not None
    count = len(scene.carts)
    return next(k for k in range(count + 1) if scene.names_at(k) == effect.between)


def pair_of(effect: Effect, scene: Scene) -> tuple[int | None, int | None]:
    """Indices of the two bodies that an effect names; None is a wall."""
    gap = gap_of(effect, scene)
    return (gap - 1 if gap else None), (gap if gap < len(scene.carts) else None)


def room_between(between: Sequence[str], header: Mapping[str, Any]) -> float:
    """m, from edge to edge at the start, as the head of a run describes it; a name that is no cart
    is an end of the track."""
    bodies = {body["name"]: body for body in header["bodies"]}
    left, right = between
    start = bodies[left]["position"] + bodies[left]["length"] / 2 if left in bodies else 0.0
    end = header["track"]["length"]
    if right in bodies:
        end = bodies[right]["position"] - bodies[right]["length"] / 2
    return float(end - start)
