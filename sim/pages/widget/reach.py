"""How far the axis of each graph goes, whatever the sliders say; used by Python and the page.

Fixed for the life of a scene, so that two runs can be compared by eye. It knows only the start
state and the ranges of the sliders; the first run that a reader may see is multiplied by `factor`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from sim.scene.fence.controls import Control

ROOM = 2.0


@dataclass(frozen=True, slots=True)
class Reach:
    """Limits of a quantity in the unit of its graph, and by how much sliders may stretch a run.

    `room`: the axis is at most so many times as long as the run needs, so that extreme sliders do
    not make its curves small; 0: no such limit. A run that needs more gets more.
    """

    low: float
    high: float
    factor: float
    room: float = ROOM

    def as_list(self) -> list[float]:
        """Plain values for the page."""
        return list(asdict(self).values())


def reaches(
    variants: Sequence[Mapping[str, Any]], window: tuple[float, float], force: float, per: float
) -> dict[str, Reach]:
    """The reach of every quantity.

    `variants`: the scene, and with each slider at either end, velocities as the camera sees them
    in m/s; `window`: the picture in m; `force` in N; `per`: m/s in the unit that speeds have.
    """
    carts = [[(b["mass"], b["velocity"]) for b in v["bodies"]] for v in variants]
    speeds = [v for scene in carts for _, v in scene]
    own = max(abs(v) for _, v in carts[0])
    stretch = max(map(abs, speeds)) / own if own else 1.0
    momenta = [m * v for scene in carts for m, v in scene]
    momenta += [sum(m * v for m, v in scene) for scene in carts]
    energy = max(sum(m * v * v / 2 for m, v in scene) for scene in carts)
    return {
        "x": Reach(*window, 1.0, 0.0),
        "v": Reach(min(speeds) / per, max(speeds) / per, stretch),
        "a": Reach(0.0, 0.0, stretch),
        "F": Reach(0.0, force, 1.0),
        "R": Reach(0.0, 0.0, stretch),
        "p": Reach(min(momenta), max(momenta), stretch),
        "energy": Reach(0.0, energy, stretch * stretch),
    }


def with_longest_track(
    header: Mapping[str, Any], controls: tuple[Control, ...]
) -> Mapping[str, Any]:
    """The header as a slider of the track's length may make it: the picture has room for that."""
    longest = max((c.high for c in controls if c.set == "track.length"), default=0.0)
    track = header["track"]
    return {**header, "track": {**track, "length": max(track["length"] or 0.0, longest) or None}}


def picture_window(header: Mapping[str, Any], camera: float) -> tuple[float, float]:
    """What the picture shows, in m: the track, or without ends where the carts may get to.

    Only the start state is used: the size of the picture must not tell the run.
    """
    bodies = header["bodies"]
    left = min(b["position"] - b["length"] / 2 for b in bodies)
    right = max(b["position"] + b["length"] / 2 for b in bodies)
    length = header["track"]["length"]
    if length:
        return min(0.0, left), max(length, right)
    extent = max(right - left, 6 * max(b["length"] for b in bodies))
    speeds = [b["velocity"] - camera for b in bodies]
    reach = header["until"]
    low = left + max(min(0.0, *speeds) * reach, -extent)
    high = right + min(max(0.0, *speeds) * reach, 1.5 * extent)
    rest = extent - (high - low)
    room = max(0.0, rest / 2)
    return min(low - room, low - 0.05), high + room + 0.05
