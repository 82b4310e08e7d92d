"""Scenes on which engines are compared: carts as boxes on a line, hard impacts, known outcomes.

Impulses without duration, because that is all that the other engines have. A touch falls between
two steps by luck, so each scene is run in several phases: everything but the first cart is moved by
a part of what the two close in one step.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from sim.scene import Scene, read_scene

DT = 1 / 60
"""s. What all of them are made for."""

PHASES = 16


@dataclass(frozen=True)
class Carts:
    """Masses in kg, centres in m, velocities in m/s; lengths are 0.2 m."""

    name: str
    title: str
    mass: tuple[float, ...]
    x: tuple[float, ...]
    v: tuple[float, ...]
    e: float
    until: float
    left: float | None = None
    right: float | None = None
    phases: int = PHASES

    def phase(self, k: int) -> Carts:
        """The same with all but the first cart a little further to the right."""
        shift = (self.v[0] - self.v[1]) * DT * k / self.phases
        x = (self.x[0], *(round(place + shift, 12) for place in self.x[1:]))
        return Carts(self.name, self.title, self.mass, x, self.v, self.e, self.until,
                     self.left, self.right, self.phases)  # fmt: skip

    def plain(self) -> dict[str, Any]:
        """For the other engines: SI."""
        carts = [
            {"mass": m, "x": x, "v": v, "length": 0.2}
            for m, x, v in zip(self.mass, self.x, self.v, strict=True)
        ]
        return {
            "carts": carts,
            "e": self.e,
            "until": self.until,
            "dt": DT,
            "left": self.left,
            "right": self.right,
        }

    def scene(self) -> Scene:
        """For this program."""
        carts = {
            f"c{k}": {"mass": m, "position": repr(x), "velocity": v}
            for k, (m, x, v) in enumerate(zip(self.mass, self.x, self.v, strict=True))
        }
        track: dict[str, Any] = {"left": "wall" if self.left is not None else "open"}
        if self.right is not None:
            track |= {"right": "wall", "length": self.right}
        contact = {"law": "instant", "restitution": self.e}
        return read_scene({"carts": carts, "track": track, "contact": contact, "until": self.until})


def _row(count: int, gap: float) -> tuple[float, ...]:
    return tuple(round(0.5 + k * (0.2 + gap), 12) for k in range(count))


SCENES = (
    Carts("two", "two carts, 1.5 m/s, e = 0.8", (1, 2), (0.2, 1.0), (1, -0.5), 0.8, 1),
    Carts("slow", "the same, 0.6 m/s", (1, 2), (0.2, 1.0), (0.4, -0.2), 0.8, 3),
    Carts("row", "ten carts 5 cm apart, e = 1", (1,) * 10, _row(10, 0.05), (2,) + (0,) * 9, 1, 2),
    Carts("walls", "two carts between walls for 60 s, e = 1", (1, 2), (0.5, 1.3), (3, -1.2), 1, 60,
          0, 2, phases=1),
)  # fmt: skip
