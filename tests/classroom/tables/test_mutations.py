"""Hostile tables and summaries, a few of those that `make fuzz AREA=classroom` tries."""

from __future__ import annotations

import random

import pytest

from tests.classroom.given.mutations import KINDS

FEW = 60
"""Mutations of each kind in CI; the command tries 10,000."""


@pytest.mark.parametrize("kind", KINDS)
def test_a_mutated_file_is_refused_in_words_or_gives_a_sound_report(kind: str) -> None:
    seen = {KINDS[kind](random.Random(seed)) for seed in range(FEW)}
    assert len(seen) > 1  # some are refused, some are not: else nothing was tried
