"""What the outcome of a scene of one or two carts depends on, as arrays over a grid.

Which numbers of a scene a path such as `A.mass` or `contact.restitution` moves is found out by
trying: the scene is read at two places of the axis, and what follows the axis varies with it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from sim.laws.many import outcome_known
from sim.scene import Scene, SceneError, apply_changes, read_scene

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]

MOST_CARTS = 2
"""More carts are more than one contact sooner or later: such scenes are run."""


@dataclass(frozen=True, slots=True)
class Axis:
    """One parameter and its values [SI]; `values` has the shape that broadcasts over the grid."""

    target: str
    values: Values


@dataclass(frozen=True, slots=True)
class Parameters:
    """Lists run over carts or, from `pairs` on, over gaps from left to right."""

    carts: list[str]
    mass: list[Values]  # kg
    velocity: list[Values]  # m/s
    pairs: list[str]  # A-B, left-A
    room: list[Values | None]  # m, None on an open side
    closing: list[Values]  # m/s
    law: list[str]
    restitution: list[Values | None]
    stiffness: list[Values | None]  # N/m
    until: Values  # s


def parameters(plain: Mapping[str, Any], axes: Sequence[Axis]) -> Parameters | None:
    """Those of a scene with nothing but contacts in closed form; None for any other scene."""
    import numpy as np

    probes = _probes(plain, axes, 0.5) or _probes(plain, axes, 0.0)
    if probes is None:
        return None
    base, others, tried = probes
    laws = [contact.law for contact in base.contacts if contact is not None]
    if len(base.carts) > MOST_CARTS or base.effects or not all(map(outcome_known, laws)):
        return None
    own = _numbers(base)
    found = {name: np.asarray(value) for name, value in own.items() if value is not None}
    moved = set()
    for axis, other, (first, second) in zip(axes, others, tried, strict=True):
        theirs = _numbers(other)
        if [c.name for c in other.carts] != [c.name for c in base.carts] or set(theirs) != set(own):
            return None
        for name, value in own.items():
            if theirs[name] == value:
                continue
            if (value, theirs[name]) != (first, second):
                return None
            found[name] = axis.values
            moved.add(name)
    return _collected(base, found, moved)


def _probes(
    plain: Mapping[str, Any], axes: Sequence[Axis], place: float
) -> tuple[Scene, list[Scene], list[tuple[float, float]]] | None:
    """The scene at one point of the grid, with each axis moved to its next value, and those values.

    `place`: 0.5 for the middle of the axes, where no value is an edge case. None: no scene there.
    """
    tried = []
    for axis in axes:
        flat = axis.values.ravel()
        k = int(place * (len(flat) - 1))
        tried.append((float(flat[k]), float(flat[k + 1])))
    here = {axis.target: first for axis, (first, _) in zip(axes, tried, strict=True)}
    try:
        base = read_scene(apply_changes(plain, here))
        others = [
            read_scene(apply_changes(plain, {**here, axis.target: second}))
            for axis, (_, second) in zip(axes, tried, strict=True)
        ]
    except SceneError:
        return None
    return base, others, tried


def _numbers(scene: Scene) -> dict[str, float | None]:
    """Every number of a scene that an outcome may depend on, by a name of our own."""
    numbers: dict[str, float | None] = {"until": scene.until, "track": scene.track.length}
    for k, cart in enumerate(scene.carts):
        numbers |= {
            f"mass {k}": cart.mass,
            f"position {k}": cart.position,
            f"velocity {k}": cart.velocity,
            f"length {k}": cart.length,
        }
    for k, contact in enumerate(scene.contacts):
        if contact is not None:
            numbers[f"restitution {k}"] = contact.restitution
            numbers[f"stiffness {k}"] = contact.stiffness
    return numbers


def _collected(scene: Scene, found: Mapping[str, Values], moved: set[str]) -> Parameters:
    """Gaps and closing speeds are the scene's own, exact, unless an axis moves what they are of."""
    import numpy as np

    count = len(scene.carts)
    edges = [
        (
            found[f"position {k}"] - found[f"length {k}"] / 2,
            found[f"position {k}"] + found[f"length {k}"] / 2,
        )
        for k in range(count)
    ]
    nought = np.zeros(())
    speeds = [nought, *(found[f"velocity {k}"] for k in range(count)), nought]
    rooms: list[Values | None] = []
    closing = []
    for k, contact in enumerate(scene.contacts):
        between = [n for n in (k - 1, k) if 0 <= n < count]
        fixed = not moved & {f"{what} {n}" for what in ("position", "length") for n in between}
        if contact is None:
            rooms.append(None)
        elif fixed and not (k == count and "track" in moved):
            rooms.append(np.asarray(scene.gaps[k]))
        else:
            left = edges[k - 1][1] if k > 0 else nought
            rooms.append((edges[k][0] if k < count else found["track"]) - left)
        if moved & {f"velocity {n}" for n in between}:
            closing.append(speeds[k] - speeds[k + 1])
        else:
            closing.append(np.asarray(-scene.approaches[k]))
    gaps = range(len(scene.contacts))
    return Parameters(
        carts=[cart.name for cart in scene.carts],
        pairs=["-".join(scene.names_at(k)) for k in gaps],
        mass=[found[f"mass {k}"] for k in range(count)],
        velocity=[found[f"velocity {k}"] for k in range(count)],
        room=rooms,
        closing=closing,
        law=["" if contact is None else contact.law for contact in scene.contacts],
        restitution=[found.get(f"restitution {k}") for k in gaps],
        stiffness=[found.get(f"stiffness {k}") for k in gaps],
        until=found["until"],
    )
