"""Carts of which the readings do not tell that they part are not said to part."""

from __future__ import annotations

from sim.measured.events.words import OUTCOMES, PARTED_PERHAPS, as_sure


def test_carts_whose_bounciness_may_be_zero_are_not_said_to_part() -> None:
    said = [OUTCOMES["bounce"], "another"]
    assert as_sure(said, [{"key": "e", "low": 0.0}]) == [PARTED_PERHAPS, "another"]
    assert as_sure(said, [{"key": "e", "low": 0.1}]) == said
    assert as_sure(said, [{"key": "mass_ratio", "low": 0.0}]) == said
