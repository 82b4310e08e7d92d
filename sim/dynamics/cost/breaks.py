"""Where stepping methods break: one contact of two carts, over its stiffness, masses and bumpers.

A contact is half a swing of ω = sqrt(k/μ), and takes π (1 + e)/(2 ω) with bumpers that give back e.
Two things can go wrong with steps of h. A step as long as the contact sees one place of it: one
push, as deep as the carts came by chance, which is no contact's. (None is missed: on a line an
overlap stays one until something parts the carts.) And a method has a limit of stability: its steps
follow a swing only while ω h stays below it (2 for Verlet and semi-implicit Euler, 2√2 for RK4);
beyond, it makes energy. Explicit Euler has no limit: it makes energy with any step, less with a
shorter one. Bumpers with small e push back k/e² as hard as they are squeezed, so their swing is 1/e
as fast on the way out, and the limit comes sooner. Source: E. Hairer, C. Lubich, G. Wanner,
Geometric Numerical Integration (2006), I.1 and I.5.

Each point of a map is the worst of PHASES runs, whose touch falls at as many places of a step.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from sim.dynamics.cost.exact import Exact, exact
from sim.dynamics.result.ledger import kinetic
from sim.dynamics.stepping.methods import FIXED, MethodChoice, batch
from sim.laws.lookup import contact_law
from sim.scene import Scene, read_scene

PHASES, SIDE = 8, 24
STEPS = (1e-3, 1e-1)
"""s, the shortest and the longest; the map grows by factors."""

MOST_DIGITS = 8
MADE = 1.1
"""Times the energy of the start. More is energy that the method made; the bumpers make none."""

LIMITS = {"semi-implicit": 2.0, "verlet": 2.0, "yoshida": 1.573, "rk4": 2.0 * math.sqrt(2.0)}
"""ω h up to which a method follows a swing without damping; no limit is known for the others."""


@dataclass(frozen=True, slots=True)
class Map:
    """`low` to `high` of one number of the scene; `grows`: by factors, else by equal parts."""

    name: str
    path: tuple[str, ...]
    low: float
    high: float
    grows: bool = True

    def values(self) -> list[float]:
        """SIDE of them, each the middle of its column."""
        parts = [(k + 0.5) / SIDE for k in range(SIDE)]
        if self.grows:
            return [_short(self.low * (self.high / self.low) ** part) for part in parts]
        return [_short(self.low + (self.high - self.low) * part) for part in parts]


MAPS = (
    Map("stiffness", ("contact", "stiffness"), 1e2, 1e8),
    Map("mass of B", ("carts", "B", "mass"), 1e-3, 1e3),
    Map("restitution", ("contact", "restitution"), 0.0, 1.0, grows=False),
)


def parts() -> list[int]:
    """How many steps the second is divided into: the shortest first."""
    low, high = STEPS
    return [round(1.0 / (low * (high / low) ** ((k + 0.5) / SIDE))) for k in range(SIDE)]


def plain_scene() -> dict[str, Any]:
    """Two equal carts that meet; each map changes one number of it."""
    return {
        "carts": {
            "A": {"mass": 1.0, "position": 0.4, "velocity": 1.0},
            "B": {"mass": 1.0, "position": 1.2, "velocity": -0.5},
        },
        "contact": {"law": "bumper", "restitution": 0.9, "stiffness": 2000.0},
        "until": 1.0,
    }


def scene_at(one: Map, value: float) -> dict[str, Any]:
    """The plain scene with `value` in its place."""
    plain = plain_scene()
    place = plain
    for key in one.path[:-1]:
        place = place[key]
    place[one.path[-1]] = value
    return plain


def letter(scene: Scene, truth: Exact, choice: MethodChoice) -> str:
    """Right digits of the velocities, 0 to 8; x: energy was made."""
    import numpy as np

    with np.errstate(all="ignore"):
        _, v, _ = batch(scene, choice, (np.arange(PHASES) + 0.5) / PHASES)
        speeds = [np.broadcast_to(np.asarray(lane, dtype=float), (PHASES,)) for lane in v]
        energy = sum(0.5 * c.mass * u * u for c, u in zip(scene.carts, speeds, strict=True))
        far = [abs(u - true) for u, true in zip(speeds, truth.v, strict=True)]
        error = float(np.max(far)) / truth.closing
    if not math.isfinite(error) or float(np.max(energy)) > MADE * kinetic(
        scene, [c.velocity for c in scene.carts]
    ):
        return "x"
    return str(int(min(MOST_DIGITS, max(0.0, -math.log10(error or 1e-300)))))


def tables() -> Iterator[tuple[str, dict[str, str]]]:
    """Map by map: for each method its letters, one column after the other, short steps first."""
    for one in MAPS:
        found: dict[str, str] = dict.fromkeys(FIXED, "")
        for value in one.values():
            scene = read_scene(scene_at(one, value))
            truth = exact(scene)
            for method in found:
                choices = (MethodChoice(method, step=scene.until / n) for n in parts())
                found[method] += "".join(letter(scene, truth, choice) for choice in choices)
        yield one.name, found


def lines(one: Map) -> dict[str, list[float]]:
    """s, for each column: `contact`, a step as long as the contact; `swing`, 1/ω of its faster half
    (a limit of stability stands at so many times that)."""
    found: dict[str, list[float]] = {"contact": [], "swing": []}
    for value in one.values():
        scene = read_scene(scene_at(one, value))
        contact = scene.contacts[1]
        law = contact_law(contact) if contact is not None else None
        assert law is not None and contact is not None
        a, b = (cart.mass for cart in scene.carts)
        mu = a * b / (a + b)
        e = contact.restitution or 0.0
        found["contact"].append(law.figures(mu).duration)
        found["swing"].append(math.sqrt(mu / (contact.stiffness or 1.0)) * e)
    return found


def document() -> Mapping[str, Any]:
    """All maps, as a page draws them."""
    letters = dict(tables())
    maps = [
        {
            "name": one.name,
            "path": list(one.path),
            "values": one.values(),
            "letters": letters[one.name],
            "lines": {k: [_short(h) for h in row] for k, row in lines(one).items()},
        }
        for one in MAPS
    ]
    return {"parts": parts(), "limits": LIMITS, "scene": plain_scene(), "maps": maps}


def _short(value: float) -> float:
    """Three digits: a number that can be typed."""
    return float(f"{value:.3g}")
