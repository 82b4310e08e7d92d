"""hertz, for stepping methods."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from sim.laws.stepping import Mode, TouchOrPart

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]


class Curved(Protocol):
    """What is asked of the law."""

    @property
    def stiffness(self) -> float:
        """N/m^1.5."""

    def damper(self, mu: float) -> float:
        """N s/m^1.25."""

    def force(self, mu: float, d: float, v: float) -> float:
        """N."""

    def dissipated(self, mu: float, d: float, v: float) -> float:
        """W."""


class HertzForce(TouchOrPart):
    """N = K d^(3/2) + C d^(1/4) v while d > 0."""

    def __init__(self, law: Curved, mu: float) -> None:
        self.law, self.mu, self.damper = law, mu, law.damper(mu)

    def push(self, d: float, v: float, memory: float) -> float:
        """The law's own formula."""
        return self.law.force(self.mu, d, v)

    def pushes(self, d: Values, v: Values, memory: Values) -> Values:
        """The same."""
        import numpy as np

        root = np.sqrt(np.maximum(d, 0.0))
        return self.law.stiffness * root**3 + self.damper * np.sqrt(root) * v

    def on(self, mode: Mode, d: float, v: float, memory: float) -> float:
        """It is nought below d = 0 anyway: d^(3/2) has no value there."""
        return 0.0 if mode == "apart" else self.law.force(self.mu, d, v)

    def warming(self, push: float, d: float, v: float) -> float:
        """C d^(1/4) v²."""
        return self.law.dissipated(self.mu, d, v) if push else 0.0
