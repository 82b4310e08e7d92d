"""The default run of a scene, computed when the site is built and baked into the page."""

from __future__ import annotations

from array import array
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sim.scene import Problem

FEW_CARTS = 3
SAMPLES_OF_MANY = 7
"""Per quarter swing, baked for more carts than a few: each sample costs every cart a row. Drawn as
cubics they are still right to 1e-5 of the amplitude; the live run that takes over has more."""


@dataclass(frozen=True, slots=True)
class Run:
    """A finished run as the wire delivers it: a header, and numbers column by column."""

    header: dict[str, Any]
    numbers: array[float]

    @property
    def packages(self) -> frozenset[str]:
        """The Python packages that the run's plan needs in the page."""
        return frozenset(name for phase in self.header["plan"] for name in phase["packages"])


def bake(scene: Mapping[str, Any]) -> Run | list[Problem]:
    """Run the scene (plain YAML values) with its defaults, or say why it cannot run."""
    from sim.bridge.protocol import answer  # pulls the numerics: only when something is computed

    request = {"id": 0, "kind": "run", "scene": scene}
    carts = scene.get("carts")
    if isinstance(carts, Mapping) and len(carts) > FEW_CARTS:
        request["samples"] = SAMPLES_OF_MANY
    header, numbers = answer(request)
    if header["ok"]:
        return Run(header, numbers)
    return [
        Problem(tuple(row["path"]), row["code"], row["message"], row.get("hint", ""))
        for row in header["problems"]
    ]
