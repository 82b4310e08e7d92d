"""Which effects act on which carts and gaps, and the forces that need no contact.

Part of the oracle in `effects.py`: written from the definitions, nothing of `sim.dynamics`.
"""

from __future__ import annotations

import math

from sim.scene import Scene
from sim.scene.effects import Effect

KINDS = ("incline", "drag", "push", "friction", "spring", "magnets", "release")


class Acting:
    """The effects of a scene by kind; links and releases with the gap that they are in."""

    def __init__(self, scene: Scene, gaps: list[int]) -> None:
        self.carts, self.g = scene.carts, scene.gravity
        self.of = {kind: [e for e in scene.effects if e.kind == kind] for kind in KINDS}
        self.kinds = sorted({e.kind for e in scene.effects} - {"release"})
        gap = {scene.names_at(k): k for k in gaps}
        self.links = [(gap[e.between], e) for kind in ("spring", "magnets") for e in self.of[kind]]
        self.releases = [(e.numbers.get("at", 0.0), gap[e.between], e) for e in self.of["release"]]
        self.angle = [
            sum(e.numbers["angle"] for e in self.of["incline"] if c.name in e.carts)
            for c in scene.carts
        ]
        self.grip = [self._grip(i) for i in range(len(scene.carts))]

    def _grip(self, i: int) -> tuple[float, float]:
        """N. The greatest kinetic and static friction of cart i."""
        cart, kinetic, static = self.carts[i], 0.0, 0.0
        for e in self.of["friction"]:
            if cart.name in e.carts:
                weight = cart.mass * self.g * math.cos(self.angle[i])
                low = e.numbers["coefficient"]
                kinetic += low * weight
                static += max(low, e.numbers.get("static", low)) * weight
        return kinetic, static

    def link(self, e: Effect, d: float, s: float, power: dict[str, float]) -> float:
        """N. The push of a spring or of magnets in a gap with overlap d, rate s."""
        if e.kind == "magnets":
            return e.numbers["strength"] / max(-d, 1e-9) ** e.numbers.get("power", 3.0)
        damping = e.numbers.get("damping", 0.0)
        power["spring"] -= damping * s * s
        return e.numbers["stiffness"] * (e.numbers["length"] + d) + damping * s

    def alone(self, i: int, v: float, t: float, power: dict[str, float]) -> float:
        """N. Incline, drag and pushes on cart i; friction is left out."""
        cart, force = self.carts[i], 0.0
        for e in self.of["incline"]:
            if cart.name in e.carts:
                force += cart.mass * self.g * math.sin(e.numbers["angle"])
        for e in self.of["drag"]:
            if cart.name in e.carts:
                low, high = e.numbers.get("linear", 0.0), e.numbers.get("quadratic", 0.0)
                slow = -low * v - high * v * abs(v)
                force += slow
                power["drag"] += slow * v
        for e in self.of["push"]:
            begins, ends = e.numbers.get("from", 0.0), e.numbers.get("until", math.inf)
            if e.carts[0] == cart.name and begins <= t < ends:
                force += e.numbers["force"]
                power["push"] += e.numbers["force"] * v
        return force
