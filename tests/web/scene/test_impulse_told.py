"""The line below the graph of the force tells as many numbers as it has."""

from __future__ import annotations

from tests.web.scene.given.widget_site import in_node

SCRIPT = """
const { ImpulseLayer } = await import(`${source}/scene/graphs/impulse-layer.js`);
const fake = () => ({ textContent: "", children: [], getAttribute: () => null, setAttribute() {} });
const [areas, note] = [Object.assign(fake(), { children: [fake(), fake()] }), fake()];
const root = { querySelector: (name) => (name.startsWith(".") ? note : areas) };
const layer = new ImpulseLayer(root, { decimals: { p: 3 } });
const bodies = ["A", "B"];
const events = [{ kind: "contact", t: 0, bodies }, { kind: "separate", t: 1, bodies, before: {} }];
const effect = { active: true, kind: "friction", carts: data.rubbed };
const run = {
  header: { until: 2, track: {}, events, contacts: [], effects: [effect],
    bodies: bodies.map((name) => ({ name, mass: 1 })) },
  trajectory: { t: [0, 1, 2], F: { "A-B": [1.5, 1.5, 0] }, dF: { "A-B": [0, 0, 0] },
    v: { A: [1, 0, 0], B: [0, 1, 1] }, a: {} },
};
const axis = { low: 0, high: 2, step: 1 };
layer.show(run);
layer.at(run, { time: axis, value: axis }, 1, false);
give(note.textContent);
"""


def told(*rubbed: str) -> str:
    return str(in_node(SCRIPT, {"rubbed": rubbed}))


def test_one_number_is_not_called_all() -> None:
    """Where friction acts too, no change of momentum is told: “1.530, all in N s.”"""
    assert told("A", "B") == "A–B, shaded area: 1.500 N\u00a0s"
    assert told("A").endswith("m\u00a0Δv of B: 1.000, all in N\u00a0s.")
