"""Many runs at once are the same runs: closed forms against the engine, one point at a time."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest

from sim.dynamics.batch.grid import MOST_RUNS, MOST_WITH_EFFECTS, changes_at, run_points, solve
from sim.dynamics.batch.impacts import impacts
from sim.dynamics.motion.impact import outgoing
from sim.laws.lookup import contact_law
from sim.scene.model import Contact
from tests import registry
from tests.dynamics.given.batch_points import FINITE, by_engine, spread

ULPS = 16
"""Units in the last place: numpy's logarithm, sine and exponential differ from Python's there."""


def close(value: float, expected: float, scale: float = 0.0) -> bool:
    return abs(value - expected) <= ULPS * 2.3e-16 * max(abs(expected), scale)


def test_velocities_are_those_of_the_scalar_formula_to_the_last_bit() -> None:
    dice = random.Random(5)
    rows = [
        (
            10 ** dice.uniform(-9, 9), 10 ** dice.uniform(-9, 9),
            dice.uniform(-3, 3), dice.uniform(-3, 3), dice.choice([0.0, 1.0, dice.random()]),
        )
        for _ in range(2_000)
    ]  # fmt: skip
    m1, m2, v1, v2, e = np.array(rows).T
    out = impacts("instant", m1, m2, v1, v2, e, None)
    assert [tuple(pair) for pair in zip(out.v1, out.v2, strict=True)] == [
        outgoing(*r) for r in rows
    ]


@pytest.mark.parametrize("law", FINITE)
def test_every_figure_of_a_law_is_that_of_one_contact(law: str) -> None:
    asked = [1.0, 0.99, 0.8, 0.5, math.exp(-2), 0.2, 1e-3, 1e-12, 1e-40]
    if not law.startswith("push-only"):
        asked.append(0.0)
    for k, mu, u in ((500.0, 0.5, 1.5), (3e7, 1e-4, 1e-3)):
        out = impacts(law, mu, None, u, 0.0, np.array(asked), k)
        for n, e in enumerate(asked):
            single = contact_law(Contact(law=law, restitution=e, stiffness=k))  # type: ignore[arg-type]
            assert single is not None
            figures = single.figures(mu)
            for got, expected in (
                (out.duration, figures.duration),
                (out.force, figures.peak_force * u),
                (out.overlap, figures.peak_overlap * u),
                (out.residual_overlap, figures.out_overlap * u),
                (out.impulse, mu * u * (1 + figures.e)),
                (out.warmed, 0.5 * mu * u * u * (1 - figures.e) * (1 + figures.e)),
            ):
                value = float(np.broadcast_to(got, len(asked))[n])
                # The corrected damping is the root of an equation: its error is that of the root.
                assert value == expected or math.isclose(value, expected, rel_tol=1e-13), (law, e)


def test_almost_every_point_of_two_carts_on_an_open_track_has_a_closed_form() -> None:
    plain = registry.plain("light-meets-heavy")
    axes = (("A.mass", spread(0.5, 5, 40)), ("contact.restitution", spread(0, 1, 40)))
    grid = solve(plain, axes, ("v", "B"))
    assert grid.left == ()
    assert grid.closed
    middle = changes_at(axes, 820)
    assert close(grid.values.ravel()[820], by_engine(plain, middle, ("v", "B")))


@pytest.mark.parametrize("e", [0.0, 1.0])
@pytest.mark.parametrize("law", ["bumper", "instant"])
def test_mass_ratios_of_a_million_million_million(law: str, e: float) -> None:
    stiff = {"stiffness": 1e12} if law == "bumper" else {}  # the heaviest part before the end
    plain = registry.two_carts(law=law, restitution=e, **stiff)
    axes = (("A.mass", (1e-9, 1.0, 1e9)), ("B.mass", (1e-9, 1.0, 1e9)))
    for show in (("v", "A"), ("v", "B")):
        grid = solve(plain, axes, show)
        assert grid.left == ()
        for point, value in enumerate(grid.values.ravel().tolist()):
            assert close(value, by_engine(plain, changes_at(axes, point), show), scale=1.5)


def test_where_nothing_touches_before_the_end_the_carts_keep_their_velocity() -> None:
    plain = registry.two_carts(until="0.3", law="bumper")  # they would touch at 0.4 s
    grid = solve(plain, (("A.mass", spread(1, 3, 9)),), ("v", "A"))
    assert grid.left == ()
    assert grid.values.tolist() == [[1.0] * 9]
    assert solve(plain, (("A.mass", spread(1, 3, 9)),), ("F", "A-B")).values.tolist() == [[0.0] * 9]


def test_a_contact_that_the_end_cuts_off_is_run() -> None:
    plain = registry.two_carts(law="bumper", stiffness=20)
    axes = (("until", (0.41, 0.45, 0.5)),)
    grid = solve(plain, axes, ("v", "A"))
    assert grid.left == (0, 1, 2)
    found = run_points(plain, grid, ("v", "A"), 0)
    assert found == [by_engine(plain, changes_at(axes, k), ("v", "A")) for k in range(3)]


def test_a_contact_that_never_ends_is_run() -> None:
    plain = registry.two_carts(law="paper", restitution=0)
    grid = solve(plain, (("A.mass", (1.0, 2.0)),), ("v", "A"))
    assert grid.left == (0, 1)


def test_a_second_contact_is_never_overlooked() -> None:
    """B rebounds from the wall: velocities of one contact would be wrong."""
    plain = registry.two_carts(law="bumper", until=4)
    plain["track"] = {"length": "2", "right": "wall"}
    axes = (("A.velocity", spread(0.0, 2.0, 21)),)
    grid = solve(plain, axes, ("v", "B"))
    once = solve({**plain, "track": {}}, axes, ("v", "B"))
    for point in range(21):
        expected = by_engine(plain, changes_at(axes, point), ("v", "B"))
        if point not in grid.left:
            assert close(grid.values[0, point], expected, scale=1.0)
        elif expected < 0.0:
            assert once.values[0, point] > 0.0
    assert len(grid.left) > 10


def test_more_carts_are_run_point_by_point_and_on_a_coarser_grid() -> None:
    plain = registry.plain("triple-hit")
    axes = (("A.velocity", spread(0.5, 1.5, 200)), ("C.velocity", spread(-1.5, -0.5, 200)))
    grid = solve(plain, axes, ("v", "B"))
    assert not grid.closed
    assert grid.coarser
    assert len(grid.left) == grid.values.size <= MOST_RUNS
    for (_, fewer), (_, all_of_them) in zip(grid.axes, axes, strict=True):
        assert set(fewer) <= set(all_of_them)
        assert (fewer[0], fewer[-1]) == (all_of_them[0], all_of_them[-1])
    (value,) = run_points(plain, grid, ("v", "B"), 77, seconds=0.0)
    assert value == by_engine(plain, changes_at(grid.axes, 77), ("v", "B"))


def test_a_grid_that_is_still_too_dear_once_it_is_coarser_is_made_coarser_again() -> None:
    plain = registry.plain("too-soft-bumpers")
    axes = (("A.velocity", spread(-1.0, 2.0, 200)), ("B.mass", spread(0.5, 5.0, 200)))
    grid = solve(plain, axes, ("v", "A"))
    assert grid.coarser
    assert 0.9 * MOST_RUNS < len(grid.left) <= MOST_RUNS


def test_runs_in_slices_are_all_the_runs() -> None:
    plain = registry.plain("triple-hit")
    grid = solve(plain, (("A.velocity", spread(0.5, 1.5, 7)),), ("warmed", ""))
    slices: list[float] = []
    while len(slices) < len(grid.left):
        slices += run_points(plain, grid, ("warmed", ""), len(slices), seconds=0.0)
    assert slices == run_points(plain, grid, ("warmed", ""), 0)


def test_a_point_that_makes_no_sense_has_no_value() -> None:
    plain = registry.two_carts(law="bumper")  # B stands at 0.8 m: A may not reach into it
    axes = (("A.position", (0.0, 0.5, 0.7)),)
    grid = solve(plain, axes, ("v", "A"))
    assert grid.left == (2,)
    assert all(map(math.isnan, run_points(plain, grid, ("v", "A"), 0)))


def test_values_of_one_pair_follow_only_that_pair() -> None:
    plain = registry.plain("stiff-and-soft")
    plain["until"] = "2"
    axes = (("contact.restitution", spread(0.2, 1, 9)),)
    grid = solve(plain, axes, ("v", "A"))
    assert grid.left == ()
    for point in range(9):
        expected = by_engine(plain, changes_at(axes, point), ("v", "A"))
        assert close(grid.values[0, point], expected, scale=1.0)


def test_effects_are_run_on_a_grid_that_a_page_can_bear() -> None:
    plain = registry.two_carts(law="bumper")
    plain["effects"] = [{"friction": {"coefficient": "0.02"}}]
    axes = (("A.velocity", spread(0.5, 1.5, 200)), ("A.mass", spread(0.5, 1.5, 200)))
    grid = solve(plain, axes, ("v", "B"))
    assert len(grid.left) == grid.values.size == MOST_WITH_EFFECTS
    (value,) = run_points(plain, grid, ("v", "B"), 123, seconds=0.0)
    assert value == by_engine(plain, changes_at(grid.axes, 123), ("v", "B"))


def test_the_greatest_force_of_a_spring_and_of_a_loose_one_is_that_of_hooke() -> None:
    """No event tells the one; the other tells it when it is let go."""
    touching = {
        "carts": {"A": {"mass": 0.5, "position": 0.6}, "B": {"mass": 1, "position": 0.8}},
        "track": {"length": 3}, "until": 1,
    }  # fmt: skip
    stiff = (10.0, 20.0, 40.0)
    loose = [{"release": {"between": ["A", "B"], "energy": 0.06, "stiffness": 10}}]
    apart = {"A": {"mass": 0.5, "position": 0.6}, "B": {"mass": 1, "position": 0.9}}
    spring = [{"spring": {"between": ["A", "B"], "stiffness": 10, "length": 0}}]
    for plain, target, expected in (
        (
            {**touching, "effects": loose},
            "release.stiffness",
            [(2 * 0.06 * k) ** 0.5 for k in stiff],
        ),
        (
            {**touching, "carts": apart, "until": 0.05, "effects": spring},
            "spring.stiffness",
            [0.1 * k for k in stiff],
        ),
    ):
        grid = solve(plain, ((target, stiff),), ("F", "A-B"))
        assert run_points(plain, grid, ("F", "A-B"), 0) == pytest.approx(expected, rel=1e-9)


def test_the_greatest_force_of_a_spring_is_where_it_turns_and_not_at_a_sample() -> None:
    """Two carts drive a stretched spring apart: √((k d)² + u² k μ), soon after the start."""
    plain = {
        "carts": {
            "A": {"mass": 0.5, "position": 0.6, "velocity": 0},
            "B": {"mass": 1, "position": 1.1, "velocity": 0.4},
        },
        "track": {"length": 5}, "until": 0.15,
        "effects": [{"spring": {"between": ["A", "B"], "stiffness": 10, "length": 0.1}}],
    }  # fmt: skip
    stiff = (11.0, 23.0, 47.0)
    grid = solve(plain, (("spring.stiffness", stiff),), ("F", "A-B"))
    expected = [math.hypot(0.2 * k, 0.4 * (k / 3) ** 0.5) for k in stiff]
    assert run_points(plain, grid, ("F", "A-B"), 0) == pytest.approx(expected, rel=1e-6)


def test_a_pair_that_nothing_pushes_has_no_force_beside_the_spring_of_another() -> None:
    plain = {
        "carts": {name: {"mass": 1, "position": k + 0.5} for k, name in enumerate("ABC")},
        "track": {"length": 5}, "until": 0.1,
        "effects": [{"spring": {"between": ["B", "C"], "stiffness": 10, "length": 0.3}}],
    }  # fmt: skip
    grid = solve(plain, (("spring.stiffness", (10.0, 20.0)),), ("F", "A-B"))
    assert run_points(plain, grid, ("F", "A-B"), 0) == [0.0, 0.0]
