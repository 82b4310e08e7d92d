"""How large an effect usually is where a scene leaves it out: for “what would it change?”.

An effect's folder may hold `estimate.py` with one `ESTIMATE`: usual numbers, and where they come
from. An effect without one has no usual size (nobody pushes by accident); a scene can give one of
its own under `estimate`. Imported only when somebody asks.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sim.effects.part import part_of
from sim.scene.effects import Effect, kinds
from sim.scene.model import Scene


@dataclass(frozen=True, slots=True, kw_only=True)
class Estimate:
    """Usual numbers in SI, the same as a reader would write them, and their source."""

    numbers: Mapping[str, float]
    size: str
    source: str


def estimate_of(kind: str) -> Estimate | None:
    """The usual size of one kind of effect; None where its folder tells none."""
    module = part_of(kind, "estimate")
    if module is None:
        return None
    found = getattr(module, "ESTIMATE", None)
    if not isinstance(found, Estimate):
        raise ImportError(f"{module.__name__} holds no ESTIMATE")
    return found


def usual(kind: str, scene: Scene) -> Effect | None:
    """The effect at its usual size on every cart; None without an estimate."""
    found = estimate_of(kind)
    if found is None:
        return None
    defaults = {f.key: float(f.default) for f in kinds()[kind].fields if f.default is not None}
    carts = tuple(cart.name for cart in scene.carts)
    return Effect(kind=kind, numbers={**defaults, **found.numbers}, carts=carts)
