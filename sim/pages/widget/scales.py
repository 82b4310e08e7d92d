"""Round numbers for axes and arrow scales."""

from __future__ import annotations

from dataclasses import dataclass

from sim.pages.widget.numbers import exponent

# An axis end within this part of a step of a round number counts as that number: rounding noise.
STEP_SLACK = 1e-9
HEADROOM = 0.05  # of the values, above and below: no curve lies on the frame


@dataclass(frozen=True, slots=True)
class Axis:
    """From `low` to `high` in the quantity's unit, with a tick at every multiple of `step`."""

    low: float
    high: float
    step: float

    @property
    def decimals(self) -> int:
        """Decimals that tick labels need."""
        return max(0, -exponent(self.step))


def nice_above(value: float) -> float:
    """The smallest of 1, 2, 5 times a power of ten that is at least `value` (> 0)."""
    power = float(f"1e{exponent(value)}")
    for factor in (1, 2, 5):
        if value <= factor * power * (1 + STEP_SLACK):
            return factor * power
    return 10 * power


def axis(low: float, high: float, count: int) -> Axis:
    """An axis that covers low to high and 0 with some room, in about `count` round steps."""
    low, high = min(0.0, low), max(0.0, high)
    if high == low:
        high = 1.0
    room = HEADROOM * (high - low)
    return Axis(low - room, high + room, nice_above((high - low) / count))


def span(low: float, high: float, count: int) -> Axis:
    """An axis that runs exactly from low to high, with round ticks."""
    return Axis(low, high, nice_above((high - low) / count))
