"""Ready-made settings: which button a page takes as pressed before anybody pressed one."""

from __future__ import annotations

from typing import Any

import pytest

from sim.pages.widget.baked import baked_values
from tests.web.scene.given.widget_site import baked, in_node

PRESETS: dict[str, dict[str, Any]] = {
    "500 g": {"A.mass": "500 g"},
    "one tonne": {"A.mass": "1 t"},
    "as it begins": {
        "A.mass": "500000 mg",
        "contact.restitution": "80 %",
        "friction.coefficient": 0,
    },
    "another law": {"A.mass": 0.5, "contact.law": "paper"},
}


def pressed(mass: str) -> list[str]:
    """Of a scene with this mass of A."""
    scene = {
        "id": "presets",
        "carts": {
            "A": {"mass": mass, "position": "0.4 m", "velocity": "0.6 m/s"},
            "B": {"mass": "1 kg", "position": "1.3 m"},
        },
        "contact": {"restitution": 0.8, "stiffness": 400},
        "effects": [{"friction": {"coefficient": 0, "active": False}}],
        "until": "2 s",
        "presets": {name: dict(changes) for name, changes in PRESETS.items()},
    }
    values = baked_values(*baked(scene))
    found = in_node(
        """globalThis.document = { documentElement: { dataset: {} }, getElementById: () => null };
        const { Presets } = await import(source + "/scene/presets.js");
        const buttons = Object.keys(data.fence.presets).map((preset) => {
          const kept = new Map();
          return { dataset: { preset }, addEventListener() {},
            getAttribute: (key) => kept.get(key) ?? null,
            setAttribute: (key, value) => kept.set(key, value) };
        });
        const root = { querySelectorAll: () => buttons, querySelector: () => null };
        const presets = new Presets(root, data.fence, () => {});
        presets.show({}, data);
        give(presets.pressed);""",
        values,
    )
    assert isinstance(found, list)
    return found


@pytest.mark.parametrize(
    ("mass", "names"),
    [("0.5 kg", ["500 g", "as it begins"]), ("1 kg", []), ("1000 kg", ["one tonne"])],
)
def test_a_button_counts_as_pressed_where_the_run_has_its_values_in_whatever_unit(
    mass: str, names: list[str]
) -> None:
    assert pressed(mass) == names
