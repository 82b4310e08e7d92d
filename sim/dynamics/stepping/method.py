"""What every method of fixed step has to say."""

from __future__ import annotations

from typing import Any, ClassVar, Protocol

from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.pairs import PerCart


class StepMethod(Protocol):
    """One step from (t, s, v) to (s, v) h later; h may differ from lane to lane.

    `order`: the error after a fixed time falls as h to this power where the force is smooth.
    `weights`: what each evaluation of the force counts in the step, in their order.
    """

    name: ClassVar[str]
    order: ClassVar[int]
    weights: ClassVar[tuple[float, ...]]

    @staticmethod
    def step(field: Field, t: Any, s: PerCart, v: PerCart, h: Any) -> tuple[PerCart, PerCart]:
        """Take it."""
