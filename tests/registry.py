"""The scenes in tests/scenes and in the folders of the effects: one registry for tests, browser
tests, gallery and benchmarks."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sim.pages.text.yaml.source import load
from sim.scene import Scene, read_scene

ROOT = Path(__file__).parents[1]
PATHS = {
    path.stem: path
    for folder in ("tests/scenes", "sim/effects/*/scenes")
    for path in ROOT.glob(f"{folder}/*.yml")
}
NAMES = sorted(PATHS)


def plain(name: str) -> dict[str, Any]:
    """The plain values of one scene file."""
    return dict(load(PATHS[name].read_text(encoding="utf-8")).plain)


def scene(name: str) -> Scene:
    """One scene of the registry."""
    return read_scene(plain(name))


def two_carts(
    *,
    masses: tuple[Any, Any] = (1, 2),
    velocities: tuple[Any, Any] = (1, "-0.5"),
    gap: Any = "0.6",
    until: Any = 1,
    **contact: Any,
) -> dict[str, Any]:
    """Plain values of two carts, `gap` metres between their bumpers."""
    return {
        "carts": {
            "A": {"mass": masses[0], "position": 0, "velocity": velocities[0]},
            "B": {
                "mass": masses[1],
                "position": f"{0.2 + float(gap):.12g}",
                "velocity": velocities[1],
            },
        },
        "contact": contact,
        "until": until,
    }
