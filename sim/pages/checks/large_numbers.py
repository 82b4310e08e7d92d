"""Hints where a plain number was probably meant in g, cm or cm/s: it is in kg, m, m/s."""

from __future__ import annotations

from collections.abc import Iterator

from sim.pages.blocks.scene_block import SceneBlock
from sim.pages.findings import Finding
from sim.scene.problem import Problem

USUAL = {
    "mass": (20.0, "kg", "g"),
    "velocity": (10.0, "m/s", "cm/s"),
    "position": (10.0, "m", "cm"),
    "length": (10.0, "m", "cm"),
}
"""No cart and no track of a school has more; a scene may, and then says its unit."""


def large_numbers(scene: SceneBlock) -> Iterator[Finding]:
    """Numbers without a unit of carts and track that are larger than those of a school."""
    plain = scene.fence.plain
    tables: dict[tuple[str, ...], object] = {("track",): plain.get("track")}
    tables |= {("carts", name): cart for name, cart in plain.get("carts", {}).items()}
    for path, table in tables.items():
        for key, (most, unit, smaller) in USUAL.items():
            number = table.get(key) if isinstance(table, dict) else None
            if isinstance(number, (int, float)) and abs(number) > most:
                told = (
                    f"a plain {key} is in {unit}. For {number:g} {smaller} write "
                    f"{key}: {number:g} {smaller}; if {number:g} {unit} is meant, write the unit"
                )
                problem = Problem((*path, key), "large-number", told, "")
                yield scene.places.finding(problem).as_hint(told)
