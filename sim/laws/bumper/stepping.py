"""bumper, for stepping methods."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sim.laws.stepping import Mode, begin_plain

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]


HAIR = 1e-9
"""Of a bumper's greatest overlap. Rounding does not press carts again that go on together."""


class BumperForce:
    """N = k d pressing in; (k/e²)(d − (1 − e²) memory) springing back, never below nought."""

    remembers = True

    def __init__(self, stiffness: float, e: float) -> None:
        self.k, self.back = stiffness, e * e

    @property
    def locks(self) -> bool:
        """With e = 0 it does not spring back."""
        return self.back == 0.0

    def push(self, d: float, v: float, memory: float) -> float:
        """The line that holds at this overlap."""
        if d <= 0.0:
            return 0.0
        if d >= memory:
            return self.k * d
        return max(0.0, self.on("back", d, v, memory))

    def pushes(self, d: Values, v: Values, memory: Values) -> Values:
        """The same."""
        import numpy as np

        steep = np.zeros_like(d)
        if self.back:
            steep = np.maximum(0.0, (self.k / self.back) * (d - (1.0 - self.back) * memory))
        return np.where(d <= 0.0, 0.0, np.where(d >= memory, self.k * d, steep))

    def on(self, mode: Mode, d: float, v: float, memory: float) -> float:
        """Either line, prolonged."""
        if mode == "press":
            return self.k * d
        if mode == "apart" or self.back == 0.0:
            return 0.0
        return (self.k / self.back) * (d - (1.0 - self.back) * memory)

    def holds(self, mode: Mode, d: float, v: float, memory: float) -> tuple[float, ...]:
        """Apart below the resting overlap; pressing while d grows; back between the two ends."""
        rest = (1.0 - self.back) * memory * (1.0 + HAIR)
        if mode == "press":
            return (v,)
        return (rest - d,) if mode == "apart" else (memory - d, d - rest)

    def after(self, mode: Mode, d: float, v: float, memory: float) -> tuple[Mode, float]:
        """Touch, turn, part or pressed again."""
        if mode == "press":
            return ("back" if self.back else "apart"), d
        if mode == "back":
            return ("press", memory) if v > 0.0 else ("apart", memory)
        if memory > 0.0 and d > 0.0:
            return ("back" if self.back and d < memory else "press"), memory
        return "press", 0.0

    def warming(self, push: float, d: float, v: float) -> float:
        """Booked when the greatest overlap grows: see `settle`."""
        return 0.0

    def begin(self, d: float, v: float, memory: float) -> Mode:
        """Inside its old overlap it springs back."""
        if d <= 0.0:
            return begin_plain(self, d, v, memory)
        if v < 0.0 or d < memory:
            return "back" if self.back else "apart"
        return "press"

    def most(self, memory: float) -> float:
        """k times the overlap."""
        return self.k * memory

    def settle(self, held: float, push: float, memory: float, stored: float) -> tuple[float, float]:
        """`held` is the greatest overlap; pressing in further costs 1 − e² of the work for good."""
        if memory <= held:
            return 0.0, memory
        return self._kept(memory) - self._kept(held), memory

    def _kept(self, memory: float) -> float:
        return 0.5 * self.k * (1.0 - self.back) * memory * memory
