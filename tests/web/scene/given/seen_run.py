"""The run of a scene as the functions of `sim/view` get it."""

from __future__ import annotations

from typing import Any

from tests.web.scene.given.widget_site import baked, in_node

READ = """const t = await import(view + "/trajectory.js");
const run = { header: data.header, trajectory:
  { ...t.fromWire(data.header, Float64Array.from(data.numbers)), events: data.header.events } };
"""


def seen(plain: dict[str, Any], script: str, **more: Any) -> Any:
    """What a script of the view makes of the run of a scene."""
    _, header, numbers = baked({"id": "one", **plain})
    return in_node(READ + script, {"header": header, "numbers": numbers.tolist(), **more})
