"""Impacts without a duration that come at once, or in turn for ever, against plain arithmetic."""

from __future__ import annotations

import itertools
from fractions import Fraction
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.motion.hit_in_turn import at_once_for_ever, for_ever
from sim.dynamics.motion.locked import impulses
from sim.scene import read_scene

ROWS = {
    "three alike": ([1, 1, 1], [1, 1], [Fraction(1, 2)] * 2),
    "a light one between": ([2, Fraction(1, 10), 3], [1, 3], [Fraction(1, 5), 1]),
    "a wall on the left": ([None, 1, 4], [2, 1], [Fraction(3, 10), 0]),
    "five": ([1, 2, 3, 4, 5], [1, 1, 2, 1], [0, Fraction(1, 2), 1, Fraction(1, 4)]),
}


@pytest.mark.parametrize("what", ROWS)
def test_impulses_at_once_leave_each_pair_with_e_times_its_closing_speed(what: str) -> None:
    masses, closing, e = ROWS[what]
    inverse = [0.0 if m is None else float(1 / Fraction(m)) for m in masses]
    found = impulses(inverse, list(map(float, closing)), list(map(float, e)))
    assert min(found) >= 0.0
    change = [
        (left - right) * inv
        for inv, left, right in zip(inverse, [0.0, *found], [*found, 0.0], strict=True)
    ]
    opened = [b - a for a, b in itertools.pairwise(change)]
    assert opened == pytest.approx(
        [float((1 + one) * u) for one, u in zip(e, closing, strict=True)], rel=1e-14
    )


def rounds_end(masses: list[int], closing: list[int], e: Fraction, rounds: int) -> bool:
    """Do impacts in the two gaps in turn end? Exact fractions: no rounding decides."""
    m = [Fraction(one) for one in masses]
    passed_on = [m[0] / (m[0] + m[1]), m[2] / (m[1] + m[2])]
    u, k = [Fraction(one) for one in closing], 0
    for _ in range(rounds):
        if u[k] <= 0:
            return True
        u[1 - k] += (1 + e) * u[k] * passed_on[k]
        u[k] *= -e
        k = 1 - k
        u = [one.limit_denominator(10**30) for one in u]
    return False


@pytest.mark.parametrize("masses", [[1, 1, 1], [1, 5, 1], [5, 1, 3], [1, 2, 30]])
@pytest.mark.parametrize("closing", [[1, 0], [1, -2], [1, 1]])
@pytest.mark.parametrize("e", ["0.02", "0.07", "0.08", "0.2", "0.5", "0.9"])
def test_three_are_hit_in_turn_for_ever_where_exact_rounds_do_not_end(
    masses: list[int], closing: list[int], e: str
) -> None:
    told = for_ever([1.0 / m for m in masses], list(map(float, closing)), [float(e)] * 2)
    assert told is not rounds_end(masses, closing, Fraction(e), 60)


def test_for_ever_whichever_is_first_asks_both_sides() -> None:
    assert at_once_for_ever([1.0, 1.0, 1.0], [1.0, 1.0], [0.05, 0.05])
    assert not at_once_for_ever([1.0, 1.0, 1.0], [1.0, 1.0], [0.3, 0.3])
    assert not at_once_for_ever([1.0, 0.0, 1.0], [1.0, 1.0], [0.0, 0.0])


TIGHT = {"A": {"mass": 1, "position": "0.1", "velocity": 1, "length": "0.2"}}
TWO_TIGHT = TIGHT | {"B": {"mass": 3, "position": "0.3", "velocity": -1, "length": "0.2"}}


@pytest.mark.parametrize(("carts", "length"), [(TIGHT, "0.2"), (TWO_TIGHT, "0.4")])
@pytest.mark.parametrize("restitution", [1, 0.5])
def test_carts_without_room_between_two_walls_rattle_to_rest_or_are_told_to_have_no_end(
    carts: dict[str, Any], length: str, restitution: float
) -> None:
    """Where nothing is lost the rounds come again with the same speeds: no million of them."""
    found = run(
        read_scene({
            "carts": carts, "track": {"left": "wall", "right": "wall", "length": length},
            "contact": {"law": "instant", "restitution": restitution}, "until": 1,
        })
    )  # fmt: skip
    assert len(found.record.events) < 2000
    if restitution == 1:
        assert found.outcome.kind == "too-many-events"
        assert "without room between what is hit in turn for ever" in found.outcome.sentence
    else:
        assert found.outcome.kind == "came-to-rest"


def test_a_light_cart_between_a_heavy_one_and_a_wall_has_many_impacts_and_an_end() -> None:
    """As many as pi divided by the angle: 4e6 to 1 gives 6283 (Galperin 2003), and no round is
    ever quite the same."""
    found = run(
        read_scene({
            "carts": {
                "A": {"mass": 4e6, "position": "0.1", "velocity": 1, "length": "0.2"},
                "B": {"mass": 1, "position": "0.3", "length": "0.2"},
            },
            "track": {"right": "wall", "length": "0.4"},
            "contact": {"law": "instant", "restitution": 1}, "until": 1,
        })
    )  # fmt: skip
    assert found.outcome.kind == "reached-end"
    assert sum(event.kind == "contact" for event in found.record.events) == 6283


FAINT = 1e-9
"""N/m. What such a spring does in a second is no more than `FAINT` of any velocity."""


def touching_three(v: tuple[float, ...], *springs: tuple[str, str], e: float) -> dict[str, Any]:
    """Three carts that touch, the last one heavier."""
    bodies = zip("ABC", (1.0, 1.0, 4.0), (0.6, 0.8, 1.0), v, strict=True)
    return {
        "carts": {n: {"mass": m, "position": x, "velocity": u} for n, m, x, u in bodies},
        "track": {"left": "open", "right": "open"},
        "contact": {"law": "instant", "restitution": e},
        "effects": [
            {"spring": {"between": list(pair), "stiffness": FAINT, "length": 0.3}}
            for pair in springs
        ],
        "until": 1,
    }


@pytest.mark.parametrize("e", [1, 0.5, 0])
@pytest.mark.parametrize("v", [(1, 0.2, 0), (1, 0.8, 0), (1, 0.5, 0), (1, 0, -1)])
@pytest.mark.parametrize("springs", [["AB"], ["BC"], ["AB", "BC"]], ids="+".join)
def test_a_spring_that_is_nearly_nothing_leaves_the_order_of_impacts_as_it_is(
    v: tuple[float, ...], springs: list[str], e: float
) -> None:
    """Those that close fastest are struck first, springs between them or not."""
    pairs = [(one[0], one[1]) for one in springs]
    held = run(read_scene(touching_three(v, *pairs, e=e)))
    assert held.v == pytest.approx(run(read_scene(touching_three(v, e=e))).v, abs=10 * FAINT)
