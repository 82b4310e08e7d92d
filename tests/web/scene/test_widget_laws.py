"""What the views draw obeys the laws they teach, and agrees with the program's own ledger."""

from __future__ import annotations

from typing import Any

import pytest

from sim.bridge.protocol import answer
from tests import registry
from tests.web.scene.given.widget_site import in_node
from tests.web.scene.given.wired import READ, wired

ROUNDING = 1e-9  # of the scene's own scale: sums of some thousand rows

LASTING = [
    name
    for name in registry.NAMES
    if name != "slow-and-long" and not registry.plain(name).get("effects")
]


def runs(names: list[str]) -> list[dict[str, Any]]:
    """Headers with their numbers, of scenes that can be run."""
    found = []
    for name in names:
        header, numbers = answer({"id": 0, "kind": "run", "scene": registry.plain(name)})
        if header["ok"]:
            found.append({"name": name, "header": header, "numbers": list(numbers)})
    return found


@pytest.fixture(scope="module")
def views() -> list[dict[str, Any]]:
    """For each scene: areas under the forces, m Δv, the energy ledger at its end, momentum."""
    made = runs(LASTING)
    seen = in_node(
        """const { fromWire } = await import(view + "/trajectory.js");
        const { touches } = await import(view + "/windows.js");
        const { area, changes } = await import(view + "/impulse.js");
        const { ledger } = await import(view + "/ledger.js");
        const { seriesOf } = await import(view + "/series.js");
        const { contactForces } = await import(view + "/forces.js");
        give(data.map(({ header, numbers }) => {
          const run = { header, trajectory: fromWire(header, Float64Array.from(numbers)) };
          const windows = touches(header.events, header.until);
          const sums = seriesOf("p", header, run.trajectory, 0).filter((c) => c.style === "total");
          const entries = ledger(run, windows, 0);
          const middle = windows.map(({ start, end }) => (start + end) / 2);
          return {
            touches: windows.map((w) => ({ pair: w.pair, area: area(run, w.pair, w.start, w.end),
              open: w.end >= header.until,
              changes: changes(run, windows, w, w.end) })),
            spread: sums.map(({ values }) => Math.max(...values) - Math.min(...values)),
            least: Math.min(...entries.flatMap(({ values }) => [...values])),
            sums: [0, 1].map((end) => entries.reduce((s, { values }) =>
              s + values.at(end - 1 < 0 ? 0 : -1), 0)),
            kinetic: header.bodies.reduce((s, { name, mass }) =>
              s + mass * header.final.v[name] ** 2 / 2, 0),
            warmed: entries.at(-1).values.at(-1), stored: entries.at(-2).values.at(-1),
            forces: middle.map((t) => header.bodies.flatMap(({ name }) =>
              contactForces(run, name, t, 0).map(({ on, by, value }) => [on, by, value]))),
          };
        }));""",
        made,
    )
    return [{**run, **view} for run, view in zip(made, seen, strict=True)]


def test_the_shaded_area_is_the_change_of_momentum_of_both(views: list[dict[str, Any]]) -> None:
    compared = 0
    for view in views:
        scale = max(b["mass"] * abs(b["velocity"]) for b in view["header"]["bodies"]) or 1.0
        for touch in view["touches"]:
            for change, sign in zip(touch["changes"], (-1, 1), strict=True):
                if change["change"] is not None:
                    compared += 1
                    # between two rows the force is a cubic through the true values
                    assert change["change"] == pytest.approx(
                        sign * touch["area"], abs=2e-4 * scale
                    ), (view["name"], touch)
    assert compared > 10


def test_what_a_cart_gets_its_partner_gets_the_other_way(views: list[dict[str, Any]]) -> None:
    compared = 0
    for view in views:
        for forces in view["forces"]:
            found = {(on, by): value for on, by, value in forces}
            for (on, by), value in found.items():
                if (by, on) in found:
                    compared += 1
                    assert value == -found[by, on]
    assert compared > 10


def test_with_the_wall_and_the_earth_momentum_stays(views: list[dict[str, Any]]) -> None:
    for view in views:
        scale = sum(b["mass"] * abs(b["velocity"]) for b in view["header"]["bodies"]) or 1.0
        assert max(view["spread"], default=0.0) <= ROUNDING * scale, view["name"]


def test_the_energy_ledger_adds_up_and_ends_as_the_program_counts(
    views: list[dict[str, Any]],
) -> None:
    for view in views:
        energy = view["header"]["energy"]
        scale = energy["initial"] or 1.0
        assert view["sums"] == pytest.approx([energy["initial"]] * 2, rel=ROUNDING), view["name"]
        assert view["least"] >= -ROUNDING * scale
        gone = view["warmed"] + view["stored"]
        kept = energy["final"] + energy["warmed"] - energy["initial"]
        assert kept == pytest.approx(0.0, abs=ROUNDING * scale)
        assert gone == pytest.approx(energy["initial"] - view["kinetic"], abs=ROUNDING * scale)
        if not any(touch["open"] for touch in view["touches"]):
            assert view["warmed"] == pytest.approx(energy["warmed"], abs=ROUNDING * scale)


def test_what_bumpers_hold_as_a_run_ends_has_not_warmed_them() -> None:
    """Elastic ones gave back what "warmed" them; what never springs back is warm at its peak."""
    carts = {
        "A": {"mass": 1, "position": 0.3, "velocity": 1},
        "B": {"mass": 1, "position": 0.7},
    }
    bumper = {"law": "bumper", "restitution": 1, "stiffness": 50}
    hertz = {"law": "hertz", "restitution": 0, "stiffness": 5000}
    ends = in_node(
        READ
        + """const { touches } = await import(view + "/windows.js");
        const { ledger } = await import(view + "/ledger.js");
        give(data.map((one) => {
          const run = opened(one);
          const entries = ledger(run, touches(run.header.events, run.header.until), 0);
          return entries.slice(-2).map(({ values }) => [Math.max(...values), values.at(-1)]);
        }));""",
        [
            wired({"carts": carts, "contact": bumper, "until": 0.45}),
            wired({"carts": carts, "contact": hertz, "until": 0.45}),
        ],
    )
    (held, warmed), (_, warm) = ends
    assert held == [pytest.approx(0.25, abs=1e-3), pytest.approx(0.08954, abs=1e-5)]
    assert warmed == [pytest.approx(0.0, abs=1e-12)] * 2
    assert warm == [pytest.approx(0.25, abs=1e-4)] * 2  # the two still become equally fast
