"""The direction of the track, from the motion: nobody lays a camera or a phone quite along it.

It is the direction in which things move most: the eigenvector of the largest eigenvalue of

    S = Σ (p − p̄)(p − p̄)ᵀ        (first principal axis; by power iteration)

In a film each cart has its own mean p̄: marks at different heights of two carts turn nothing.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from sim.scene.said import said

TURNS = 60
"""Steps of the power iteration: the ratio of two axes of a track is above 10."""

SLANT = math.cos(math.radians(3.0))
"""Along a track nearer to x than this x alone is read: it is 0.14 % shorter at the most."""

STRAIGHT = 0.1
"""Root mean square across the track by that along it: marks scatter less, pucks on a table more."""

UPRIGHT = math.sin(math.radians(5.0))
"""A track nearer to upright than this has + upwards; every other one to the right."""

Vector = tuple[float, ...]


def axis_of(points: Sequence[Vector]) -> Vector:
    """The first principal axis of all points, of any dimension, + along its largest part."""
    axis = _principal(centred(points))
    return tuple(-part for part in axis) if max(axis, key=abs) < 0.0 else axis


def centred(points: Sequence[Vector]) -> list[Vector]:
    """The points, counted from their mean."""
    means = [sum(parts) / len(points) for parts in zip(*points, strict=True)]
    return [tuple(x - mean for x, mean in zip(p, means, strict=True)) for p in points]


def _principal(moved: Sequence[Vector]) -> Vector:
    each = range(len(moved[0]))
    spread = [[sum(p[i] * p[k] for p in moved) for k in each] for i in each]
    largest = max(spread[k][k] for k in each)
    axis = [1.0 if spread[i][i] == largest else 0.1 for i in each]
    for _ in range(TURNS):
        axis = [sum(spread[i][k] * axis[k] for k in each) for i in each]
        size = math.hypot(*axis) or 1.0
        axis = [part / size for part in axis]
    return tuple(axis)


def along(axis: Vector, place: Vector) -> float:
    """How far a place lies along the axis."""
    return sum(part * x for part, x in zip(axis, place, strict=True))


def direction_note(axis: Vector) -> str:
    """The note for the reader."""
    parts = ", ".join(f"{a:.3f}" for a in axis)
    return said("direction of the track, from the motion: ({axis})", axis=parts)


def of_film(paths: Sequence[Sequence[Vector]]) -> tuple[Vector, str]:
    """The direction in which carts are read off, from the places (x, y) of each, and what to say.

    (1, 0) where they go along x, and where they leave the line, as pucks on a table do.
    """
    moved = [point for path in paths for point in centred(path)]
    axis = _principal(moved)
    if axis[0] < 0.0 if abs(axis[0]) > UPRIGHT else axis[1] < 0.0:
        axis = (-axis[0], -axis[1])
    sideways = (-axis[1], axis[0])
    far, across = (math.hypot(*(along(line, p) for p in moved)) for line in (axis, sideways))
    if across > STRAIGHT * far:
        note = said(
            "the carts do not stay on one line ({share} across it): x is read",
            share=f"{across / far:.0%}",
        )
        return (1.0, 0.0), note
    return ((1.0, 0.0), "") if axis[0] > SLANT else (axis, direction_note(axis))
