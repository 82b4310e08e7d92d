"""The numbers that a fit moves, as a list, and the parameters of the model that they stand for."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Literal

from sim.measured.model.motion import Parameters

Effect = Literal["none", "friction", "tilt", "both"]
EFFECTS: tuple[Effect, ...] = ("none", "friction", "tilt", "both")
RUBS: tuple[Effect, ...] = ("friction", "both")
LEANS: tuple[Effect, ...] = ("tilt", "both")
"""Effects with a friction of each cart, and those with a tilt of the track."""


def names_of(
    p: Parameters, effect: Effect, distance: float | None, *, lasts: bool = False
) -> tuple[str, ...]:
    """The unknowns of a fit with this effect; `distance` in m, if it is known; `lasts`: how long
    the contact lasts is known."""
    names = ["touch", "x", "ln_ratio", "e"]
    names += [] if lasts else ["ln_w0"]
    names += ["distance"] if distance is None else []
    names += [f"v{k + 1}" for k in range(2) if not p.rests[k]]
    names += ["friction1", "friction2"] if effect in RUBS else []
    names += ["tilt"] if effect in LEANS else []
    return tuple(names)


READ: dict[str, Callable[[Parameters], float]] = {
    "touch": lambda p: p.touch,
    "x": lambda p: p.x,
    "distance": lambda p: p.distance,
    "v1": lambda p: p.v[0],
    "v2": lambda p: p.v[1],
    "ln_ratio": lambda p: math.log(p.ratio),
    "e": lambda p: p.e,
    "ln_w0": lambda p: math.log(p.w0),
    "friction1": lambda p: p.friction[0],
    "friction2": lambda p: p.friction[1],
    "tilt": lambda p: p.tilt,
}


def with_values(p: Parameters, names: Sequence[str], values: Sequence[float]) -> Parameters:
    """The parameters with the unknowns set."""
    got = dict(zip(names, map(float, values), strict=True))
    return Parameters(
        touch=got["touch"],
        x=got["x"],
        distance=got.get("distance", p.distance),
        v=(got.get("v1", p.v[0]), got.get("v2", p.v[1])),
        ratio=math.exp(got["ln_ratio"]),
        e=got["e"],
        w0=math.exp(got["ln_w0"]) if "ln_w0" in got else p.w0,
        friction=(got.get("friction1", 0.0), got.get("friction2", 0.0)),
        tilt=got.get("tilt", 0.0),
        rests=p.rests,
    )
