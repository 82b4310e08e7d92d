"""Carts with a known truth, filmed by the simulator."""

from __future__ import annotations

import math
from dataclasses import dataclass
from random import Random
from typing import Any

from sim.measured.as_tracker import tracker_text
from sim.measured.synthetic import filmed
from sim.measured.tracks import Measured
from sim.scene import Scene, read_scene

NOISE = 1e-3  # m


@dataclass(frozen=True)
class Truth:
    """A collision and what a fit should find: e, ratio, w0 in 1/s, touch in s, velocities."""

    scene: Scene
    e: float
    ratio: float
    w0: float
    touch: float
    v: tuple[float, float]
    contact: float

    def of(self, unknown: str) -> float:
        values = {
            "e": self.e,
            "ln_ratio": math.log(self.ratio),
            "ln_w0": math.log(self.w0),
            "touch": self.touch,
            "v1": self.v[0],
            "v2": self.v[1],
        }
        return values[unknown]


TOLD = ("e", "ln_ratio", "ln_w0", "touch", "v1", "v2")


def truth(
    *,
    mass: float = 0.5,
    ratio: float = 2.0,
    e: float = 0.8,
    v: tuple[float, float] = (0.8, 0.0),
    contact: float = 0.12,
    gap: float = 0.35,
    after: float = 0.6,
    law: str = "bumper",
    effects: tuple[dict[str, Any], ...] = (),
) -> Truth:
    """Two carts, `gap` m apart; `contact`: how long it lasts, `after`: s filmed after it."""
    if law == "bumper":
        w0 = 0.5 * math.pi * (1.0 + e) / contact
    else:
        w0 = math.hypot(math.pi, math.log(e)) / contact
    mu = mass * ratio / (1.0 + ratio)
    touch = gap / (v[0] - v[1])
    plain: dict[str, Any] = {
        "carts": {
            "A": {"mass": mass, "position": 0.5, "velocity": v[0]},
            "B": {"mass": mass * ratio, "position": 0.7 + gap, "velocity": v[1]},
        },
        "contact": {"restitution": e, "stiffness": mu * w0**2, "law": law},
        "until": touch + contact + after,
    }
    if effects:
        plain["effects"] = list(effects)
    return Truth(read_scene(plain), e, ratio, w0, touch, v, contact)


def random_truth(seed: int) -> tuple[Truth, int]:
    """Any collision of a school track, and the frames per second of the film."""
    r = Random(seed)
    v = (r.uniform(0.4, 1.2), r.choice([0.0, -r.uniform(0.05, 0.5)]))
    made = truth(
        mass=r.uniform(0.3, 1.0),
        ratio=r.uniform(0.5, 3.0),
        e=r.uniform(0.4, 1.0),
        v=v,
        contact=r.uniform(0.08, 0.2),
        gap=r.uniform(0.25, 0.4),
        after=r.uniform(0.5, 0.8),
    )
    return made, r.choice([30, 60, 120, 240])


def film(made: Truth, rate: float = 120, noise: float = NOISE, seed: int = 1) -> Measured:
    return filmed(made.scene, rate=rate, noise=noise, seed=seed)


def as_text(measured: Measured) -> str:
    """The readings as Tracker exports them."""
    t = measured.tracks[0].t
    return tracker_text(measured.names, t, [track.value for track in measured.tracks])
