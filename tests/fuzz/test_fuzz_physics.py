"""A few scenes of every kind of the adversary; `make fuzz AREA=physics` runs as many as wanted."""

from __future__ import annotations

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.outcome import UnsolvedError
from sim.scene import SceneError, read_scene
from tests.fuzz.kinds import KINDS, scene_of
from tests.fuzz.shrink import plainest
from tests.fuzz.verdict import Verdict, judge, units_of

SOME = 8
EVENTS = 3_000
DEAD = (1, 4, 5, 11, 15)
"""Numbers of dead bumpers that the oracle follows quickly."""


@pytest.mark.parametrize("kind", KINDS)
def test_random_scenes_neither_crash_nor_leave_their_accounts_open(kind: str) -> None:
    for seed in range(SOME):
        try:
            scene = read_scene(scene_of(kind, seed))
            done = run(scene, max_events=EVENTS, max_steps=EVENTS)
        except (SceneError, UnsolvedError):
            continue
        assert done.ledger.imbalance() < 1e-10, (kind, seed)


def test_a_scene_of_a_kind_and_a_number_is_the_same_for_ever() -> None:
    for kind in KINDS:
        assert scene_of(kind, 7) == scene_of(kind, 7)
        assert scene_of(kind, 7) != scene_of(kind, 8)


def test_in_units_that_are_powers_of_two_the_same_run_comes_out_to_the_last_bit() -> None:
    compared = 0
    for seed in range(2 * SOME):
        plain = scene_of("scales", seed)
        if units_of(plain) == (1.0, 1.0, 1.0):
            continue
        found = judge(plain)
        assert found.word != "scale", (seed, found.detail)
        compared += found.word == "right"
    assert compared >= 3


def test_bumpers_that_give_nothing_back_end_as_the_oracle_says() -> None:
    """Held by what presses, let go, pressed further: it knows the law from its definition."""
    words = [judge(scene_of("dead bumpers", seed)).word for seed in DEAD]
    assert words == ["right"] * len(DEAD)


def test_the_plainest_scene_of_a_finding_is_found_again() -> None:
    """A refusal stands for a finding: magnets too weak. What is beside them is left out."""
    plain = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.1, "velocity": 1.0},
            "B": {"mass": 2.0, "position": 0.4, "velocity": -1.0},
            "C": {"mass": 3.0, "position": 5.0, "velocity": 0.0},
        },
        "contact": {"law": "paper", "restitution": 1, "stiffness": 500},
        "effects": [
            {"magnets": {"between": ["A", "B"], "strength": 1e-12, "power": 2}},
            {"drag": {"linear": 0.01}},
        ],
        "until": 3.0,
    }
    assert judge(plain, oracle=False).word == "refused"
    small = plainest(plain, Verdict("refused"))
    assert list(small["carts"]) == ["A", "B"]
    assert [next(iter(effect)) for effect in small["effects"]] == ["magnets"]
