"""The world in which the second force comes later: all of it comes, and to whom it is owed."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import pytest

from sim.worlds.breaks import broken
from tests.worlds.scenes import HEAVY_INTO_LIGHT, followed

LATE = 2e-4
"""Of a velocity. A late force is read off along straight lines between the ends of steps."""


def one_into(law: str, restitution: float, until: float) -> dict[str, Any]:
    """A cart into one of twice its mass."""
    return {
        "carts": {
            "A": {"mass": 1.0, "position": 0.4, "velocity": 1.0},
            "B": {"mass": 2.0, "position": 1.2},
        },
        "contact": {"law": law, "restitution": restitution, "stiffness": 200},
        "until": until,
    }


@pytest.mark.parametrize("delay", [0.05, 0.2, 0.8])
def test_a_late_reaction_gives_the_momentum_back_late(delay: float) -> None:
    """The one that is hit leaves as from a moving wall; the other gets all of its impulse later."""
    done = followed(HEAVY_INTO_LIGHT, {"reaction-comes-later": {"delay": delay}})
    found = broken(done)
    swing = math.pi / 2 * math.sqrt(0.5 / 100)  # how long the light one presses in
    if delay > 1.8 * swing:  # the contact is over before anything comes back
        struck = 0.4 * 1.8
        assert done.run.v[1] == pytest.approx(struck, rel=LATE)
        assert done.run.v[0] == pytest.approx(0.4 - 0.5 / 2.0 * struck, rel=LATE)
        assert found.most == pytest.approx(0.5 * struck, rel=1e-3)
    assert found.momentum == 0.0
    assert 2.0 * done.run.v[0] + 0.5 * done.run.v[1] == pytest.approx(0.8, rel=LATE)


@pytest.mark.parametrize("delay", [1e-4, 0.3])
@pytest.mark.parametrize("law", ["bumper", "paper", "push-only", "hertz"])
@pytest.mark.parametrize("restitution", [0.3, 1.0])
def test_all_that_comes_late_has_come_in_the_end(
    law: str, restitution: float, delay: float
) -> None:
    """Whatever jumps where they touch, and though trial steps look past the end of the contact."""
    plain = one_into(law, restitution, until=8.0)
    done = followed(plain, {"reaction-comes-later": {"delay": delay}})
    assert done.run.v[0] + 2.0 * done.run.v[1] == pytest.approx(1.0, abs=LATE)
    assert broken(done).momentum == 0.0


def test_how_long_a_run_goes_on_does_not_change_what_came_late() -> None:
    ends = [
        followed(one_into("paper", 0.3, until), "reaction-comes-later").run.v
        for until in (2.0, 60.0)
    ]
    assert ends[0] == pytest.approx(ends[1], abs=1e-9)


def test_what_is_owed_to_a_cart_comes_to_it_though_the_other_has_run_into_it_since() -> None:
    """B comes back from the wall and is the faster one when A's own push is still to come."""
    plain = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.4, "velocity": 1.0},
            "B": {"mass": 1.0, "position": 0.8},
        },
        "contact": {"restitution": 1.0, "stiffness": 2000},
        "track": {"right": "wall", "length": 1.0},
        "until": 1.5,
    }
    done = followed(plain, {"reaction-comes-later": {"delay": 0.5}})
    books = done.run.ledger
    walls = books.momentum_final - books.momentum_initial
    on_a, on_b = (done.samples.columns["on", "A-B", name] for name in "AB")
    t = done.samples.columns["t",]
    given = [
        sum((b - a) * (f + g) / 2 for (a, f), (b, g) in pairwise(zip(t, on, strict=True)))
        for on in (on_a, on_b)
    ]
    assert given[0] == pytest.approx(given[1], rel=0.02)  # read off between samples
    assert broken(done).momentum == 0.0
    assert walls < -10.0
