"""What a page says of the laws that a world breaks: true of its run, in words of a lesson."""

from __future__ import annotations

from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest
import yaml

from sim.scene import read_fence
from sim.worlds.breaks import Broken, broken
from sim.worlds.describe import kinds
from sim.worlds.follow import follow
from sim.worlds.sentences import speed
from tests.worlds.scenes import HEAVY_INTO_LIGHT, LIGHT_INTO_HEAVY, followed

LESSON = Path(__file__).parents[2] / "worksheets" / "newtons-first-law.md"
MOVING = [name for name, kind in kinds().items() if kind.moves]


def lesson_scene(name: str) -> Any:
    """A scene of the lesson, as it stands there."""
    for block in LESSON.read_text(encoding="utf-8").split("```scene\n")[1:]:
        plain = yaml.safe_load(block.split("```")[0])
        if plain["id"] == name:
            return plain
    raise LookupError(name)


def two(left: tuple[float, float], right: tuple[float, float], **more: Any) -> dict[str, Any]:
    """Mass and velocity of each."""
    cart_a = {"mass": left[0], "position": 0.4, "velocity": left[1]}
    cart_b = {"mass": right[0], "position": 1.2, "velocity": right[1]}
    return {**HEAVY_INTO_LIGHT, "carts": {"A": cart_a, "B": cart_b}, **more}


def found(plain: dict[str, Any], world: object) -> Broken:
    return broken(followed(plain, world))


@pytest.mark.parametrize("index", [0, 1], ids=["force-carried-along", "motion-needs-force"])
def test_what_a_hand_gave_and_a_world_took_is_gone_and_did_not_come_from_nowhere(
    index: int,
) -> None:
    """The scene of the first law: from rest, so at its end there is more than at its start."""
    fence = read_fence(lesson_scene("nothing-pushes"), named=True)
    done = follow(fence.scene, fence.worlds[index])
    assert done.run.ledger.momentum_final > done.run.ledger.momentum_initial >= 0.0
    assert "of momentum are gone" in broken(done).sentences[0]


def test_momentum_that_was_turned_round_is_neither_gone_nor_from_nowhere_alone() -> None:
    """−0.8 N s become more than nought; no more than 0.8 N s were there to be gone."""
    done = followed(two((1.0, 0.4), (3.0, -0.4)), "own-mass-own-force")
    assert done.run.ledger.momentum_final > 0.0 > done.run.ledger.momentum_initial
    (first, *_) = broken(done).sentences
    assert "to the right came from no body" in first
    assert "gone" not in first


def test_a_cart_that_a_wall_turned_round_got_nothing_along_its_way() -> None:
    plain = {
        "carts": {"A": {"mass": 0.5, "position": 0.4, "velocity": 0.6}},
        "track": {"right": "wall", "length": 0.8},
        "until": 3.0,
    }
    assert "came from nowhere" not in found(plain, "force-carried-along").sentences[0]


@pytest.mark.parametrize(
    ("plain", "world"),
    [
        (two((0.5, 0.4), (0.5, 0.0)), "bigger-pushes-more"),
        (two((0.5, 0.4), (0.5, 0.0)), "own-mass-own-force"),
        (two((2.0, 0.1), (0.5, 0.3)), "bigger-pushes-more"),
        (two((2.0, 0.0), (0.5, 0.0)), "mover-pushes-more"),
        (two((2.0, 0.1), (0.5, 0.3)), "reaction-comes-later"),
    ],
)
def test_where_nothing_breaks_a_reader_is_told_so_and_what_to_change(
    plain: dict[str, Any], world: str
) -> None:
    (sentence,) = found(plain, world).sentences
    assert sentence.startswith("With these values nothing breaks")
    assert "as if nothing were there" not in sentence


def test_only_walls_that_cannot_push_let_things_go_on_as_if_nothing_were_there() -> None:
    plain = HEAVY_INTO_LIGHT | {"track": {"right": "wall", "length": 1.6}}
    assert "as if nothing were there" in found(plain, "passive-cannot-push").sentences[0]
    said = [kind.name for kind in kinds().values() if "as if nothing" in kind.nothing]
    assert said == ["passive-cannot-push"]


@pytest.mark.parametrize(
    "effect",
    [{"friction": {"coefficient": 0.05}}, {"drag": {"linear": 0.3}}, {"drag": {"quadratic": 0.5}}],
)
@pytest.mark.parametrize("world", MOVING)
def test_observers_are_not_asked_where_the_ground_itself_acts(
    world: str, effect: dict[str, Any]
) -> None:
    """Friction and air at rest stand on the ground: two would disagree in our world as well."""
    plain = deepcopy(HEAVY_INTO_LIGHT) | {"effects": [effect]}
    plain["carts"]["A"]["velocity"] = 0.1
    assert found(plain, world).observers is None


def test_observers_are_asked_where_a_hand_pushes() -> None:
    push = {"push": {"cart": "A", "force": 0.4, "until": 1.0}}
    assert found(HEAVY_INTO_LIGHT | {"effects": [push]}, "motion-needs-force").observers is not None


@pytest.mark.parametrize(
    ("mass", "told"), [(150_000.0, "19000 N s"), (4e7, "5.1 × 10⁶ N s"), (0.02, "0.0025 N s")]
)
def test_amounts_are_written_out_as_a_lesson_writes_numbers(mass: float, told: str) -> None:
    plain = two((mass, 0.4), (mass / 4, 0.0), contact={"restitution": 0.8, "stiffness": 50 * mass})
    assert told in found(plain, "bigger-pushes-more").sentences[0]


def test_what_the_train_computes_is_told_as_the_ground_sees_it() -> None:
    """A train measures other velocities in every world; they are no disagreement."""
    said = found(LIGHT_INTO_HEAVY, "mover-pushes-more")
    assert said.observers is not None
    cart, ground, train = said.observers
    sentence = next(one for one in said.sentences if one.startswith("Two observers disagree."))
    assert f"from the ground, {cart} ends with {speed(ground)}." in sentence
    assert f"train's velocity added back at the end, {cart} ends with {speed(train)}." in sentence
