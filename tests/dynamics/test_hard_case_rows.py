"""Every hard case of the table ends as its source says."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.run import run
from sim.scene import read_scene
from tests.hard_cases import COLLISIONS, HardCase
from tests.hard_cases_effects import UNDER_EFFECTS

ROWS = (*COLLISIONS, *UNDER_EFFECTS)


def measure(result: Any, what: str) -> float:
    """One number of a finished run: see `Expected.what`."""
    kind, _, name = what.partition(".")
    carts = [cart.name for cart in result.scene.carts]
    if kind in "vx":
        values = dict(zip(carts, result.v if kind == "v" else result.x, strict=True))
        if "+" in name:
            return math.fsum(values[part] for part in name.split("+"))
        if "-" in name:
            last, first = name.split("-")
            return values[last] - values[first]
        return values[name]
    if kind == "work":
        return result.ledger.works[name]
    if kind == "count":
        return result.record.counts[name]
    if kind == "last":
        return max(event.t for event in result.record.events if event.kind == name)
    return {
        "t": result.t,
        "warmed": result.ledger.warmed,
        "energy": result.ledger.energy_final,
    }[kind]


@pytest.mark.parametrize("case", ROWS, ids=lambda case: case.name)
def test_a_hard_case_ends_as_its_source_says(case: HardCase) -> None:
    result = run(read_scene(case.plain), keep_events=case.events, keep_motion=case.events)
    for expected in case.expected:
        got = measure(result, expected.what)
        assert abs(got - expected.value) <= expected.tolerance, (expected.what, got, case.why)


def test_names_are_used_once() -> None:
    names = [case.name for case in ROWS]
    assert len(names) == len(set(names)) >= 40
