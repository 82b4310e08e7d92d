"""The values that a scene is run with before anybody asks: some of each slider, all combinations.

Every value is one that the slider itself can take, and the ends and the scene's own value are among
them. The sliders take turns in getting more, the one with the fewest first, until another value
would mean more than `most` runs. Boxes to tick double the runs; presets are runs of their own.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import prod
from typing import Any

from sim.scene import Fence
from sim.scene.fence.controls import Control
from sim.scene.fence.effect_controls import Switch

Value = float | str | bool
"""As the page sends it: an SI number, text with the slider's unit, or whether an effect acts."""


@dataclass(frozen=True, slots=True)
class Axis:
    """The values of one slider or box. `numbers`: the same as the page compares them, SI."""

    set: str
    values: tuple[Value, ...]
    numbers: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Grid:
    """All combinations of the values of `axes`, the last changing first, and then the presets."""

    axes: tuple[Axis, ...]
    presets: tuple[Mapping[str, Any], ...]

    def settings(self) -> Iterator[dict[str, Any]]:
        """What each run changes in the scene."""
        for values in itertools.product(*(axis.values for axis in self.axes)):
            yield dict(zip((axis.set for axis in self.axes), values, strict=True))
        yield from map(dict, self.presets)


def grid_of(fence: Fence, most: int) -> Grid | None:
    """The grid of a scene with at most `most` combinations. None where three values a slider, its
    ends and its own, are already more, and where the page has the only run there is."""
    sliders, boxes = fence.controls, fence.switches
    room = most // 2 ** len(boxes)
    counts = [2 + _between(one) for one in sliders]
    if not (sliders or boxes or fence.presets or fence.predict) or prod(counts) > room:
        return None
    growing = set(range(len(sliders)))
    while growing:
        k = min(growing, key=lambda k: (counts[k], k))
        more = [*counts[:k], counts[k] + 1, *counts[k + 1 :]]
        if counts[k] < _possible(sliders[k]) and prod(more) <= room:
            counts = more
        else:
            growing.discard(k)
    axes = [*(map(_axis, sliders, counts)), *map(_box, boxes)]
    return Grid(tuple(axes), tuple(fence.presets.values()))


def _steps(slider: Control) -> int:
    return round((slider.high - slider.low) / slider.step)


def _between(slider: Control) -> bool:
    """Whether the scene's own value is none of the slider's ends."""
    return slider.shown(slider.low) < slider.shown(slider.value) < slider.shown(slider.high)


def _possible(slider: Control) -> int:
    return _steps(slider) + 1


def _axis(slider: Control, count: int) -> Axis:
    """`count` values, evenly over the slider's own steps, one of them the scene's."""
    own, low, step = (slider.shown(x) for x in (slider.value, slider.low, slider.step))
    inner = count - 2
    steps = _steps(slider)
    places = {round(steps * (k + 1) / (inner + 1)) for k in range(inner)}
    shown = {float(f"{low + place * step:.12g}") for place in places}
    ends = {low, slider.shown(slider.high)}
    if _between(slider) and own not in shown and shown:
        shown.discard(min(shown, key=lambda one: (abs(one - own), one)))
    values = sorted(shown | ends | {own})
    asked = values if slider.per == 1 else [f"{_plain(x)} {slider.unit}" for x in values]
    return Axis(slider.set, tuple(asked), tuple(float(f"{x * slider.per:.12g}") for x in values))


def _plain(number: float) -> str:
    """As the page writes a number into its request."""
    return str(int(number)) if number == int(number) else repr(number)


def _box(switch: Switch) -> Axis:
    return Axis(switch.set, (False, True), (0.0, 1.0))
