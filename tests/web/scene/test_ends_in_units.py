"""Runs side by side are told in the units and with the decimals of their scene."""

from __future__ import annotations

from typing import Any

from tests.web.scene.given.widget_site import in_node

SCRIPT = """
const { parseHTML } = await import("linkedom");
globalThis.document = parseHTML("<html><body></body></html>").document;
const { ends } = await import(`${source}/worlds/ends.js`);
const v = Float64Array.of(data.speed, data.speed / 2);
const run = {
  header: { bodies: [{ name: "A", mass: 0.5 }], contacts: [] },
  trajectory: { t: Float64Array.of(0, 1), v: { A: v } },
};
const scales = { velocity: data.speed, decimals: data.decimals };
const table = ends([{ label: "Our world", run }], scales);
give([...table.querySelectorAll("td")].map((cell) => cell.textContent).filter(Boolean));
"""


def told(speed: float, **decimals: int) -> list[Any]:
    return list(in_node(SCRIPT, {"speed": speed, "decimals": decimals}))


def test_a_creeping_cart_is_told_in_millimetres() -> None:
    assert told(0.004, v=1, p=5) == ["2.0 mm/s", "0.00200 → 0.00100 N s"]


def test_momentum_is_told_in_newton_seconds_whatever_the_unit_of_speed() -> None:
    assert told(4.0, v=2, p=1) == ["2.00 m/s", "2.0 → 1.0 N s"]
