"""Laws of mechanics over random scenes: any carts, any walls, any contact laws, mixed."""

from __future__ import annotations

import math
from typing import Any

from hypothesis import given

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import trajectory
from sim.scene import read_scene
from tests.dynamics.given.random_rows import scenes

MOST = 3_000
"""Events. Some random scenes have infinitely many; they are stopped, and the laws hold."""


def finished(plain: dict[str, Any]) -> Any:
    return run(read_scene(plain), max_events=MOST)


@given(scenes())
def test_momentum_and_energy_are_accounted_for(plain: dict[str, Any]) -> None:
    result = finished(plain)
    ledger, carts = result.ledger, result.scene.carts
    scale = math.fsum(c.mass * abs(c.velocity) for c in carts) + 1e-9
    events = sum(result.record.counts.values())
    rounding = 1e-14 * (10 + events)
    change = ledger.momentum_final - ledger.momentum_initial
    assert abs(change - ledger.external) <= rounding * scale
    energy = ledger.energy_initial + 1e-9
    assert abs(ledger.energy_initial - ledger.energy_final - ledger.warmed) <= rounding * energy
    assert ledger.energy_final <= ledger.energy_initial + rounding * energy


@given(scenes())
def test_carts_keep_their_order_and_nobody_passes_a_wall(plain: dict[str, Any]) -> None:
    result = finished(plain)
    carts = result.scene.carts
    deepest = {gap: depth for gap, (depth, _) in result.record.deepest.items()}
    slack = 1e-9
    for k in range(len(carts) - 1):
        room = result.x[k + 1] - result.x[k] - 0.5 * (carts[k].length + carts[k + 1].length)
        assert room >= -deepest.get(k + 1, 0.0) - slack
    if result.scene.track.left == "wall":
        assert result.x[0] - 0.5 * carts[0].length >= -deepest.get(0, 0.0) - slack


@given(scenes())
def test_every_impulse_is_equal_and_opposite(plain: dict[str, Any]) -> None:
    result = finished(plain)
    masses = {cart.name: cart.mass for cart in result.scene.carts}
    alone = {cart.name for cart in result.scene.carts}
    for event in result.record.events[:-1]:
        assert event.impulse >= -1e-12
        if event.kind != "contact" or event.force is not None:
            continue  # others may push the same carts in the meantime
        for body in event.bodies:
            if body in alone and len(masses) == 2 and "velcro" not in str(plain["contact"]):
                change = masses[body] * abs(event.after[body] - event.before[body])
                assert math.isclose(change, event.impulse, rel_tol=1e-9, abs_tol=1e-12)


@given(scenes())
def test_what_is_kept_does_not_change_the_run(plain: dict[str, Any]) -> None:
    full = finished(plain)
    bare = run(read_scene(plain), max_events=MOST, keep_events=False, keep_motion=False)
    assert (full.x, full.v, full.t) == (bare.x, bare.v, bare.t)


@given(scenes())
def test_the_drawn_motion_is_finite_ordered_and_ends_where_the_run_ends(
    plain: dict[str, Any],
) -> None:
    result = finished(plain)
    columns = trajectory(result).columns
    times = columns[("t",)]
    assert list(times) == sorted(times)
    assert (times[0], times[-1]) == (0.0, result.t)
    for column in columns.values():
        assert all(math.isfinite(value) for value in column)
    for k, cart in enumerate(result.scene.carts):
        assert math.isclose(columns[("x", cart.name)][-1], result.x[k], abs_tol=1e-9, rel_tol=1e-9)


@given(scenes())
def test_the_mirror_image_of_a_run_is_the_run_of_the_mirror_image(plain: dict[str, Any]) -> None:
    """Compared over the first few contacts: later, rounding may decide which of two comes first."""
    length = float(plain["track"]["length"])
    turned = {"left": "right", "right": "left"}
    mirror = plain | {
        "carts": {
            name: cart
            | {
                "position": f"{length - float(cart['position']):.6f}",
                "velocity": f"{-float(cart['velocity']):.3f}",
            }
            for name, cart in plain["carts"].items()
        },
        "track": {
            "left": plain["track"]["right"],
            "right": plain["track"]["left"],
            "length": plain["track"]["length"],
        },
    }
    pairs = plain["contact"].get("pairs", {})
    if pairs:
        ((name, contact),) = pairs.items()
        swapped = "-".join(turned.get(part, part) for part in reversed(name.split("-")))
        mirror["contact"] = {**plain["contact"], "pairs": {swapped: contact}}
    one, two = finished(plain), finished(mirror)
    if sum(one.record.counts.values()) > 12:
        return
    for k in range(len(one.v)):
        assert math.isclose(one.v[k], -two.v[-1 - k], abs_tol=1e-8)
