"""The force of a contact law as a stepping method asks for it: from what is there just now.

    d [m] overlap, v [m/s] its rate, `memory` [m] a bumper's greatest overlap until it is clear

`push` decides by the state alone whether anything touches, as a game engine does; `pushes` is the
same for arrays. Methods that locate events keep the formula of one `mode` through a step instead
(`on`), and end the step where `holds` falls to nought; `after` says what comes next.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Literal, Protocol

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]

Mode = Literal["apart", "press", "back"]


class SteppedContact(Protocol):
    """One pair's force."""

    @property
    def remembers(self) -> bool:
        """Does it need the greatest overlap?"""

    @property
    def locks(self) -> bool:
        """Can it stay pressed in, taking any force up to `most`?"""

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

    def begin(self, d: float, v: float, memory: float) -> Mode:
        """The mode that a state belongs to, at the start."""

    def most(self, memory: float) -> float:
        """N. The greatest force that it takes without being pressed further than `memory`."""

    def settle(self, held: float, push: float, memory: float, stored: float) -> tuple[float, float]:
        """At the end of a step: J that went into the bumpers for good, and what is held now.

        `held` is whatever it gave here a step before; `stored` [J] is in the contact just now.
        """


class TouchOrPart:
    """Of the laws that know only apart and pressed: in contact while d > 0, and never locked."""

    __slots__ = ()
    remembers = False
    locks = False

    def holds(self, mode: Mode, d: float, v: float, memory: float) -> tuple[float, ...]:
        """In contact while d > 0."""
        return (-d if mode == "apart" else d,)

    def after(self, mode: Mode, d: float, v: float, memory: float) -> tuple[Mode, float]:
        """Touch or part."""
        return ("press" if mode == "apart" else "apart"), 0.0

    def begin(self: SteppedContact, d: float, v: float, memory: float) -> Mode:
        """Pressed or apart."""
        return begin_plain(self, d, v, memory)

    def most(self, memory: float) -> float:
        """It never stays pressed in."""
        return 0.0

    def settle(self, held: float, push: float, memory: float, stored: float) -> tuple[float, float]:
        """Nothing is left beside what `warming` has counted."""
        return 0.0, 0.0


def begin_plain(force: SteppedContact, d: float, v: float, memory: float) -> Mode:
    """The mode of a state for a law that knows only apart and pressed."""
    if d > 0.0 or (d == 0.0 and v > 0.0):
        pressed = force.holds("press", max(d, math.ulp(0.0)), v, memory)
        return "press" if min(pressed) > 0.0 else "apart"
    return "apart"
