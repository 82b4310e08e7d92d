"""push-only-uncorrected: keeps the damping of the printed formula; see `sim.laws.dashpot`."""

from __future__ import annotations

import math
from dataclasses import dataclass

from sim.laws.dashpot import damping_to_zero_overlap
from sim.laws.push_only.law import PushOnly


@dataclass(frozen=True, slots=True, eq=False)
class PushOnlyUncorrected(PushOnly):
    """Ends at force zero, damping of the printed formula: delivers more than was asked for."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "damping", damping_to_zero_overlap(self.e))

    @property
    def delivered(self) -> float:
        """exp(−2 phi cot phi), 1 at e = 1 and exp(−2) as e goes to 0."""
        return math.exp(-2.0 * self.damping.zeta / self.damping.sinc)


make = PushOnlyUncorrected
