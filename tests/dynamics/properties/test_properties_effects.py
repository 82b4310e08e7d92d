"""Laws of mechanics over random scenes in which effects act: every kind, every contact, mixed."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim.dynamics.result.trajectory import trajectory
from tests.dynamics.given.random_effects import acted_on
from tests.dynamics.given.random_runs import FEW, FEWER, HALF, finished
from tests.reference.contact_branches import UnsupportedError
from tests.reference.effects import integrate


def energy_scale(ledger: Any) -> float:
    """J. All that went to and fro."""
    stored = [abs(part) for both in ledger.potential.values() for part in both]
    parts = [ledger.energy_initial, ledger.energy_final, ledger.warmed, *ledger.works.values()]
    return math.fsum(map(abs, parts)) + math.fsum(stored) + 1e-3


@HALF
@given(acted_on())
def test_energy_changes_only_by_named_work_and_by_what_warmed_the_bumpers(
    plain: dict[str, Any],
) -> None:
    result = finished(plain)
    if result is None:
        return
    ledger = result.ledger
    rounding = 1e-10 * energy_scale(ledger)
    change = ledger.energy_final + ledger.warmed - ledger.energy_initial
    assert abs(change - math.fsum(ledger.works.values())) <= rounding
    for kind in ("friction", "drag", "spring"):
        assert ledger.works.get(kind, 0.0) <= rounding, kind
    assert ledger.works.get("release", 0.0) >= 0.0
    assert ledger.warmed >= -rounding


@given(acted_on())
def test_momentum_changes_only_by_named_impulses_from_outside(plain: dict[str, Any]) -> None:
    result = finished(plain)
    if result is None:
        return
    ledger = result.ledger
    assert not {"release", "bumper"} & set(ledger.impulses)
    moving = [c.mass * abs(v) for c, v in zip(result.scene.carts, result.v, strict=True)]
    started = [c.mass * abs(c.velocity) for c in result.scene.carts]
    scale = math.fsum([*moving, *started, *map(abs, ledger.impulses.values())]) + 1e-3
    change = ledger.momentum_final - ledger.momentum_initial
    assert abs(change - math.fsum(ledger.impulses.values())) <= 1e-10 * scale


FLASH = 1e-12
"""s."""

AGREE = 1e-7
"""m and m/s, of 1. The integration is good to 1e-11; a contact or two later that has grown."""


@FEWER
@given(acted_on(most=2))
def test_every_run_agrees_with_an_independent_integration(plain: dict[str, Any]) -> None:
    result = finished(plain)
    if result is None:
        return
    try:
        expected = integrate(result.scene, most_steps=250)
    except UnsupportedError:
        return
    if expected.changes > FEW:
        return
    assert result.outcome.kind != "too-many-events"
    scale = AGREE * max(1.0, *map(abs, expected.v))
    assert list(result.v) == pytest.approx(expected.v, abs=scale)
    assert list(result.x) == pytest.approx(expected.x, abs=scale)
    for kind, work in expected.work.items():
        if kind in result.ledger.works:
            assert result.ledger.works[kind] == pytest.approx(work, rel=1e-6, abs=1e-7)


@given(acted_on())
def test_the_acceleration_of_a_cart_is_the_sum_of_its_named_forces(plain: dict[str, Any]) -> None:
    """And a force between two bodies is one number: minus on the left one, plus on the right."""
    result = finished(plain)
    if result is None:
        return
    columns = trajectory(result, 4).columns
    times = columns[("t",)]
    flashes = set()  # a contact shorter than 1e-12 s of a dying rattle cannot be drawn
    for row, (one, two) in enumerate(pairwise(times)):
        if 0.0 < two - one < FLASH:
            flashes |= {row, row + 1}
    for k, cart in enumerate(result.scene.carts):
        left = ("F", "-".join(result.scene.names_at(k)))
        right = ("F", "-".join(result.scene.names_at(k + 1)))
        outer = [column for name, column in columns.items() if name[0::2] == ("E", cart.name)]
        pushed = [columns[left]] if left in columns else []
        pulled = [columns[right]] if right in columns else []
        named = [*outer, *pushed, *pulled]
        scale = max((abs(force) for column in named for force in column), default=0.0) + 1e-6
        for row, a in enumerate(columns["a", cart.name]):
            if row in flashes:
                continue
            total = math.fsum(column[row] for column in [*outer, *pushed])
            total -= math.fsum(column[row] for column in pulled)
            assert abs(cart.mass * a - total) <= 1e-9 * scale, (cart.name, row)


@FEWER
@given(acted_on())
def test_what_is_kept_does_not_change_a_run_with_effects(plain: dict[str, Any]) -> None:
    full = finished(plain)
    if full is None:
        return
    trajectory(full)
    bare = finished(plain, keep_events=False, keep_motion=False)
    assert (full.x, full.v, full.t) == (bare.x, bare.v, bare.t)
    assert full.effects == bare.effects
    told = {kind: count for kind, count in full.record.counts.items() if kind != "peak"}
    assert told == {kind: count for kind, count in bare.record.counts.items() if kind != "peak"}


@HALF
@given(acted_on(most=3), st.randoms(use_true_random=False))
def test_names_and_the_order_of_the_lists_do_not_matter(plain: dict[str, Any], dice: Any) -> None:
    one = finished(plain)
    if one is None or sum(one.record.counts.values()) > FEW:
        return
    other = {f"c{k}": f"{'zyxwv'[k]}{k}" for k in range(5)}

    def renamed(value: Any) -> Any:
        if isinstance(value, dict):
            return {
                "-".join(other.get(p, p) for p in k.split("-")): renamed(v)
                for k, v in value.items()
            }
        if isinstance(value, list):
            return [renamed(item) for item in value]
        return other.get(value, value) if isinstance(value, str) else value

    twin = renamed(plain)
    carts, effects = list(twin["carts"].items()), list(twin["effects"])
    dice.shuffle(carts)
    dice.shuffle(effects)
    two = finished(twin | {"carts": dict(carts), "effects": effects})
    if effects == renamed(plain)["effects"]:
        assert (one.x, one.v) == (two.x, two.v)
    assert list(one.v) == pytest.approx(list(two.v), abs=1e-9)
    assert list(one.x) == pytest.approx(list(two.x), abs=1e-9)
