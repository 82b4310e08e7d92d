"""What happens in worlds that do not exist, against runs that move so for other reasons."""

from __future__ import annotations

import math
from copy import deepcopy
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.outcome import UnsolvedError
from sim.lesson.beliefs import BELIEFS
from sim.scene.said import Said
from sim.worlds import follow
from sim.worlds.breaks import broken
from sim.worlds.describe import kinds
from tests.worlds.scenes import (
    HEAVY_INTO_LIGHT,
    LIGHT_INTO_HEAVY,
    PAIRS,
    followed,
    scene,
)

STEPS = 1e-7
"""m/s, m. What located steps may be off by."""

SHARED = {
    "bigger-pushes-more": lambda a, b: (2 * b / (a + b), 2 * a / (a + b)),
    "own-mass-own-force": lambda a, b: (2 * a / (a + b), 2 * b / (a + b)),
}


@pytest.mark.parametrize("kind", kinds().values(), ids=lambda kind: kind.name)
def test_every_world_is_impossible_and_names_a_belief(kind: Any) -> None:
    assert kind.impossible
    assert kind.belief in BELIEFS


@pytest.mark.parametrize("plain", PAIRS.values(), ids=PAIRS)
@pytest.mark.parametrize("world", SHARED)
def test_pushes_in_a_fixed_ratio_move_carts_as_other_masses_would(
    world: str, plain: dict[str, Any]
) -> None:
    """a = α N/m is a = N/(m/α): the exact run of carts of mass m/α moves just so."""
    other = deepcopy(plain)
    masses = [cart["mass"] for cart in plain["carts"].values()]
    shares = dict(zip("AB", SHARED[world](*masses), strict=True))
    for name, share in shares.items():
        other["carts"][name]["mass"] /= share
    if "effects" in other:  # the air pulls as in ours: on a cart of mass m/α by b/α
        other["effects"] = [
            {"drag": {"linear": 0.05 / share, "carts": [name]}} for name, share in shares.items()
        ]
    expected, done = run(scene(other)), followed(plain, world).run
    assert done.v == pytest.approx(expected.v, abs=STEPS)
    assert done.x == pytest.approx(expected.x, abs=STEPS)


def test_a_mover_feels_nothing_of_a_cart_at_rest_and_throws_it_ahead() -> None:
    done = followed(HEAVY_INTO_LIGHT, "mover-pushes-more").run
    assert done.v == pytest.approx((0.4, 0.4 * 1.8), abs=STEPS)


@pytest.mark.parametrize("world", ["bigger-pushes-more", "own-mass-own-force", "mover-pushes-more"])
def test_between_a_cart_and_a_wall_a_world_of_pairs_is_as_ours(world: str) -> None:
    """A wall stands still and weighs nothing that could be compared: a cart went through it."""
    plain = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.3},
            "B": {"mass": 1.0, "position": 1.0, "velocity": 0.6},
        },
        "track": {"right": "wall", "length": 2.0},
        "contact": {"law": "bumper", "stiffness": 200.0},
        "until": 2.0,
    }
    assert followed(plain, world).run.v == pytest.approx((0.0, -0.6), abs=STEPS)


def test_walls_that_cannot_push_are_walls_that_are_not_there() -> None:
    plain = HEAVY_INTO_LIGHT | {"track": {"right": "wall", "length": 1.6}}
    open_ended, done = run(scene(HEAVY_INTO_LIGHT)), followed(plain, "passive-cannot-push").run
    assert done.x == pytest.approx(open_ended.x, abs=STEPS)
    assert done.x[1] > 1.6


@pytest.mark.parametrize(
    ("world", "time"), [("force-carried-along", 1.0), ("motion-needs-force", 0.1)]
)
def test_velocity_without_a_push_fades_as_in_a_drag_of_nothing(world: str, time: float) -> None:
    plain = {"carts": {"A": {"mass": 0.5, "position": 0.4, "velocity": 0.6}}, "until": 2.0}
    done = followed(plain, world).run
    assert done.v[0] == pytest.approx(0.6 * math.exp(-2.0 / time), abs=STEPS)
    assert done.x[0] == pytest.approx(0.4 + 0.6 * time * (1 - math.exp(-2.0 / time)), abs=1e-5)


@pytest.mark.parametrize(
    ("stops", "until"),
    [(0.1, 0.3), (0.1, 20.0), (0.1, 60.0), (0.1, 80.0), (0.005, 3.0), (0.004, 3.0), (0.001, 3.0)],
)
def test_velocity_fades_to_nothing_however_long_a_run_and_however_soon_a_thing_stops(
    stops: float, until: float
) -> None:
    """Steps of a part of the run made 1e65 m/s and more of 0.6 m/s."""
    plain = {"carts": {"A": {"mass": 0.5, "position": 0.4, "velocity": 0.6}}, "until": until}
    done = followed(plain, {"motion-needs-force": {"stops": stops}}).run
    gone = 0.5 * 0.5 * 0.6**2 * (1.0 - math.exp(-2.0 * until / stops))
    assert done.v[0] == pytest.approx(0.6 * math.exp(-until / stops), abs=STEPS)
    assert done.x[0] == pytest.approx(0.4 + 0.6 * stops * (1 - math.exp(-until / stops)), abs=STEPS)
    assert done.ledger.works["motion-needs-force"] == pytest.approx(-gone, abs=STEPS)


@pytest.mark.parametrize(
    "held", [{"drag": {"linear": 4.0}}, {"spring": {"stiffness": 0.001, "damping": 4.0}}]
)
def test_what_slows_carts_down_in_ours_does_so_in_a_world_too(held: dict[str, Any]) -> None:
    """1/τ is 40 per second and more; until 20 s a step of a part of the run is 80 ms.

    Bumpers and spring are so soft that they do not make steps short: what fades alone does. The
    carts do not come to touch; their spring moves them as it would move other masses.
    """
    world, (kind, numbers) = "bigger-pushes-more", next(iter(held.items()))
    more = {"between": ["A", "B"], "length": 0.5} if kind == "spring" else {}
    plain = {
        "carts": {
            "A": {"mass": 0.1, "position": 0.4, "velocity": 0.6},
            "B": {"mass": 0.3, "position": 1.2},
        },
        "contact": {"stiffness": 0.001},
        "effects": [{kind: numbers | more}],
        "until": 20.0,
    }
    other: dict[str, Any] = deepcopy(plain)
    if kind == "spring":
        for cart, share in zip(other["carts"].values(), SHARED[world](0.1, 0.3), strict=True):
            cart["mass"] /= share
    done, ours = followed(plain, world).run, run(scene(other))
    assert done.v == pytest.approx(ours.v, abs=STEPS)
    assert done.x == pytest.approx(ours.x, abs=STEPS)
    assert all(abs(v) < 1.0 for v in done.v)


def test_a_run_beyond_all_numbers_is_refused_and_not_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(follow, "REACH", 1e3)
    monkeypatch.setattr(follow, "FADING", math.inf)
    plain = {"carts": {"A": {"mass": 0.5, "position": 0.4, "velocity": 0.6}}, "until": 900.0}
    with pytest.raises(UnsolvedError, match="does not come to its end") as caught:
        followed(plain, "motion-needs-force")
    assert isinstance(caught.value.message, Said)


def test_velocity_follows_the_push_where_motion_needs_force() -> None:
    """v = τ F/m while the hand pushes, nought soon after."""
    plain = {
        "carts": {"A": {"mass": 0.5, "position": 0.4}},
        "effects": [{"push": {"cart": "A", "force": 0.8, "until": 2.0}}],
        "until": 4.0,
    }
    done = followed(plain, {"motion-needs-force": {"stops": "100 ms"}})
    v = done.samples.columns["v", "A"]
    assert max(v) == pytest.approx(0.1 * 0.8 / 0.5, rel=1e-6)
    assert v[-1] == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("until", [0.1, 10.0])
def test_where_both_stand_the_one_that_is_pushed_harder_pushes_harder(until: float) -> None:
    """3 N press B against A, 2 N press A: A feels 3/2 of what B feels."""
    plain = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.4, "length": 0.2},
            "B": {"mass": 2.0, "position": 0.6, "length": 0.2},
        },
        "contact": {"stiffness": 200},
        "effects": [{"push": {"cart": "A", "force": 2}}, {"push": {"cart": "B", "force": -3}}],
        "until": until,
    }
    columns = followed(plain, "mover-pushes-more").samples.columns
    pairs = zip(columns["on", "A-B", "A"], columns["on", "A-B", "B"], strict=True)
    for on_a, on_b in pairs:
        assert on_a == pytest.approx(1.5 * on_b, rel=1e-9)


@pytest.mark.parametrize("plain", PAIRS.values(), ids=PAIRS)
@pytest.mark.parametrize("world", [name for name, kind in kinds().items() if kind.needs != "wall"])
def test_accounts_close_with_what_came_from_nowhere_under_the_worlds_name(
    world: str, plain: dict[str, Any]
) -> None:
    books = followed(plain, world).run.ledger
    given = math.fsum(books.works.values())
    assert books.energy_final + books.warmed == pytest.approx(
        books.energy_initial + given, abs=1e-6
    )
    assert books.momentum_final == pytest.approx(books.momentum_initial + books.external, abs=1e-9)
    assert abs(books.works[world]) > 1e-3


def test_equal_carts_do_not_notice_that_heavier_ones_would_push_harder() -> None:
    plain = deepcopy(HEAVY_INTO_LIGHT)
    plain["carts"]["B"]["mass"] = 2.0
    done, ours = followed(plain, "bigger-pushes-more"), run(scene(plain))
    assert done.run.v == pytest.approx(ours.v, abs=STEPS)
    assert broken(done).momentum == 0.0
    assert broken(done).energy == 0.0


@pytest.mark.parametrize("world", [name for name, kind in kinds().items() if kind.needs != "wall"])
def test_observers_disagree_in_just_those_worlds_whose_law_names_a_velocity(world: str) -> None:
    found = broken(followed(LIGHT_INTO_HEAVY, world))
    assert (found.observers is not None) == kinds()[world].moves


def test_two_carts_tied_by_a_spring_run_away_for_ever() -> None:
    """Magnets push the light one harder, the spring pulls both alike: a net force, from nowhere."""
    gap, force, stiffness = 0.05, 1.0, 20.0  # m, N of the magnets there, N/m of the spring
    magnets = {"between": ["A", "B"], "strength": force * gap**3}
    spring = {"between": ["A", "B"], "stiffness": stiffness, "length": 0.0}
    plain = {
        "carts": {
            "A": {"mass": 1.5, "position": 0.4, "length": 0.2},
            "B": {"mass": 0.5, "position": 0.4 + 0.2 + gap, "length": 0.2},
        },
        "effects": [{"magnets": magnets}, {"spring": spring}],
    }
    ends = [
        followed(plain | {"until": until}, "bigger-pushes-more").run.ledger.momentum_final
        for until in (0.75, 1.5)
    ]
    assert ends[0] > 0.25
    assert ends[1] / ends[0] == pytest.approx(2.0, rel=0.05)
    assert run(scene(plain | {"until": 1.5})).v == pytest.approx((0.0, 0.0), abs=1e-9)
