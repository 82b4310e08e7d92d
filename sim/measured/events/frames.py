"""Signs and zeros: two sensors at both ends of a track share no axis; the contact joins them.

x = sign · (reading − zero), + to the right, the first cart on the left. In a contact the velocities
change in opposite directions: that is the third law, and it gives the sign of one axis against the
other. Where the marks are at the contact, they are `distance` apart: that gives one zero. What is
used up: signs and places can no longer be checked by these readings; velocities of each cart,
their sizes and their instants still can.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from sim.measured.events.sides import Speeds
from sim.measured.tracks import Measured
from sim.scene.said import Said, listed, said

APART = 0.02
"""m. Carts whose marks are at least so far apart at the contact stand in one frame."""


@dataclass(frozen=True, slots=True)
class Axis:
    """Of one sensor: x = sign (reading − zero)."""

    sign: int
    zero: float  # m


@dataclass(frozen=True, slots=True)
class Frames:
    """Both axes. `joined`: they were found by the contact. `sentences`: for the reader."""

    axes: tuple[Axis, Axis]
    joined: bool
    sentences: tuple[str, ...] = ()


def frames_of(
    measured: Measured,
    speeds: Speeds,
    flips: Sequence[str] = (),
    zeros: Mapping[str, float] | None = None,
    distance: float | None = None,
) -> Frames:
    """The axes; `flips` and `zeros` by the sensor's name are the reader's and are kept."""
    given = zeros or {}
    names = measured.names
    if not _apart(measured, speeds) and not flips:
        signs = _signs(speeds)
        joined = True
    else:
        signs = (-1 if names[0] in flips else 1, -1 if names[1] in flips else 1)
        joined = bool(flips) and len(given) < 2
    first, second = (given.get(name, 0.0) for name in names)
    found: list[str] = []
    taken = distance is None
    if joined:
        a, b = (0.5 * (speeds.places[k] + speeds.places[k + 2]) for k in (0, 1))
        apart = distance or 0.0
        if names[1] not in given:
            second = b - signs[1] * (signs[0] * (a - first) + apart)
        elif names[0] not in given:
            first = a - signs[0] * (signs[1] * (b - second) - apart)
        else:  # both are the reader's, and tell it themselves
            apart, taken = signs[1] * (b - second) - signs[0] * (a - first), False
        found.append(_joined(names, signs, None if taken else apart))
    return Frames((Axis(signs[0], first), Axis(signs[1], second)), joined, tuple(found))


def _joined(names: tuple[str, str], signs: tuple[int, int], apart: float | None) -> Said:
    """What joining the axes by the contact has done, and what it has used up. `apart`: None where
    nobody said how far apart the marks are."""
    turned = listed([n for n, s in zip(names, signs, strict=True) if s < 0])
    how = (
        said("the readings of {cart} are turned", cart=turned)
        if turned
        else said("no reading is turned")
    )
    return said(
        "Each sensor has a zero and a direction of its own. They are joined by the contact: there "
        "the velocities change in opposite directions ({turned}), and {marks}. So these readings "
        "do not test the direction of the forces; they still test their sizes and their instants.",
        turned=how,
        marks=said("the marks are taken to be 0 m apart (give the distance)")
        if apart is None
        else said("the marks are {apart} m apart", apart=f"{apart:.4g}"),
    )


def _apart(measured: Measured, speeds: Speeds) -> bool:
    """Whether the readings make sense in one frame as they are."""
    v, x = speeds.v, speeds.places
    opposite = (v[2] - v[0]) * (v[3] - v[1]) < 0.0
    near = x[1] - x[0] + x[3] - x[2]
    meet = v[0] - v[1] + v[3] - v[2] > 0.0  # A on the left is pushed to the left
    return opposite and meet and (not measured.own or near > 2.0 * APART)


def _signs(speeds: Speeds) -> tuple[int, int]:
    """The changes are opposite, and A, on the left, is pushed to the left."""
    v = speeds.v
    first = -1 if v[2] - v[0] > 0.0 else 1
    second = -1 if v[3] - v[1] < 0.0 else 1
    return first, second


def moved(measured: Measured, frames: Frames) -> Measured:
    """The readings on the common axis."""
    tracks = [
        replace(track, value=tuple(axis.sign * (x - axis.zero) for x in track.value))
        for track, axis in zip(measured.tracks, frames.axes, strict=True)
    ]
    return replace(measured, tracks=(tracks[0], tracks[1]), own=False)
