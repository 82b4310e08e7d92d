"""The options of `carts fit` as one value, and what each part of it takes from them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

from sim.cli.measured.cart_options import named, quantity, segments, values_by_cart, weighed
from sim.measured.analysis import Wanted
from sim.measured.events.story import Hints
from sim.measured.model.unknowns import Effect
from sim.measured.units import Units
from sim.scene.quantity import LENGTH, TIME

ASKED: dict[tuple[bool, bool], Effect] = {
    (True, False): "friction", (False, True): "tilt", (True, True): "both",
}  # fmt: skip
"""By --friction and --tilt."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Options:
    """As click hands them over; what each one means stands beside it in `fit`."""

    as_json: bool
    law: str
    friction: bool
    tilt: bool
    contact: str | None
    spans: tuple[str, ...]
    flips: tuple[str, ...]
    zeros: tuple[str, ...]
    masses: tuple[str, ...]
    touch: str | None
    together: bool
    begin: str | None
    end: str | None
    length: str
    time: str
    force: str
    run: str
    scene_file: Path | None
    tracker_file: Path | None

    @property
    def units(self) -> Units:
        """How the files are read where they name no unit, and which run of a log."""
        return Units(time=self.time, length=self.length, force=self.force, run=self.run)

    def wanted(self, names: tuple[str, str]) -> Wanted:
        """What is fitted to the motion of carts with these names."""
        hints = Hints(
            at=quantity("--contact", self.contact, TIME),
            flips=named("--flip", self.flips, names),
            zeros=values_by_cart("--zero", self.zeros, names, LENGTH, "A=12.5cm"),
            distance=quantity("--touch", self.touch, LENGTH),
            together=self.together,
            segments=segments("--segment", self.spans, names),
        )
        effect, weights = ASKED.get((self.friction, self.tilt)), weighed(self.masses, names)
        return Wanted(law=cast(Any, self.law), effect=effect, masses=weights, hints=hints)
