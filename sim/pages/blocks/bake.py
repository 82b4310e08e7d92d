"""The default run of a scene, computed when the site is built and baked into the page."""

from __future__ import annotations

import json
from array import array
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from sim.scene import Problem
from sim.scene.laws import has_formulas
from sim.scene.said import from_wire

FEW_CARTS = 3
SAMPLES_OF_MANY = 7
"""Per quarter swing, baked for more carts than a few: each sample costs every cart a row. Drawn as
cubics they are still right to 1e-5 of the amplitude; the live run that takes over has more."""

MANY_ROWS = 100
"""A run that would need more, say on a spring, gets the samples of many carts."""

MANY_STEPS = 20
SAMPLES_PER_STEP = {
    "adaptive": 1,
    "power-series": 2,
    "modes": 4,
    "pair-phase": 4,
    "pair-contact": 4,
}
"""A motion solved in many short steps is sampled in each of them: fewer do for the same picture."""

SAMPLES_OF_SPHERES = 3
"""Per stretch, of which a contact of spheres has many: ever shorter ones towards its ends."""

INTEGRATED = {"numpy", "scipy"}
"""What integrates contact laws without a closed form or a power series."""

MOST_KEPT = 256
"""Runs that a build remembers: more than the scenes of all lessons; some 30 kB each."""

OWN_LAW = "newtons-carts-law"
"""The package of the runtime that follows laws which somebody wrote."""


@dataclass(frozen=True, slots=True)
class Run:
    """A finished run as the wire delivers it: a header, and numbers column by column."""

    header: dict[str, Any]
    numbers: array[float]

    @property
    def packages(self) -> frozenset[str]:
        """The Python packages that the scene may need in the page."""
        return packages_of(self.header)


def packages_of(header: Mapping[str, Any]) -> frozenset[str]:
    """What the page of this run has to carry beside the standard library.

    A contact without a formula counts even where the default run never comes to it: a slider may.
    """
    planned = {name for phase in header["plan"] for name in phase["packages"]}
    written = {OWN_LAW} if "laws" in header else set()
    return frozenset(planned | written | (INTEGRATED if _formless(header) else set()))


def _formless(header: Mapping[str, Any]) -> bool:
    return not all(has_formulas(contact["law"]) for contact in header["contacts"])


def bake(scene: Mapping[str, Any]) -> Run | list[Problem]:
    """Run the scene (plain YAML values) with its defaults, or say why it cannot run."""
    untitled, title = without_title(scene)
    run = _kept(json.dumps(untitled, ensure_ascii=False))
    if run.header["ok"]:
        return Run(run.header | {"title": title}, run.numbers)
    return problems_of(run.header)


def problems_of(header: Mapping[str, Any]) -> list[Problem]:
    """Why a request was refused."""
    return [
        Problem(
            tuple(row["path"]),
            row["code"],
            from_wire(row["message"]),
            from_wire(row.get("hint", "")),
        )
        for row in header["problems"]
    ]


def without_title(scene: Mapping[str, Any]) -> tuple[dict[str, Any], str | None]:
    """The scene as it is run: the same in every language; and its title."""
    title = scene.get("title")
    if not isinstance(title, str):  # a mistake of the author stays one
        return dict(scene), None
    return {key: value for key, value in scene.items() if key != "title"}, title


@lru_cache(maxsize=MOST_KEPT)
def _kept(scene: str) -> Run:
    """The run of a scene in JSON. Nobody changes it: it serves every language, and the check."""
    return bake_with(json.loads(scene), {})


def bake_with(scene: Mapping[str, Any], changes: Mapping[str, Any]) -> Run:
    """The run of the scene with other values, or the header that says why there is none."""
    from sim.bridge.protocol import answer  # pulls the numerics: only when something is computed

    request: dict[str, Any] = {"id": 0, "kind": "run", "scene": scene, "set": changes}
    carts = scene.get("carts")
    if isinstance(carts, Mapping) and len(carts) > FEW_CARTS:
        request["samples"] = SAMPLES_OF_MANY
    header, numbers = answer(request)
    if header["ok"]:
        solvers = header["evaluations"]["solvers"]
        if _formless(header):
            header, numbers = answer(request | {"samples": SAMPLES_OF_SPHERES})
        elif solvers.get("adaptive", 0) + solvers.get("power-series", 0) > MANY_STEPS:
            fewer = max(SAMPLES_PER_STEP.get(name, 1) for name in solvers)
            header, numbers = answer(request | {"samples": fewer})
        elif header["rows"] > MANY_ROWS:
            header, numbers = answer(request | {"samples": SAMPLES_OF_MANY})
    return Run(header, numbers)
