"""release: an exploder between two touching carts sets free exactly this energy, at one time.

    ½ mu w'² = ½ mu w² + E        w, w' [m/s]: speed of separation before and after
    impulse = mu (w' − w)         on each, outwards; mu = m1 m2 / (m1 + m2)

From rest: v1 = −sqrt(2 E mu)/m1, v2 = +sqrt(2 E mu)/m2, equal and opposite momenta. The two must
touch at that time. A pair that touches at the start with equal velocities is held together until
then (the exploder's latch); what their bumpers are squeezed by under the latch gives no energy of
its own. E is the work of the release. Source: conservation of momentum and energy.
"""

from __future__ import annotations

from sim.effects.forces import Acting, EnergyRelease
from sim.effects.where import gap_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


class Release(Acting):
    """One release."""

    kind = "release"

    def __init__(self, effect: Effect, scene: Scene) -> None:
        numbers = effect.numbers
        gap = gap_of(effect, scene)
        self._one = EnergyRelease(self.kind, gap, numbers["energy"], numbers["at"])

    def releases(self) -> tuple[EnergyRelease, ...]:
        """The energy, the pair and the time."""
        return (self._one,)


act = Release
