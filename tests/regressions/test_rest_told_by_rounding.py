"""Contacts in which rounding is all that is left of a rate: they rest, and the run goes on."""

from __future__ import annotations

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene
from tests.fuzz.kinds import scene_of

RESTING = {
    "impacts at rest that part by rounding": ("rest on slopes", 60),
    "a cart that a spring draws from the wall where it rests": ("scales", 31),
}


@pytest.mark.parametrize("what", RESTING)
def test_a_contact_that_rests_but_for_rounding_does_not_touch_for_ever(what: str) -> None:
    done = run(read_scene(scene_of(*RESTING[what])), max_events=5_000)
    assert done.stopped is None
    assert done.ledger.imbalance() < 1e-10
