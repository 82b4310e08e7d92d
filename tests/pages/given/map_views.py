"""A map of the registry as a page holds it, and the functions that draw it."""

from __future__ import annotations

from typing import Any

from sim.pages.map.bake import MapRun, bake_map
from sim.pages.map.render import render_map
from sim.scene.fence.map import read_map
from tests import registry
from tests.web.scene.given.widget_site import in_node

MAP: dict[str, Any] = {
    **registry.plain("light-meets-heavy"),
    "id": "speeds",
    "over": [
        {"set": "A.mass", "from": "0.5 kg", "to": "5 kg"},
        {"set": "contact.restitution", "from": 0, "to": 1},
    ],
    "show": "v.A",
    "points": 21,
}


def view(script: str, data: object = None) -> Any:
    """What the functions that draw maps give."""
    names = ("palette", "bands", "pixels", "table", "words")
    imports = "".join(f'const {n} = await import(view + "/map/{n}.js");\n' for n in names)
    return in_node(imports + script, data)


def scale_of(low: float, high: float) -> dict[str, Any]:
    made: dict[str, Any] = view("give(bands.scaleFor(...data));", [low, high])
    return made


def pixels(values: list[float | None], columns: int, scale: dict[str, Any]) -> list[list[int]]:
    """Colour numbers of the picture, row after row from the top."""
    made = view(
        """const values = Float64Array.from(data[0], (value) => value ?? NaN);
        const { places, width } = pixels.pixels(values, data[1], data[2]);
        give([[...places], width]);""",
        [values, columns, scale],
    )
    places, width = made
    return [places[k : k + width] for k in range(0, len(places), width)]


def rendered(**changes: Any) -> str:
    plain = {**MAP, **changes}
    described = read_map(plain)
    run = bake_map(described, plain)
    assert isinstance(run, MapRun)
    return render_map(described, plain, run)
