"""paper and push-only, for stepping methods."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sim.laws.stepping import Mode, TouchOrPart

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]


class DashpotForce(TouchOrPart):
    """N = k d + c v while d > 0; it may pull (`paper`), or not (`push-only`)."""

    def __init__(self, k: float, c: float, *, pulls: bool) -> None:
        self.k, self.c, self.pulls = k, c, pulls

    def push(self, d: float, v: float, memory: float) -> float:
        """Nought without overlap."""
        if d <= 0.0:
            return 0.0
        force = self.k * d + self.c * v
        return force if self.pulls or force > 0.0 else 0.0

    def pushes(self, d: Values, v: Values, memory: Values) -> Values:
        """The same."""
        import numpy as np

        force = np.where(d > 0.0, self.k * d + self.c * v, 0.0)
        return force if self.pulls else np.maximum(0.0, force)

    def on(self, mode: Mode, d: float, v: float, memory: float) -> float:
        """Spring and damper, prolonged."""
        return 0.0 if mode == "apart" else self.k * d + self.c * v

    def holds(self, mode: Mode, d: float, v: float, memory: float) -> tuple[float, ...]:
        """In contact while d > 0, or N > 0; apart while one of them is not."""
        if self.pulls:
            return (-d if mode == "apart" else d,)
        force = d + self.c / self.k * v
        return (max(-d, -force) if mode == "apart" else force,)

    def warming(self, push: float, d: float, v: float) -> float:
        """c v² in the damper."""
        return self.c * v * v if push else 0.0

    def settle(self, held: float, push: float, memory: float, stored: float) -> tuple[float, float]:
        """Energy [J] still stored when the force has become 0 is lost, where it only pushes."""
        if self.pulls:
            return 0.0, 0.0
        return (held if held and not push else 0.0), (stored if push else 0.0)
