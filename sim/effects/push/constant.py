"""push: its force is constant from its beginning to its end."""

from __future__ import annotations

import math

from sim.effects.constant import Constant
from sim.scene.effects import Effect


def constant(effect: Effect) -> Constant:
    """From when, until when, how strong."""
    numbers = effect.numbers
    return Constant(push=(numbers["from"], numbers.get("until", math.inf), numbers["force"]))
