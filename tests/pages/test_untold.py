"""What a page gets of a scene that asks first: its set-up, and nothing that its run would tell."""

from __future__ import annotations

from typing import Any

from sim.dynamics.loop.run import run
from sim.dynamics.report.document import report
from sim.pages.widget.baked import baked_values
from sim.scene import read_scene
from tests.web.scene.given.widget_site import CHOICE, baked

SQUEEZED: dict[str, Any] = {
    **CHOICE,
    "contact": {"restitution": 0.8, "stiffness": "20 N/m"},  # too soft for its bumpers
    "effects": [{"friction": {"coefficient": 0.002}}],
}


def test_nothing_that_is_told_of_a_run_is_baked_into_a_scene_that_asks_first() -> None:
    asked, header, numbers = baked(SQUEEZED)
    told = report(run(read_scene(asked.plain))).keys() - {"format"}
    assert all(header[key] for key in told)
    values = baked_values(asked, header, numbers)
    assert {key: values[key] for key in told if values.get(key)} == {}
    assert all(len(column) <= 1 for column in values["numbers"]["x"].values())


def test_a_scene_that_does_not_ask_tells_its_warnings_at_once() -> None:
    free, header, numbers = baked({k: v for k, v in SQUEEZED.items() if k != "predict"})
    assert baked_values(free, header, numbers)["warnings"] == header["warnings"] != []
