"""The force of a contact law as a stepping method asks for it: from what is there just now.

    d [m] overlap, v [m/s] its rate, `memory` [m] a bumper's greatest overlap until it is clear

`push` decides by the state alone whether anything touches, as a game engine does; `pushes` is the
same for arrays. Methods that locate events keep the formula of one `mode` through a step instead
(`on`), and end the step where `holds` falls to nought; `after` says what comes next.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Literal, Protocol

from sim.dynamics.laws import Bumper, Hertz, Paper, PushOnly
from sim.dynamics.laws.base import FiniteLaw

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]

Mode = Literal["apart", "press", "back"]


HAIR = 1e-9
"""Of a bumper's greatest overlap. Rounding does not press carts again that go on together."""


class ContactForce(Protocol):
    """One pair's force."""

    remembers: bool

    def push(self, d: float, v: float, memory: float) -> float:
        """N, decided by the state."""

    def pushes(self, d: Values, v: Values, memory: Values) -> Values:
        """The same for many runs at once."""

    def on(self, mode: Mode, d: float, v: float, memory: float) -> float:
        """N by the formula of one mode, whatever the state."""

    def holds(self, mode: Mode, d: float, v: float, memory: float) -> tuple[float, ...]:
        """All positive while the mode holds."""

    def after(self, mode: Mode, d: float, v: float, memory: float) -> tuple[Mode, float]:
        """The next mode and the memory where `holds` fell to nought."""

    def warming(self, push: float, d: float, v: float) -> float:
        """W. What the contact takes just now while its force is `push`."""


def contact_force(law: FiniteLaw, mu: float) -> ContactForce:
    """The force of a law between bodies of reduced mass mu [kg]."""
    if isinstance(law, Bumper):
        return BumperForce(law)
    if isinstance(law, Hertz):
        return HertzForce(law, mu)
    assert isinstance(law, (Paper, PushOnly))
    return DashpotForce(law.stiffness, law.damper(mu), pulls=isinstance(law, Paper))


class BumperForce:
    """N = k d pressing in; (k/e²)(d − (1 − e²) memory) springing back, never below nought."""

    remembers = True

    def __init__(self, law: Bumper) -> None:
        self.law, self.k, self.back = law, law.stiffness, law.e * law.e

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
        rest = self.law.resting_overlap(memory) * (1.0 + HAIR)
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
        """Booked when the greatest overlap grows: see `kept`."""
        return 0.0

    def kept(self, memory: float) -> float:
        """J. What pressing in to this overlap costs for good."""
        return 0.5 * self.k * (1.0 - self.back) * memory * memory


class DashpotForce:
    """N = k d + c v while d > 0; it may pull (`paper`), or not (`push-only`)."""

    remembers = False

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

    def after(self, mode: Mode, d: float, v: float, memory: float) -> tuple[Mode, float]:
        """Touch or part."""
        return ("press" if mode == "apart" else "apart"), 0.0

    def warming(self, push: float, d: float, v: float) -> float:
        """c v² in the damper."""
        return self.c * v * v if push else 0.0


class HertzForce:
    """N = K d^(3/2) + C d^(1/4) v while d > 0."""

    remembers = False

    def __init__(self, law: Hertz, mu: float) -> None:
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

    def holds(self, mode: Mode, d: float, v: float, memory: float) -> tuple[float, ...]:
        """In contact while d > 0."""
        return (-d if mode == "apart" else d,)

    def after(self, mode: Mode, d: float, v: float, memory: float) -> tuple[Mode, float]:
        """Touch or part."""
        return ("press" if mode == "apart" else "apart"), 0.0

    def warming(self, push: float, d: float, v: float) -> float:
        """C d^(1/4) v²."""
        return self.law.dissipated(self.mu, d, v) if push else 0.0


def mode_of(force: ContactForce, d: float, v: float, memory: float) -> Mode:
    """The mode that a state belongs to, at the start."""
    if d > 0.0 and isinstance(force, BumperForce):
        if v < 0.0 or d < memory:
            return "back" if force.back else "apart"
        return "press"
    if d > 0.0 or (d == 0.0 and v > 0.0):
        pressed = force.holds("press", max(d, math.ulp(0.0)), v, memory)
        return "press" if min(pressed) > 0.0 else "apart"
    return "apart"
